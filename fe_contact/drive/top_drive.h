/// The top face is driven: what the preload and every quasi-static path share.
#pragma once
#include "fe_contact/rungs/bearing_model.h"

namespace rimpact::fe {

/// Where the top face goes; its height is free under the load, or given where the dish is a law.
struct TopTarget {
  Eigen::Vector2d plane;        ///< [m]
  std::optional<double> height; ///< [m]
  double dt = 0;                ///< the way takes [s]; 0: friction is that of slow motion, steel without rate
};

/// Each step starts at the last one's change scaled to its way.
class TopDrive {
public:
  ContactStepReport move_to(BearingSystem &system, SystemState &state, const TopTarget &target,
                            const Eigen::VectorXd &load, const StepOptions &options);
  Eigen::VectorXd last_change;                        ///< of the state's u over the last step
  Eigen::Vector3d last_way = Eigen::Vector3d::Zero(); ///< of what was driven [m]; zero: none yet

private:
  Eigen::VectorXd guess(const BearingSystem &system, const SystemState &state, const Eigen::Vector3d &way) const;
};

/// Brings the bearing to rest on the dish under its load, in parts where the whole is too much. Throws SolverStopped.
void preload_on_dish(BearingSystem &system, SystemState &state, const Eigen::VectorXd &load,
                     const StepOptions &options);

} // namespace rimpact::fe
