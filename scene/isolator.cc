#include "scene/isolator.h"
#include "io/files/error.h"
#include "scene/spherical_cap.h"
#include "scene/triple_pendulum.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::scene {

namespace {

double angle_of_edge(const Isolator &b, double R) {
  return std::asin(b.slider_diameter / (2 * R));
}

double rim_radius(const Isolator &b, double R, double capacity) {
  if (b.rim_place == RimPlace::approximate)
    return (capacity + b.slider_diameter + b.slider_height() * capacity / b.effective_radius()) / 2;
  return R * std::sin(std::asin(capacity / b.effective_radius()) + angle_of_edge(b, R));
}

} // namespace

double Isolator::rim_tilt() const {
  return std::asin(lateral_capacity() / effective_radius());
}
double Isolator::edge_angle() const {
  return angle_of_edge(*this, radius);
}
double Isolator::top_edge_angle() const {
  return angle_of_edge(*this, upper_radius());
}
double Isolator::bottom_rim_radius() const {
  return rim_radius(*this, radius, capacity);
}
double Isolator::top_rim_radius() const {
  return rim_radius(*this, upper_radius(), upper_capacity());
}

namespace {

void bounded(bool holds, const char *key, double value, const std::string &bound) {
  if (!holds) throw InputError(fmt::format("isolator.{} {:.6g} {}", key, value, bound));
}

struct PlateKeys {
  const char *height_key, *capacity_key;
  double R, height, capacity;
};

void check_shape(const Isolator &b) {
  const double mm = 1e3, half = b.slider_diameter / 2;
  const PlateKeys plates[] = {{"bottom_height_mm", "capacity_m", b.radius, b.bottom_height, b.capacity},
                              {"top_height_mm", b.top_capacity ? "top_capacity_m" : "capacity_m", b.upper_radius(),
                               b.top_height, b.upper_capacity()}};
  for (const auto &p : plates) {
    bounded(half < p.R, "slider_diameter_mm", mm * b.slider_diameter,
            fmt::format("must be below 2 R = {:.6g} mm", 2 * mm * p.R));
    const double sagitta = cap_height(p.R, half);
    bounded(p.height > sagitta, p.height_key, mm * p.height,
            fmt::format("must exceed {:.4g} mm, the depth of its curved face", mm * sagitta));
  }
  bounded(b.effective_radius() > 0, "radius_m", b.radius,
          fmt::format("must exceed half the slider's height, {:.6g} m", b.slider_height() / 2));
  for (const auto &p : plates) {
    bounded(p.capacity < b.effective_radius(), p.capacity_key, p.capacity,
            fmt::format("must be below R_eff = {:.6g} m", b.effective_radius()));
    bounded(std::asin(p.capacity / b.effective_radius()) + angle_of_edge(b, p.R) < std::numbers::pi / 2, p.capacity_key,
            p.capacity, "takes the slider's edge past the sphere's equator");
  }
}

void check_points(const Isolator &b) {
  const bool planar = b.space == Space::planar;
  bounded(b.points >= (planar ? 2 : 3), "points", b.points,
          planar ? "must be at least 2 in the plane" : "must be at least 3 in space");
  if (planar && b.plate_rotation != PlateRotation::fixed)
    throw InputError("isolator.plate_rotation \"free\" needs isolator.space = \"spatial\"");
}

} // namespace

void Isolator::validate(ModelKind model) const {
  check_points(*this);
  if (model == ModelKind::tfp) return validate_triple(*this);
  check_shape(*this);
  if (model != ModelKind::lir_dcfp) return;
  const double mm = 1e3;
  bounded(top_wall < slider_diameter / 2, "top_wall_mm", mm * top_wall,
          fmt::format("leaves no interface in a slider of radius {:.6g} mm", mm * slider_diameter / 2));
  bounded(bottom_wall <= top_wall, "bottom_wall_mm", mm * bottom_wall,
          fmt::format("exceeds isolator.top_wall_mm {:.6g}: the interface has no gap", mm * top_wall));
}

} // namespace rimpact::scene
