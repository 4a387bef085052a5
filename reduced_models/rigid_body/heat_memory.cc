#include "reduced_models/rigid_body/heat_memory.h"
#include <algorithm>
#include <numbers>

namespace rimpact::reduced::rigid {

using Eigen::Vector2d;

HeatMemory::HeatMemory(const scene::Scene &scene, const Parts &parts, System &system)
    : counts_(scene.reduced.measured.by_temperature), heat_(scene.reduced.measured.heat), warmest_(heat_.at_start()) {
  for (std::size_t j = 0; j < parts.joints.size(); ++j) radius_[j] = parts.joints[j].face;
  system.temperature.fill(heat_.at_start());
}

void HeatMemory::pass(System &system, const MotionState &state, double t) {
  if (!counts_) return;
  struct Face {
    double power = 0;
    Vector2d centre = Vector2d::Zero();
    int points = 0;
  };
  std::array<Face, max_sets> faces;
  for (std::size_t i = 0; i < state.contact.size(); ++i) {
    const Contact &c = system.contacts[i];
    if (c.surface != Surface::dish) continue;
    Face &face = faces[c.set];
    face.power += state.contact[i].slip_power, ++face.points;
    const Pose master = c.master == ground ? Pose() : state.poses[c.master];
    face.centre += (master.rotation.transpose() * (state.contact[i].at - master.position)).head<2>();
  }
  for (int set = 0; set < max_sets; ++set) {
    const Face &face = faces[set];
    if (face.points == 0) continue;
    const bool covered = friction::passes_over(face.centre.norm() / face.points, radius_[set]);
    const double area = std::numbers::pi * radius_[set] * radius_[set];
    modes_[set] = heat_.after(modes_[set], covered ? std::max(0.0, face.power) / area : 0.0, t - until_);
    system.temperature[set] = heat_.temperature(modes_[set].data());
    warmest_ = std::max(warmest_, system.temperature[set]);
  }
  until_ = t;
}

} // namespace rimpact::reduced::rigid
