#include "fe_contact/drive/ground_step.h"

#include <algorithm>
#include <cmath>

namespace rimpact::fe {

GroundStep ground_step(const scene::GroundMotion &ground, double t, double dt) {
  constexpr double longest_piece = 5e-4; // [s]
  GroundStep step{ground.acceleration(t), ground.acceleration(t + dt), Eigen::Vector3d::Zero(),
                  Eigen::Vector3d::Zero()};
  const int n = std::max(1, static_cast<int>(std::ceil(dt / longest_piece)));
  const double piece = dt / n, off = std::sqrt(1 / 12.0);
  for (int k = 0; k < n; ++k)
    for (const double at : {0.5 - off, 0.5 + off}) {
      const double s = (k + at) * piece;
      const Eigen::Vector3d half = 0.5 * piece * ground.acceleration(t + s);
      step.velocity += half;
      step.displacement += (dt - s) * half;
    }
  return step;
}

} // namespace rimpact::fe
