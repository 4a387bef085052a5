/// How motion on the dish starts: at rest on the vertex, or for a window just short of the rim at the impact's speed.
#pragma once
#include "fe_contact/drive/run_record.h"
#include "fe_contact/drive/top_drive.h"
#include <utility>

namespace rimpact::fe {

class StartOnDish {
public:
  StartOnDish(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options, BearingSystem &system,
              const StepOptions &steps)
      : scene_(scene), plan_(plan), options_(options), system_(system), steps_(steps) {}

  /// A state, and the height of the top face at rest on the vertex [m]. Throw SolverStopped, Interrupted.
  using Start = std::pair<SystemState, double>;
  Start at_rest() const;
  /// Slid out quasi-statically to just short of the rim, then given the speed of the window's impact.
  Start near_the_rim() const;

private:
  double end() const;                                         ///< distance from the vertex at which a window starts [m]
  double ratio() const { return system_.model().rate_ratio; } ///< of what is carried over the top face or the middle
  /// Along the window's direction, from one distance from the vertex to another [m].
  void slide(SystemState &state, TopDrive &drive, double from, double to, double first, double longest,
             const Eigen::VectorXd &load) const;
  /// At rest on the vertex, then to the last stretch before the rim, under the dead load; or what is kept of it.
  Start nearly_there(TopDrive &drive, double to) const;

  const scene::Scene &scene_;
  const planning::Plan &plan_;
  const RunOptions &options_;
  BearingSystem &system_;
  const StepOptions &steps_;
};

} // namespace rimpact::fe
