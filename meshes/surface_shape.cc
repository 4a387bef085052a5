#include "meshes/surface_shape.h"
#include "meshes/gmsh_session.h"
#include <cmath>
#include <Eigen/Dense>

namespace rimpact::meshes {
namespace {

using Eigen::Vector3d;

Vector3d vector_of(const std::vector<double> &x) {
  return {x[0], x[1], x[2]};
}

/// A place of the surface: point, unit normal and the two principal curvatures, of any sign, with their directions.
struct Sample {
  Vector3d point, normal, flat_along; ///< flat_along: the direction of the smaller curvature
  double flat, sharp;                 ///< magnitudes, flat <= sharp
  Sample(int surface, double u, double v) {
    std::vector<double> low, high, x, n, k1, k2, d1, d2;
    gmsh::model::getParametrizationBounds(2, surface, low, high);
    const std::vector<double> at{low[0] + u * (high[0] - low[0]), low[1] + v * (high[1] - low[1])};
    gmsh::model::getValue(2, surface, at, x);
    gmsh::model::getNormal(surface, at, n);
    gmsh::model::getPrincipalCurvatures(surface, at, k1, k2, d1, d2);
    const bool first = std::abs(k1[0]) <= std::abs(k2[0]);
    point = vector_of(x), normal = vector_of(n).normalized();
    flat_along = vector_of(first ? d1 : d2).normalized();
    flat = std::abs(first ? k1[0] : k2[0]), sharp = std::abs(first ? k2[0] : k1[0]);
  }
  /// Where the sharp curvature has its centre, on one side of the surface or on the other (side = -1).
  Vector3d centre(double side) const { return point + side / sharp * normal; }
};

/// The side on which the centres of two places, seen along `axis`, are one: normals of gmsh point either way.
double side_of(const Sample &a, const Sample &b, const Vector3d &axis) {
  const auto apart = [&](double side) {
    const Vector3d between = a.centre(side) - b.centre(side);
    return (between - between.dot(axis) * axis).norm();
  };
  return apart(1) <= apart(-1) ? 1 : -1;
}

/// The tube's middles at three places around it lie on one circle.
void shape_torus(int surface, SurfaceShape &shape) {
  const double side = side_of({surface, 0.2, 0.3}, {surface, 0.2, 0.6}, Vector3d::Zero());
  const Vector3d a = Sample(surface, 0.2, 0.4).centre(side), b = Sample(surface, 0.5, 0.4).centre(side),
                 c = Sample(surface, 0.8, 0.4).centre(side), u = b - a, v = c - a;
  const Vector3d across = u.cross(v);
  shape.radius = 1 / Sample(surface, 0.5, 0.4).sharp;
  shape.axis = across.normalized();
  shape.centre =
      a + (u.squaredNorm() * v.cross(across) + v.squaredNorm() * across.cross(u)) / (2 * across.squaredNorm());
  shape.around = (a - *shape.centre).norm();
}

} // namespace

SurfaceShape surface_shape(int surface) {
  SurfaceShape shape;
  gmsh::model::getType(2, surface, shape.kind);
  if (shape.kind == "Plane") shape.axis = Sample(surface, 0.5, 0.5).normal;
  if (shape.kind == "Torus") shape_torus(surface, shape);
  if (shape.kind != "Sphere" && shape.kind != "Cylinder") return shape;
  const Sample middle(surface, 0.5, 0.5), other(surface, 0.3, 0.3);
  const Vector3d axis = shape.kind == "Cylinder" ? middle.flat_along : Vector3d::Zero();
  shape.radius = 1 / middle.sharp;
  shape.centre = middle.centre(side_of(middle, other, axis));
  if (shape.kind == "Cylinder") shape.axis = axis;
  return shape;
}

} // namespace rimpact::meshes
