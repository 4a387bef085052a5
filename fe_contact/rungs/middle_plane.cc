#include "fe_contact/rungs/middle_plane.h"

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace rimpact::fe {
namespace {

constexpr double same_place = 1e-6; // [m]

using Place = std::array<long, 2>;

Place place_of(const Eigen::Vector3d &x) {
  return {std::lround(x.x() / same_place), std::lround(x.y() / same_place)};
}

/// Thirty times the steel's stiffness over a cell of the plane: it gives way by less than a micrometre.
double stiffness_of(const BearingModel &model) {
  constexpr double cell = 0.025, stiffer = 30; // [m] at level 1
  return stiffer * model.bearing.steel_of(scene::SteelPart::slider).E * cell * meshes::size_factor(model.mesh.level);
}

} // namespace

unsigned middle_node(const Discretisation &space) {
  for (const unsigned node : space.nodes_of(meshes::Surface::top))
    if (space.positions[node].head<2>().norm() < same_place) return node;
  throw std::logic_error("the slider's middle plane has no node on its axis");
}

void tie_middle_plane(ContactSystem &system, const BearingModel &model) {
  const Discretisation &space = model.space;
  const auto &of = system.equations().of_dof;
  const unsigned middle = middle_node(space);
  const double stiffness = stiffness_of(model);
  std::map<Place, unsigned> at;
  for (const unsigned node : space.nodes_of(meshes::Surface::top)) at[place_of(space.positions[node])] = node;
  for (const auto &[place, node] : at) {
    const auto found = at.find({-place[0], model.mesh.half ? place[1] : -place[1]});
    if (found == at.end()) throw std::logic_error("a node of the slider's middle plane has no image");
    const unsigned image = found->second;
    if (node == middle || image < node) continue;
    for (int i = 0; i < 3; ++i) {
      if (model.mesh.half && i == 1) {
        if (image != node) system.add_tie({{of[3 * node + 1], 1}, {of[3 * image + 1], -1}}, stiffness);
        continue;
      }
      system.add_tie({{of[3 * node + i], 1}, {of[3 * image + i], 1}, {of[3 * middle + i], -2}}, stiffness);
    }
  }
}

} // namespace rimpact::fe
