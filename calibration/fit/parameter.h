/// The catalogue of parameters a fit may move: those of the impact laws, and one line each in parameter.cc.
#pragma once
#include "scene/scene.h"
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace rimpact::calibration {

struct Parameter {
  std::string name;                                      ///< as on the command line and in calibration.json
  std::string unit;                                      ///< of the reported value
  std::string toml_key;                                  ///< where a scene file holds it
  double si;                                             ///< reported value times this is SI
  double lower, upper;                                   ///< default bounds, in the reported unit
  bool logarithmic;                                      ///< fitted by its logarithm
  bool seen_in_flight;                                   ///< the motion before the first touch informs on it
  std::function<double(const scene::Scene &)> get;       ///< SI
  std::function<void(scene::Scene &, double value)> set; ///< SI
  /// What a fit moves in place of a reported value, and back.
  double to_variable(double reported) const { return logarithmic ? std::log(reported) : reported; }
  double to_reported(double variable) const { return logarithmic ? std::exp(variable) : variable; }
};
inline constexpr const char *no_unit = "-";
const std::vector<Parameter> &parameter_catalogue();
/// Throws InputError naming the known parameters and the nearest.
const Parameter &parameter(const std::string &name);

/// " kN/m", to stand behind a number; empty for "-", a number without a unit.
std::string unit_behind(const std::string &unit);

} // namespace rimpact::calibration
