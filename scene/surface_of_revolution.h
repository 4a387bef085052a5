/// Sliding surfaces z = h(r) given by their meridian: cone, polynomial, table. F(x, y, z) = h(r) - z (2-1).
/// Frame: origin at the dish's vertex, z up. SI units.
#pragma once
#include "scene/surface.h"

namespace rimpact::scene {

/// The meridian at one planar radius. `slope_over_radius` is h'/r, its limit h''(0) at the vertex.
struct MeridianPoint {
  double height;            ///< [m]
  double slope_over_radius; ///< [1/m]
  double second;            ///< h'' [1/m]
};

/// Everything a surface needs from its meridian, which must be twice continuously differentiable with
/// h(0) = h'(0) = 0: the vertex is smooth and lies at the origin.
class SurfaceOfRevolution : public SlidingSurface {
public:
  /// Planar radius 0 <= r < limit_radius().
  virtual MeridianPoint meridian(double r) const = 0;

  double F(const Eigen::Vector3d &x) const final;
  Eigen::Vector3d gradient(const Eigen::Vector3d &x) const final;
  Eigen::Matrix3d hessian(const Eigen::Vector3d &x) const final;
  SurfacePoint at(double x, double y) const final;
  Curvatures curvatures(double planar_radius) const final;

private:
  MeridianPoint inside(double r) const; ///< throws std::domain_error beyond the limit
};

/// Cone of `slope` whose vertex is rounded to the radius of curvature R0: the hyperboloid
/// h = slope (sqrt(r^2 + c^2) - c), c = slope R0; the cone's height is missed by slope c far from the vertex.
std::unique_ptr<SlidingSurface> make_cone(const SurfaceSpec &spec);
/// h = c2 r^2 + c3 r^3 + ... + c6 r^6. The "third" and "fifth order" isolators of the literature name the
/// order of the restoring force, h': they end with c4 and c6.
std::unique_ptr<SlidingSurface> make_polynomial(const SurfaceSpec &spec);

} // namespace rimpact::scene
