#include "reduced_models/rigid_body/wall_memory.h"
#include <algorithm>

namespace rimpact::reduced::rigid {

void WallMemory::press(System &system, const MotionState &state) {
  const auto yields = [](const laws::RimElement &rim) { return rim.law && rim.law->yields; };
  if (std::none_of(system.rim.begin(), system.rim.end(), yields)) return;
  dents_.resize(system.contacts.size());
  for (std::size_t i = 0; i < state.contact.size(); ++i) {
    const auto &c = system.contacts[i];
    if (!is_wall(c.surface) || !yields(system.rim[c.set])) continue;
    const Eigen::Vector3d foot =
        c.master == ground ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : state.poses[c.master].position;
    const Eigen::Vector2d arm = (state.contact[i].at - foot).head<2>();
    if (state.contact[i].size != 0) dents_[i].press(arm, state.contact[i].penetration);
    system.deepest[i] = dents_[i].deepest_at(arm);
  }
}

} // namespace rimpact::reduced::rigid
