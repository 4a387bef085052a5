/// Rung rigid-dish: pad (tied to the foot, or seated in its recess), foot and upper slider on the exact dish, and the
/// rim's sectors where a scene needs them; of two dishes one, with half the slider (see middle_plane.h). Frame and
/// reference position: at rest on the vertex (see stack_mesh).
#pragma once
#include "fe_contact/rungs/rung.h"
#include "meshes/hex_mesh.h"

namespace rimpact::fe {

namespace rungs {
extern const Rung rigid_dish;
}

inline std::vector<meshes::Volume> stack_bodies() {
  return {meshes::Volume::pad, meshes::Volume::foot, meshes::Volume::upper_slider};
}
StepOptions stack_steps();
void hold_plate(Supports &supports, RimState rim); ///< or, with the rim held, plate and rim as bodies
/// Dish under the pad, socket on the foot's cap, a frictional pad in the foot's recess. The halves of a slider that is
/// two on one another. With the rim, wall against slider.
std::vector<Pair> stack_pairs(const BearingModel &model, RimState rim);

} // namespace rimpact::fe
