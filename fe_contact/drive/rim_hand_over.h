/// Hands a state of the stack over when the rim joins or leaves the equations.
#pragma once
#include "fe_contact/rungs/bearing_model.h"

namespace rimpact::fe {

/// What is kept of the rim while it is held: its permanent shape and what it stores.
struct HeldRim {
  Eigen::VectorXd displacement; ///< by dof, zero off the rim; empty: as made [m]
  SolidEnergies energies;       ///< of the model [J]
};

/// The stack's state with the rim at rest in its permanent shape.
SystemState joined_state(const BearingSystem &alone, const SystemState &state, const HeldRim &held,
                         BearingSystem &joined);
/// The stack's state without the rim, which stops where it is: its motion is lost. Fills `held`.
SystemState parted_state(const BearingModel &model, const BearingSystem &joined, const SystemState &state,
                         BearingSystem &alone, HeldRim &held);

} // namespace rimpact::fe
