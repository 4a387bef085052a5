/// The sliding surface as an implicit function F(x, y, z) = 0 (thesis eq. 2-1) with gradient and curvature.
/// Frame: origin at the dish's vertex, z up. SI units.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace rimpact::scene {

/// Height of the surface above (x, y) with its derivatives.
struct SurfacePoint {
  double z;                 ///< [m]
  Eigen::Vector2d gradient; ///< dz/dx, dz/dy [-]
  Eigen::Matrix2d hessian;  ///< second derivatives [1/m]
};

/// Principal curvatures of a surface of revolution at planar radius r (positive: concave upwards).
struct Curvatures {
  double meridional;      ///< [1/m]
  double circumferential; ///< [1/m]
};

class SlidingSurface {
public:
  virtual ~SlidingSurface() = default;
  /// Implicit function; F < 0 on the concave side (above the dish), dimensionless.
  virtual double F(const Eigen::Vector3d &x) const = 0;
  virtual Eigen::Vector3d gradient(const Eigen::Vector3d &x) const = 0;
  virtual Eigen::Matrix3d hessian(const Eigen::Vector3d &x) const = 0;
  /// Lower sheet as a height field. Throws std::domain_error for planar radius >= limit_radius().
  virtual SurfacePoint at(double x, double y) const = 0;
  virtual Curvatures curvatures(double planar_radius) const = 0;
  /// Planar radius beyond which the height field does not exist [m] (a for the ellipse, R0 for the sphere).
  virtual double limit_radius() const = 0;
};

/// What a bearing file says of its surface.
struct SurfaceSpec {
  std::string kind = "ellipse"; ///< "ellipse" | "sphere" (others: issue of the reduced models)
  double R0 = 2.25;             ///< radius of curvature at the vertex [m], > 0 (eq. 2-24: R0 = a^2/b)
  double a = 0.5625;            ///< half-width of the ellipse [m], > 0
  double planar_radius = 0.520; ///< r_p, the dish's edge [m], 0 < r_p < limit radius

  bool operator==(const SurfaceSpec &) const = default;
};

std::vector<std::string> surface_kind_names();
/// One line a kind in surface.cc's catalogue. Throws InputError naming the known kinds.
std::unique_ptr<SlidingSurface> make_surface(const SurfaceSpec &spec);

} // namespace rimpact::scene
