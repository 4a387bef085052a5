/// Eigenpairs of the building with its base held, and the damping made of them (thesis 2.4: xi = 0.02 in every mode).
#pragma once
#include "buildings/assembly.h"

namespace rimpact::buildings {

struct Modes {
  Eigen::VectorXd omega;  ///< circular frequencies, rising [rad/s]
  Eigen::MatrixXd shapes; ///< over BuildingModel::above_base(), mass-normalised columns
};
/// Throws InputError when a motion of the building above its base meets no stiffness.
Modes fixed_base_modes(const BuildingModel &model);

/// C: `ratio` in every mode of the motion relative to the base, which takes the building along as its stiffness does;
/// rigid motions are not damped.
Eigen::MatrixXd modal_damping(const BuildingModel &model, double ratio);

} // namespace rimpact::buildings
