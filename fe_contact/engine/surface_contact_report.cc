#include "fe_contact/engine/surface_contact_report.h"

#include "fe_contact/solver/ranks.h"
#include <algorithm>

namespace rimpact::fe {

void SurfaceContactReport::add(const SurfaceContactReport &other) {
  force += other.force;
  friction += other.friction;
  smallest_gap = std::min(smallest_gap, other.smallest_gap);
  penetration = std::max(penetration, other.penetration);
  largest_pressure = std::max(largest_pressure, other.largest_pressure);
  stick += other.stick;
  slip += other.slip;
  lost += other.lost;
  pattern_holds = pattern_holds && other.pattern_holds;
}

void SurfaceContactReport::all_reduce() {
  Eigen::VectorXd sums(9), largest(4);
  sums << force, friction, stick, slip, lost;
  largest << -smallest_gap, penetration, largest_pressure, !pattern_holds;
  ranks().all_reduce_sum(sums);
  ranks().all_reduce_max(largest);
  force = sums.head<3>();
  friction = sums.segment<3>(3);
  stick = static_cast<int>(sums[6]);
  slip = static_cast<int>(sums[7]);
  lost = static_cast<int>(sums[8]);
  smallest_gap = -largest[0];
  penetration = largest[1];
  largest_pressure = largest[2];
  pattern_holds = largest[3] == 0;
}

} // namespace rimpact::fe
