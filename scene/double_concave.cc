#include "scene/double_concave.h"
#include "scene/error.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::scene {

double DoubleConcave::rim_tilt() const {
  return std::asin(capacity / effective_radius());
}

double DoubleConcave::edge_angle() const {
  return std::asin(slider_diameter / (2 * radius));
}

double DoubleConcave::rim_radius() const {
  return radius * std::sin(rim_tilt() + edge_angle());
}

namespace {

void require(bool holds, const char *key, double value, const std::string &bound) {
  if (!holds) throw InputError(fmt::format("isolator.{} {} {}", key, value, bound));
}

void check_shape(const DoubleConcave &b) {
  const double mm = 1e3, half = b.slider_diameter / 2;
  require(half < b.radius, "slider_diameter_mm", mm * b.slider_diameter,
          fmt::format("must be below 2 R = {} mm", 2 * mm * b.radius));
  const double sagitta = b.radius - std::sqrt(b.radius * b.radius - half * half);
  for (const auto &[key, height] : {std::pair{"top_height_mm", b.top_height}, {"bottom_height_mm", b.bottom_height}})
    require(height > sagitta, key, mm * height,
            fmt::format("must exceed {:.4g} mm, the depth of its curved face", mm * sagitta));
  require(b.effective_radius() > 0, "radius_m", b.radius,
          fmt::format("must exceed half the slider's height, {} m", b.slider_height() / 2));
  require(b.capacity < b.effective_radius(), "capacity_m", b.capacity,
          fmt::format("must be below R_eff = {} m", b.effective_radius()));
  require(b.rim_tilt() + b.edge_angle() < std::numbers::pi / 2, "capacity_m", b.capacity,
          "takes the slider's edge past the sphere's equator");
}

void check_points(const DoubleConcave &b) {
  const bool planar = b.space == "planar";
  require(b.points >= (planar ? 2 : 3), "points", b.points,
          planar ? "must be at least 2 in the plane" : "must be at least 3 in space");
  if (planar && b.plate_rotation != "fixed")
    throw InputError("isolator.plate_rotation \"free\" needs isolator.space = \"spatial\"");
}

} // namespace

void DoubleConcave::validate(bool impact_resilient) const {
  check_shape(*this);
  check_points(*this);
  if (!impact_resilient) return;
  const double mm = 1e3;
  require(top_wall < slider_diameter / 2, "top_wall_mm", mm * top_wall,
          fmt::format("leaves no interface in a slider of radius {} mm", mm * slider_diameter / 2));
  require(bottom_wall <= top_wall, "bottom_wall_mm", mm * bottom_wall,
          fmt::format("exceeds isolator.top_wall_mm {}: the interface has no gap", mm * top_wall));
}

} // namespace rimpact::scene
