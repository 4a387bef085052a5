/// A rim that yields keeps the shape it was pressed into. A slider that moves along it while it presses, or comes back
/// beside its dent, stands on the dent's flank.
///
/// Pressed to D where the touch is at s0 along the wall, the rim keeps D - (s - s0)^2 / (2 r_f). Two circles that meet
/// (slider r, wall R) would make r_f = r R / (R - r); the rim's bending spreads a dent, r_f = spread r R / (R - r)
/// (docs/theory/rim.md). At the distance tau along the wall from its present touch s the slider meets what a straight
/// one would have left by pressing to
///   D_tau = max over the path so far of D - ((s - s0)^2 + 2 tau (s - s0)) / (2 r_f),
/// deeper behind it than before it. Its force is the mean of the law's over the touch, |tau| <= sqrt(2 r_f D), weighted
/// by an ellipse (Hertz), each part along the slider's own normal: so it is also slowed along the wall. A straight
/// impact meets one dent at tau's every value, and the law as it stands.
///
/// The maximum is over every instant of the path, the step that is being taken included, whatever the integrator's
/// steps: the path is kept as strokes (wall_stroke.h), those it can still see. What it knows of a place is a maximum:
/// neither the order nor the number of the pieces matters.
#pragma once
#include "laws/impact/impact_law.h"
#include "reduced_models/bearings/wall_stroke.h"
#include "scene/scene.h"
#include <optional>

namespace rimpact::reduced {

struct DentShape {
  double wall = 1;                                                          ///< radius of the rim's wall, R [m]
  double slider = 0.5;                                                      ///< r [m], < R
  double spread = 1;                                                        ///< [-], > 0
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
  /// A step of a pressing slider begins at t [s]; it ends by `arrive`, which keeps the stroke, or by `lift`.
  void begin_step(double t, const WallPoint &at) { from_ = at, since_ = t; }
  void arrive(double t, const WallPoint &at, const DentShape &shape);
  void lift() { from_.reset(); }
  /// The stroke since begin_step, while the step is being taken; none before the first instant after it.
  std::optional<WallStroke> under_way(double t, const WallPoint &at, const DentShape &shape) const;
  bool setting_out() const { return from_.has_value(); }

  /// What is dented where a slider at u touches [m]; 0: nothing.
  double deepest_at(const Eigen::Vector2d &u, const DentShape &shape, const WallStroke *present = nullptr) const;
  /// By a law that yields, for the motion of a slider at u (its `deepest` is not read); `present`: the stroke under
  /// way.
  RimPush push(const laws::RimElement &rim, const Eigen::Vector2d &u, const laws::RimMotion &motion,
               const DentShape &shape, const WallStroke *present = nullptr) const;
  const std::vector<Dent> &dents() const { return dents_; }
  const std::vector<WallStroke> &strokes() const { return strokes_; }

private:
  double reach(double d, const DentShape &shape) const;
  void forget_covered(const Eigen::Vector2d &u, double d, const DentShape &shape);
  bool covered(const Eigen::Vector2d &u, double d, double reach, const DentShape &shape) const;
  std::vector<Dent> dents_;         ///< of presses
  std::vector<WallStroke> strokes_; ///< of presses that moved along the wall
  std::optional<WallPoint> from_;
  double since_ = 0;
};

} // namespace rimpact::reduced
