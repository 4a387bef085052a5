#include "scene/fitted_plates.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {

FittedPlates plates_of(const Bearing &bearing) {
  return {.radius = bearing.surface.R0,
          .slider_height = bearing.slider.height,
          .slider_diameter = bearing.slider.diameter,
          .rim_height = bearing.rim.height,
          .capacity = bearing.lateral_capacity()};
}

std::string plate_differences(const FittedPlates &fitted, const Isolator &isolator) {
  constexpr double rounding = 0.005; // of numbers as they are typed in
  std::string text;
  const auto compare = [&](const char *key, double own, const std::optional<double> &there, double unit) {
    if (!there || std::abs(own - *there) <= rounding * *there) return;
    text += fmt::format("{}{} {:.4g} ({:.4g} there)", text.empty() ? "" : ", ", key, own / unit, *there / unit);
  };
  compare("isolator.radius_m", isolator.radius, fitted.radius, 1);
  if (isolator.top_radius) compare("isolator.top_radius_m", *isolator.top_radius, fitted.radius, 1);
  compare("isolator.top_height_mm + bottom_height_mm", isolator.slider_height(), fitted.slider_height, 1e-3);
  compare("isolator.slider_diameter_mm", isolator.slider_diameter, fitted.slider_diameter, 1e-3);
  compare("isolator.rim_height_mm", isolator.rim_height, fitted.rim_height, 1e-3);
  compare("isolator.capacity_m", isolator.capacity, fitted.capacity, 1);
  if (isolator.top_capacity) compare("isolator.top_capacity_m", *isolator.top_capacity, fitted.capacity, 1);
  return text;
}

} // namespace rimpact::scene
