#include "fe_contact/rungs/full.h"

#include "fe_contact/rungs/bearing_model.h"
#include "fe_contact/rungs/rigid_dish.h"
#include "meshes/stack_mesh.h"

namespace rimpact::fe {
namespace {

meshes::HexMesh plate_mesh_of(const scene::Bearing &bearing, const meshes::MeshOrder &order) {
  meshes::MeshOrder whole = order;
  whole.whole_plate = true;
  return meshes::stack_mesh(bearing, whole);
}

std::vector<Pair> plate_pairs(const BearingModel &model, RimState rim) {
  std::vector<Pair> result = stack_pairs(model, rim);
  result[0].options.carrier_faces = meshes::Surface::dish;
  return result;
}

} // namespace

const Rung rungs::full{
    .name = scene::Rung::full,
    .dish = DishKind::solid,
    .carried = stack_bodies(),
    .mesh = plate_mesh_of,
    .hold = hold_plate,
    .pairs = plate_pairs,
    .steps = stack_steps(),
};

} // namespace rimpact::fe
