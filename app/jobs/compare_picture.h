/// The pictures and the page of `rimpact compare -o DIR`.
#pragma once
#include "responses/response.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

/// One of the responses compared, the first being the reference.
struct ComparedCurve {
  std::string name;    ///< A, B, ...
  std::string scene;   ///< its text, resolved; empty: not known
  nlohmann::json said; ///< path, metrics, differences and notes, as report/compare.py reads them
  const Response *response = nullptr;
};
/// Writes DIR/compare.json, DIR/curves/A ... as run folders, DIR/figures/*.png and DIR/compare.html, whose path it
/// gives. `capacity`: L_c [m]. Throws IoError.
std::string draw_comparison(const std::string &folder, const std::vector<ComparedCurve> &curves, double capacity);

} // namespace rimpact::app
