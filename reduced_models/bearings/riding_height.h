/// The height the upper slider rides at over the plan position: the dish, plus the finite pad's lift when
/// asked for.
#pragma once
#include "scene/bearing.h"
#include <array>
#include <memory>
#include <vector>

namespace rimpact::reduced {

/// Even function of the radius as polynomials in s = r^2, piece by piece: those of a Chebyshev interpolant over the
/// whole range, within 1e-15 of its largest value, 1e-12 and 1e-9 of its derivatives'. No special case at r = 0.
class RadialInterpolant {
public:
  template <class Function> RadialInterpolant(const Function &of_radius, double largest_radius);
  struct Values {
    double value, d1, d2; ///< derivatives by s = r^2
  };
  Values at(double s) const;

private:
  static constexpr int n_pieces = 32, degree = 9;
  using Piece = std::array<double, degree + 1>; ///< powers of t in [-1, 1]
  void fit(const std::vector<double> &samples);
  double half_ = 0; ///< half of the range of s
  std::array<Piece, n_pieces> pieces_{};
};

class RidingHeight {
public:
  /// A `pad_load` above zero [N] adds the finite pad's lift under it (pad_on_dish.h), zero at rest; by itself the
  /// slider rides as a point. A lift that is no smooth function of r^2 (odd powers of a polynomial, a table's
  /// rows) is rounded over some 15 mm, less than the pad's own size.
  explicit RidingHeight(const scene::Bearing &bearing, double pad_load = 0);
  /// A horizontal plane at the height of travel `radius`: an impact window without weight.
  static RidingHeight plane(const scene::Bearing &bearing, double radius);

  scene::SurfacePoint at(double x, double y) const;
  scene::Curvatures curvatures(double radius) const; ///< of the dish; zero on the plane
  /// Radius beyond which there is no dish to ride on [m].
  double limit_radius() const { return limit_; }
  bool is_plane() const { return plane_; }

private:
  std::unique_ptr<scene::SlidingSurface> surface_;
  std::shared_ptr<const RadialInterpolant> lift_;
  double limit_ = 0, plane_height_ = 0;
  bool plane_ = false;
};

} // namespace rimpact::reduced
