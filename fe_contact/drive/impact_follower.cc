#include "fe_contact/drive/impact_follower.h"

#include "fe_contact/drive/state_fields.h"
#include <algorithm>
#include <cmath>

namespace rimpact::fe {

void ImpactFollower::begin(double t, const Eigen::Vector3d &u, double approach_speed) {
  impact_ = {t, t, std::atan2(u.y(), u.x()) * 180 / M_PI, approach_speed, 0, 0, 0};
  forget();
}

void ImpactFollower::follow(double t, double force, double penetration, double outward_speed) {
  if (!(force > 0)) return;
  impact_.release_time = t;
  impact_.rebound_speed = -outward_speed;
  impact_.peak_force = std::max(impact_.peak_force, force);
  impact_.peak_penetration = std::max(impact_.peak_penetration, penetration);
}

bool ImpactFollower::turns(double outward_speed) {
  if (!touched_ || turned_ || outward_speed > 0) return false;
  turned_ = true;
  return true;
}

void ImpactFollower::visit(StateVisitor &v) {
  v.flag("touched", touched_);
  v.flag("turned", turned_);
  fe::visit(v, impact_);
}

} // namespace rimpact::fe
