/// A storey of the building above the plate, between two bodies that only translate; its force and analytic
/// tangent in an implicit stage.
#pragma once
#include "reduced_models/rigid_body/system.h"

namespace rimpact::reduced::rigid {

/// What the storey does in an evaluation; `z` is its Bouc-Wen state there.
struct LinkForce {
  Eigen::Vector3d force; ///< on the body above [N]
  Eigen::Vector2d z;
  double damping_power, hysteretic_power; ///< taken by the dashpot, and by the hysteretic part [W]
  double elastic_energy, hysteretic_energy;
};

/// z0 and its implicit stage [s]: z = z0 + step z'.
struct LinkStage {
  double position_weight, step;
  const std::vector<Eigen::Vector2d> &z0;
};

/// Adds the links' forces to `sum` and their derivative by the velocities to `tangent` (may be null).
void add_links(const System &system, const Poses &poses, const Vector &velocity, const LinkStage &stage,
               std::vector<LinkForce> &link, Vector &sum, Matrix *tangent);

} // namespace rimpact::reduced::rigid
