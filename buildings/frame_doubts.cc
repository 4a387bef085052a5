#include "buildings/frame_doubts.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::buildings {
namespace {

/// Wide enough for timber and steel, sheds and stores: what lies outside is rather a unit.
struct Usual {
  const char *what, *unit;
  double low, high;
};
constexpr Usual modulus{"E", "GPa", 3, 300}, depth{"depth", "m", 0.03, 5}, storey{"height", "m", 1.5, 30},
    mass_over_area{"mass over its plan", "kg/m2", 50, 1e4}, mass_over_length{"mass over its length", "kg/m", 100, 2e5},
    damping{"damping_ratio", "", 0, 0.2};

void doubt(std::vector<std::string> &found, const std::string &of, const Usual &usual, double value) {
  if (value >= usual.low && value <= usual.high) return;
  found.push_back(fmt::format("{}: {} = {:.4g}{}{}, where {:g} to {:g} is usual: are the units right?", of, usual.what,
                              value, *usual.unit ? " " : "", usual.unit, usual.low, usual.high));
}

/// Extent of a slab's nodes and height of its middle [m].
struct Plan {
  Eigen::Vector2d sides;
  double height;
};

Plan plan_of(const Frame &frame, const Diaphragm &slab) {
  Eigen::Vector3d low = frame.nodes[slab.nodes.front()].at, high = low;
  for (const int node : slab.nodes) {
    low = low.cwiseMin(frame.nodes[node].at);
    high = high.cwiseMax(frame.nodes[node].at);
  }
  return {(high - low).head<2>(), (low.z() + high.z()) / 2};
}

} // namespace

std::vector<std::string> doubts_of(const Frame &frame) {
  std::vector<std::string> found;
  for (const auto &section : frame.sections) {
    const std::string of = "section " + section.name;
    doubt(found, of, modulus, section.E / 1e9);
    doubt(found, of, depth, std::sqrt(12 * std::max(section.Iy, section.Iz) / section.area));
  }
  double below = 0;
  for (std::size_t level = 0; level < frame.diaphragms.size(); ++level) {
    const auto &slab = frame.diaphragms[level];
    const std::string of = fmt::format("level {}", level);
    const Plan plan = plan_of(frame, slab);
    if (const double area = plan.sides.prod(); area > 0)
      doubt(found, of, mass_over_area, slab.mass / area);
    else if (const double length = plan.sides.norm(); length > 0)
      doubt(found, of, mass_over_length, slab.mass / length);
    if (level > 0) doubt(found, of, storey, plan.height - below);
    below = plan.height;
  }
  doubt(found, "frame", damping, frame.damping_ratio);
  return found;
}

} // namespace rimpact::buildings
