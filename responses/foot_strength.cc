#include "responses/foot_strength.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact {
namespace {

using scene::ConnectionKind;

double mean_radius(const scene::Bearing &b) {
  return b.wall_radius() + b.rim.thickness / 2;
}

double pitch(const scene::RimConnection &c) {
  return std::numbers::pi * c.circle / c.number;
}

double bolts_use(const scene::Bearing &b, const FootLine &line) {
  const scene::RimConnection &c = b.rim.connection;
  const double offset = c.circle / 2 - mean_radius(b), half = b.rim.thickness / 2;
  const double lever = half + (line.moment >= 0 ? -offset : offset);
  const double tension = pitch(c) * std::max(0.0, std::abs(line.moment) + line.normal * half) / lever;
  const double shear = pitch(c) * std::hypot(line.shear, line.along);
  const double strength = ultimate_strength(c.grade) * stress_area(c.size) / c.partial_factor;
  constexpr double k2 = 0.9, combined = 1.4;
  const double of_tension = tension / (k2 * strength);
  return std::max(of_tension, shear / (shear_share(c.grade) * strength) + of_tension / combined);
}

} // namespace

double weld_force(const FootLine &line, double thickness) {
  const double along_the_wall = std::abs(line.normal) / 2 + std::abs(line.moment) / thickness;
  return std::hypot(along_the_wall, line.shear / 2, line.along / 2);
}

double weld_strength(const scene::RimConnection &c) {
  return c.strength / (std::numbers::sqrt3 * c.correlation * c.partial_factor);
}

std::optional<double> foot_use(const scene::Bearing &b, const FootLine &line) {
  const scene::RimConnection &c = b.rim.connection;
  switch (c.kind) {
  case ConnectionKind::monolithic:
    break;
  case ConnectionKind::fillet:
    return weld_force(line, b.rim.thickness) / (c.throat * weld_strength(c));
  case ConnectionKind::bolts:
    return bolts_use(b, line);
  }
  return {};
}

double foot_reach(const scene::Bearing &b) {
  const scene::RimConnection &c = b.rim.connection;
  return c.kind == ConnectionKind::bolts ? std::max(b.rim.thickness, pitch(c)) : b.rim.thickness;
}

} // namespace rimpact
