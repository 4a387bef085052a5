/// A rim that yields keeps the shape it was pressed into, and a slider that moves along it while it presses, or comes back
/// beside its dent, stands on the dent's flank.
///
/// Pressed to D where the touch is at s0 along the wall, the rim keeps D - (s - s0)^2 / (2 r_f). Two circles that meet (slider r,
/// wall R) would make r_f = r R / (R - r); the rim's bending spreads a dent, r_f = spread r R / (R - r) (docs/theory.md). At the
/// distance tau along the wall from its present touch s the slider meets what a straight one would have left by pressing to
///   D_tau = max over the dents of D - ((s - s0)^2 + 2 tau (s - s0)) / (2 r_f),
/// deeper behind it than before it. Its force is the mean of the law's over the touch, |tau| <= sqrt(2 r_f D), weighted by an
/// ellipse (Hertz), each part along the slider's own normal: so it is also slowed along the wall. A straight impact meets one
/// dent at tau's every value, and the law as it stands.
#pragma once
#include "reduced_models/impact_law.h"
#include <Eigen/Core>

namespace rimpact::reduced {

struct DentShape {
  double wall = 1;   ///< radius of the rim's wall, R [m]
  double slider = 0.5; ///< r [m], < R
  double spread = 1; ///< [-], > 0
  double flank() const { return spread * slider * wall / (wall - slider); } ///< r_f [m]
};
DentShape dent_shape(const scene::Scene &scene);

struct Dent {
  Eigen::Vector2d direction; ///< outward unit vector
  double deepest;            ///< penetration beyond L_c [m], > 0
};

/// On the slider, by the unit vectors outwards and round the bearing (counter-clockwise).
struct RimPush {
  double inwards = 0; ///< [N], >= 0 unless the law pulls
  double along = 0;   ///< [N]
  /// As `inwards`, but below zero where nothing presses: by how much the law is from pressing [N].
  double trial = 0;
};

class DentedRim {
public:
  /// Keeps what a slider at u (any length > 0) presses to, d [m].
  void press(const Eigen::Vector2d &u, double d, const DentShape &shape);
  /// What is dented where a slider at u touches [m]; 0: nothing.
  double deepest_at(const Eigen::Vector2d &u, const DentShape &shape) const;
  /// By a law that yields, for the motion of a slider at u (its `deepest` is not read).
  RimPush push(const RimElement &rim, const Eigen::Vector2d &u, const RimMotion &motion, const DentShape &shape) const;
  const std::vector<Dent> &dents() const { return dents_; }

private:
  std::vector<Dent> dents_;
};

} // namespace rimpact::reduced
