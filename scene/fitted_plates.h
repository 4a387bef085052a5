/// The plates between which the law of a double concave bearing's rims was fitted, in the numbers that [bearing] and
/// [isolator] both have. The rigid bodies take that law with a rim of their own: these tell whether it is the same one.
#pragma once
#include "scene/bearing.h"
#include "scene/isolator.h"
#include <optional>
#include <string>

namespace rimpact::scene {

/// [m]; none: not known.
struct FittedPlates {
  std::optional<double> radius = {}; ///< R of the dishes
  std::optional<double> slider_height = {}, slider_diameter = {}, rim_height = {};
  std::optional<double> capacity = {}; ///< displacement at which both rims are touched
  bool operator==(const FittedPlates &) const = default;
};

/// Of a bearing with two dishes.
FittedPlates plates_of(const Bearing &bearing);
/// Where either plate of a DCFP or LIR-DCFP is another by more than 0.5 %: "isolator.radius_m 0.8 (0.75 there), ...";
/// empty where none is. A double concave bearing has two plates alike.
std::string plate_differences(const FittedPlates &fitted, const Isolator &isolator);

} // namespace rimpact::scene
