/// What the pad's size and elasticity and the socket's width add to a bearing reduced to a point: laws of the slider
/// stack in closed or nearly closed form, for rungs `rigid-dish` and `full` to be compared with.
#pragma once
#include "scene/scene.h"

namespace rimpact::reduced {

/// The pad as a layer of springs on the exact dish: its face, shaped to `shape_radius`, is pressed by `load` [N] with
/// the centre of the socket at travel r. It is free to tilt about it, and leaves the dish where it would pull. The
/// layer has the confined modulus over its thickness, E (1 - nu) / ((1 + nu)(1 - 2 nu) t): it is bonded to the foot.
class PadOnDish {
public:
  PadOnDish(const scene::Bearing &bearing, const scene::SlidingSurface &surface, double load);
  /// Height that does the work of moving there under `load`: the slider's rise plus the pad's elastic energy over the
  /// load, both at least energy, less the dish's own height at r [m]. Its slope times the load is the pad's share of
  /// the restoring force. For a soft pad and small travel (Ro^2 + Ri^2)/8 (kappa_m + kappa_c): docs/theory/dish.md.
  double lift(double r) const;

private:
  struct Profile {
    double z, slope;
  };
  Profile profile(double r) const; ///< of the dish; beyond its edge its tangent goes on
  struct Potential {
    double value = 0; ///< of load and springs [J]
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero(); ///< Gauss's and Newton's: overlaps are small
  };
  /// By the height of the face's middle [m] and the tilt [rad].
  Potential potential(double r, const Eigen::Vector2d &height_and_tilt) const;
  const scene::Bearing &bearing_;
  const scene::SlidingSurface &surface_;
  double load_, edge_, stiffness_; ///< [N], [m], of the layer [N/m^3]
};

/// Arm of the socket's friction about a horizontal axis [m]: moment over mu N. The pressure of a ball in its socket
/// goes with the cosine of the polar angle, so that its sum over the face exceeds the load it carries; a point
/// turns at its distance from the axis. Cap radius times 1.11 for the default socket, 1 for a narrow one.
double socket_arm(const scene::Bearing &bearing);

/// Switches on what rungs `rigid-dish` and `full` have by themselves: the finite pad, the socket's friction, and
/// (Park-Wen, unless the scene has chosen that itself) the pad's elastic slip under the dead load.
void add_stack_terms(scene::Scene &scene);

} // namespace rimpact::reduced
