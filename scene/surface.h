/// The sliding surface as an implicit function F(x, y, z) = 0 (thesis eq. 2-1) with gradient and curvature.
/// Frame: origin at the dish's vertex, z up. SI units.
#pragma once
#include "io/files/choice.h"
#include <array>
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
  /// Implicit function; F < 0 on the concave side (above the dish). Its unit is the
  /// surface's own (1 for the ellipse, m for those given as heights); only F = 0 and directions have a
  /// meaning.
  virtual double F(const Eigen::Vector3d &x) const = 0;
  virtual Eigen::Vector3d gradient(const Eigen::Vector3d &x) const = 0;
  virtual Eigen::Matrix3d hessian(const Eigen::Vector3d &x) const = 0;
  /// Lower sheet as a height field. Throws std::domain_error for planar radius >= limit_radius().
  virtual SurfacePoint at(double x, double y) const = 0;
  virtual Curvatures curvatures(double planar_radius) const = 0;
  /// Planar radius beyond which the height field does not exist [m] (a for the ellipse, R0 for the sphere,
  /// the last row of a table, infinite for cone and polynomial).
  virtual double limit_radius() const = 0;
};

enum class SurfaceKind { ellipse, sphere, cone, polynomial, table };
constexpr auto choices(SurfaceKind) {
  using enum SurfaceKind;
  return choices_of<SurfaceKind>(
      {{ellipse, "ellipse"}, {sphere, "sphere"}, {cone, "cone"}, {polynomial, "polynomial"}, {table, "table"}});
}

/// How many dishes a bearing has.
enum class Concave {
  single, ///< one, on which a slider with pad and foot moves
  twice   ///< two alike, face to face, with one slider between them
};
constexpr auto choices(Concave) {
  return choices_of<Concave>({{Concave::single, "single"}, {Concave::twice, "double"}});
}

/// What a bearing file says of its surface: of one of its dishes.
struct SurfaceSpec {
  SurfaceKind kind = SurfaceKind::ellipse;
  Concave concave = Concave::single;
  double R0 = 2.25;             ///< radius of curvature at the vertex [m], > 0 (eq. 2-24: R0 = a^2/b); not read
                                ///< for polynomial and table
  double a = 0.5625;            ///< half-width of the ellipse [m], > 0
  double planar_radius = 0.520; ///< r_p, the dish's edge [m], 0 < r_p < limit radius
  double slope = 0.1;           ///< of the cone [-], > 0
  /// c2 ... c6 of the polynomial [m^(1-k)]; the default has 1/R0 = 1/2.25 m at its vertex.
  std::array<double, 5> coefficients{1 / 4.5, 0, 0, 0, 0};
  std::vector<double> table_radius = {}, table_height = {}; ///< rows of the table [m], from (0, 0), radii growing
  std::string table_file = {};                              ///< CSV file of the rows; empty once read

  bool operator==(const SurfaceSpec &) const = default;
};

/// Throws InputError naming what is wrong with a table.
std::unique_ptr<SlidingSurface> make_surface(const SurfaceSpec &spec);

} // namespace rimpact::scene
