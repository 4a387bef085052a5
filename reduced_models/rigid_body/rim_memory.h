/// What earlier impacts have left on the rims and stops of a bearing of several bodies, arc by arc (one dish:
/// dented_rim.h).
#pragma once
#include "reduced_models/bearings/dented_rim.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <numbers>
#include <vector>

namespace rimpact::reduced {

/// An impact within 8 degrees of a dent meets the rim as that left it, others a fresh arc (as rung rim does).
class RimMemory {
public:
  /// Of the arc around `u` (any length > 0) [m]; 0: never pressed there.
  double deepest_at(const Eigen::Vector2d &u) const {
    const Dent *dent = near(dents_, u);
    return dent ? dent->deepest : 0;
  }
  void press(const Eigen::Vector2d &u, double d) {
    if (Dent *dent = near(dents_, u))
      dent->deepest = std::max(dent->deepest, d);
    else
      dents_.push_back({u.normalized(), d});
  }
  const std::vector<Dent> &dents() const { return dents_; }

private:
  template <class Dents> static auto near(Dents &dents, const Eigen::Vector2d &u) -> decltype(dents.data()) {
    static const double cosine = std::cos(8 * std::numbers::pi / 180);
    for (auto &dent : dents)
      if (dent.direction.dot(u) > cosine * u.norm()) return &dent;
    return nullptr;
  }
  std::vector<Dent> dents_;
};

} // namespace rimpact::reduced
