/// A rung is a value: which solids are meshed, what holds them, what touches what, and what the supported mass rides
/// on. The engine assembles and solves any of them, and the drives run them.
#pragma once
#include "fe_contact/engine/contact_steps.h"
#include "fe_contact/engine/supports.h"
#include "meshes/hex_mesh.h"
#include "meshes/mesh_order.h"
#include "scene/bearing.h"
#include "scene/choices.h"
#include <vector>

namespace rimpact::fe {

struct BearingModel;

/// What a pair of surfaces is to the bearing; a rung has at most one pair of each.
enum class Role {
  dish,      ///< the pad's face on the sliding surface
  socket,    ///< the foot's cap in the slider's socket
  seat,      ///< the pad's back on the bottom of the foot's recess
  recess,    ///< the pad's edge within the recess's wall
  edge,      ///< the edge of a slider between two dishes on its dish, beside the wall
  interface, ///< the halves of a slider between two dishes on one another
  wall       ///< the slider against the rim
};

/// A contact pair: a slave group against an exact surface, which may stand on a body's deformed faces.
struct Pair {
  Role role;
  meshes::Surface slave;
  MasterSurface master;
  SurfaceContactOptions options;
};

/// The rim's solids are in the equations, or stand still.
enum class RimState { solid, held };

/// What the supported mass rides on.
enum class DishKind {
  law,   ///< the sliding surface is a constraint on the mass; solids are there while the walls touch
  exact, ///< the pad slides on the exact surface; the rim's solids join while it may be touched
  solid  ///< the plate is meshed; everything is solid all the time
};

struct Rung {
  scene::Rung name;
  DishKind dish;
  std::vector<meshes::Volume> carried; ///< the bodies that move with the supported mass, their own mass a part of it
  meshes::HexMesh (*mesh)(const scene::Bearing &, const meshes::MeshOrder &);
  /// What is held besides the plane of symmetry and the top face, whose components are the first equations.
  void (*hold)(Supports &, RimState);
  /// The contact pairs, in the order of the system's contacts.
  std::vector<Pair> (*pairs)(const BearingModel &, RimState);
  StepOptions steps; ///< tolerances of its steps, static ones and in time
};

} // namespace rimpact::fe
