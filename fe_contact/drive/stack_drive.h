/// A stack whose top face is driven: what the preload and every quasi-static path share.
#pragma once
#include "fe_contact/rungs/stack.h"
#include "planning/plan.h"

namespace rimpact::fe {

/// What the plan says of the mesh.
meshes::StackMeshOptions stack_mesh_options(const scene::Scene &scene, const planning::Plan &plan);
/// Tolerances of quasi-static steps of the stack.
StepOptions stack_step_options();

/// Brings the stack to rest on the dish under its load. Throws SolverStopped.
void preload_stack(StackSystem &system, SystemState &state, const Eigen::VectorXd &load, const StepOptions &options);

/// Moves the top face; each step starts at the last one's change scaled to its way.
class TopDrive {
public:
  ContactStepReport move_to(StackSystem &system, SystemState &state, const Eigen::Vector2d &target,
                            const Eigen::VectorXd &load, const StepOptions &options);
  Eigen::VectorXd last_change;                        ///< of the state's u over the last step
  Eigen::Vector2d last_way = Eigen::Vector2d::Zero(); ///< [m]; zero: none yet

private:
  Eigen::VectorXd guess(const StackSystem &system, const SystemState &state, const Eigen::Vector2d &way) const;
};

} // namespace rimpact::fe
