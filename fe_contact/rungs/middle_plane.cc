#include "fe_contact/rungs/middle_plane.h"

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace rimpact::fe {

using meshes::Surface;

namespace {

constexpr double same_place = 1e-6; // [m]
constexpr double cell = 0.025;      // of the plane, at level 1 [m]

using Place = std::array<long, 2>;

Place place_of(const Eigen::Vector3d &x) {
  return {std::lround(x.x() / same_place), std::lround(x.y() / same_place)};
}

/// Thirty times the steel's stiffness over a cell of the plane: it gives way by less than a micrometre.
double stiffness_of(const BearingModel &model) {
  constexpr double stiffer = 30;
  return stiffer * model.bearing.steel_of(scene::SteelPart::slider).E * cell * meshes::size_factor(model.mesh.level);
}

} // namespace

unsigned middle_node(const Discretisation &space) {
  for (const unsigned node : space.nodes_of(Surface::top))
    if (space.positions[node].head<2>().norm() < same_place) return node;
  throw std::logic_error("the slider's middle plane has no node on its axis");
}

void tie_middle_plane(ContactSystem &system, const BearingModel &model) {
  const Discretisation &space = model.space;
  const auto &of = system.equations().of_dof;
  const unsigned middle = middle_node(space);
  const double stiffness = stiffness_of(model);
  std::map<Place, unsigned> at;
  for (const unsigned node : space.nodes_of(Surface::top)) at[place_of(space.positions[node])] = node;
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

int middle_dof(const BearingModel &model) {
  return static_cast<int>(3 * (model.slips() ? model.space.n_nodes : middle_node(model.space)));
}

SurfaceContactOptions steel_on_steel(const BearingModel &model, const FrictionCoefficient &mu) {
  constexpr double stiffer = 16;
  return penalised(model, model.bearing.steel_of(scene::SteelPart::slider).E, cell, mu, stiffer);
}

Pair halves_pair(const BearingModel &model) {
  const double mu = *model.bearing.slider.mu_interface, side = model.mesh.half ? 1 : -1; // in the half model's plane
  const Eigen::Vector3d centre = model.space.positions[middle_node(model.space)];
  Pair pair{Role::interface, Surface::top, plane(centre, Eigen::Vector3d::UnitZ()),
            steel_on_steel(model, FrictionCoefficient::constant(mu))};
  pair.options.carrier_faces = Surface::top;
  pair.options.image = OwnImage{centre, {-1, side, -1}, middle_dof(model)};
  return pair;
}

} // namespace rimpact::fe
