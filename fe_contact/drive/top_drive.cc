#include "fe_contact/drive/top_drive.h"

#include "io/files/error.h"

namespace rimpact::fe {

ContactStepReport TopDrive::move_to(BearingSystem &system, SystemState &state, const TopTarget &target,
                                    const Eigen::VectorXd &load, const StepOptions &options) {
  StepTerms terms{load};
  terms.dt = target.dt;
  const Eigen::Vector3d now = system.top_of(state.u),
                        goal(target.plane.x(), target.plane.y(), target.height.value_or(now.z()));
  for (int i = 0; i < (target.height ? 3 : 2); ++i)
    if (const int equation = system.top().equation[i]; equation >= 0) terms.driven.push_back({equation, goal[i]});
  const Eigen::VectorXd before = state.u;
  const Eigen::Vector3d way = goal - now;
  const ContactStepReport step = static_step(system, state, terms, options, guess(system, state, way));
  if (!step.converged) return step;
  last_change = state.u - before;
  last_way = way;
  return step;
}

/// At first the carried bodies go along in translation. Onwards and on the dish the parts go on as they went; back from
/// where the walls bear they are elastic at first.
Eigen::VectorXd TopDrive::guess(const BearingSystem &system, const SystemState &state,
                                const Eigen::Vector3d &way) const {
  if (last_way.squaredNorm() == 0) {
    Eigen::VectorXd u = state.u;
    system.translate(u, way);
    return u;
  }
  const double onwards = way.dot(last_way) / last_way.squaredNorm();
  if (onwards < 0 && system.walls_touch(state)) return state.u;
  return state.u + onwards * last_change;
}

void preload_on_dish(BearingSystem &system, SystemState &state, const Eigen::VectorXd &load,
                     const StepOptions &options) {
  constexpr double springs = 1e8; // first round of stabilisation [N/m an equation]
  PreloadReport report;
  for (const int parts : {1, 4, 16}) { // a small soft pad takes its load by and by
    SystemState pressed = state;
    for (int k = 1; k <= parts && (k == 1 || report.converged); ++k)
      report = preload(system, pressed, double(k) / parts * load, springs, options);
    if (!report.converged) continue;
    state = std::move(pressed);
    return;
  }
  throw SolverStopped("the bearing did not come to rest under its load: " + report.reason);
}

} // namespace rimpact::fe
