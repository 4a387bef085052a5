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
constexpr Usual modulus{"E", "GPa", 3, 300}, shear_modulus{"G over E", "", 0.02, 1}, depth{"depth", "m", 0.08, 5},
    width{"width", "m", 0.02, 5}, shear_area{"shear area over area", "", 0.02, 1.5},
    hinge{"hinge length over depth", "", 0.05, 4},
    yield_strain{"strain at the edge where its ends yield", "", 2e-4, 0.05},
    axial_strain{"strain at axial_yield", "", 1e-4, 0.05}, member{"length", "m", 0.3, 100},
    mass_over_area{"mass over its plan", "kg/m2", 100, 1e4}, mass_over_length{"mass over its length", "kg/m", 500, 2e5},
    inertia{"inertia over that of its plan", "", 0.02, 20},
    apart{"distance of the centre of mass from that of the weights over the plan's diagonal", "", 0, 0.05},
    vertical{"vertical masses of nodes over masses of slabs", "", 0.5, 2}, damping{"damping_ratio", "", 0, 0.2};

/// Doubts of one kind are one sentence: that of the first, and how many more there are.
class Doubts {
public:
  void look(const std::string &of, const Usual &usual, double value) {
    if (value >= usual.low && value <= usual.high) return;
    for (auto &doubt : doubts_)
      if (doubt.what == usual.what) return void(++doubt.more);
    doubts_.push_back({usual.what, fmt::format("{}: {} = {:.4g}{}{}, where {:g} to {:g} is usual", of, usual.what,
                                               value, *usual.unit ? " " : "", usual.unit, usual.low, usual.high)});
  }
  std::vector<std::string> sentences() const {
    std::vector<std::string> result;
    for (const auto &doubt : doubts_)
      result.push_back(doubt.first + (doubt.more > 0 ? fmt::format(" ({} more)", doubt.more) : "") +
                       ": are the units right?");
    return result;
  }

private:
  struct Doubt {
    const char *what;
    std::string first;
    int more = 0;
  };
  std::vector<Doubt> doubts_;
};

void look_at(const Section &s, Doubts &found) {
  const std::string of = "section " + s.name;
  const double second = std::max(s.Iy, s.Iz), deep = std::sqrt(12 * second / s.area);
  found.look(of, modulus, s.E / 1e9);
  found.look(of, shear_modulus, s.G / s.E);
  found.look(of, depth, deep);
  found.look(of, width, std::sqrt(12 * std::min(s.Iy, s.Iz) / s.area));
  for (const double area : {s.shear_y, s.shear_z})
    if (area > 0) found.look(of, shear_area, area / s.area);
  if (!s.inelastic) return;
  found.look(of, hinge, s.inelastic->hinge_length / deep);
  if (s.inelastic->yield_moment > 0)
    found.look(of, yield_strain, s.inelastic->yield_moment * deep / (2 * s.E * second));
  found.look(of, axial_strain, s.inelastic->axial_yield / (s.E * s.area));
}

Eigen::Vector2d sides_of(const Frame &frame, const Diaphragm &slab) {
  Eigen::Vector3d low = frame.nodes[slab.nodes.front()].at, high = low;
  for (const int node : slab.nodes) {
    low = low.cwiseMin(frame.nodes[node].at);
    high = high.cwiseMax(frame.nodes[node].at);
  }
  return (high - low).head<2>();
}

Eigen::Vector2d centre_of_weights(const Frame &frame, const Diaphragm &slab) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double mass = 0;
  for (const int node : slab.nodes) {
    mass += frame.nodes[node].vertical_mass;
    sum += frame.nodes[node].vertical_mass * frame.nodes[node].at;
  }
  return sum.head<2>() / mass;
}

void look_at(const Frame &frame, const Diaphragm &slab, const std::string &of, Doubts &found) {
  const Eigen::Vector2d sides = sides_of(frame, slab);
  if (!(sides.norm() > 0)) return;
  if (sides.prod() > 0)
    found.look(of, mass_over_area, slab.mass / sides.prod());
  else
    found.look(of, mass_over_length, slab.mass / sides.norm());
  found.look(of, apart, (slab.centre - centre_of_weights(frame, slab)).norm() / sides.norm());
  found.look(of, inertia, slab.inertia / (slab.mass * sides.squaredNorm() / 12));
}

} // namespace

std::vector<std::string> doubts_of(const Frame &frame) {
  Doubts found;
  for (const auto &section : frame.sections) look_at(section, found);
  for (std::size_t e = 0; e < frame.elements.size(); ++e) {
    const auto &element = frame.elements[e];
    found.look(fmt::format("member {}", e + 1), member, (frame.nodes[element.j].at - frame.nodes[element.i].at).norm());
  }
  double slabs = 0, nodes = 0;
  for (std::size_t level = 0; level < frame.diaphragms.size(); ++level) {
    const auto &slab = frame.diaphragms[level];
    look_at(frame, slab, fmt::format("level {}", level), found);
    slabs += slab.mass;
  }
  for (const auto &node : frame.nodes) nodes += node.vertical_mass;
  found.look("frame", vertical, nodes / slabs);
  found.look("frame", damping, frame.damping_ratio);
  return found.sentences();
}

} // namespace rimpact::buildings
