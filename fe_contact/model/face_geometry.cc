#include "fe_contact/model/face_geometry.h"

#include <cmath>
#include <Eigen/LU>

namespace rimpact::fe {
namespace {

/// One-dimensional Lagrange polynomials on [-1, 1] with first and second derivatives.
struct Line {
  double value[3], first[3], second[3];
};
Line line(int degree, double x) {
  if (degree == 1) return {{(1 - x) / 2, (1 + x) / 2}, {-0.5, 0.5}, {0, 0}};
  return {{x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2}, {x - 0.5, -2 * x, x + 0.5}, {1, -2, 1}};
}

void evaluate(Projection &p, const FaceNodes &nodes) {
  p.point = p.tangent[0] = p.tangent[1] = p.second[0] = p.second[1] = p.second[2] = Eigen::Vector3d::Zero();
  for (int a = 0; a < p.shapes.n; ++a) {
    p.point += p.shapes.N[a] * nodes.col(a);
    p.tangent[0] += p.shapes.dxi[a] * nodes.col(a);
    p.tangent[1] += p.shapes.deta[a] * nodes.col(a);
    p.second[0] += p.shapes.dxixi[a] * nodes.col(a);
    p.second[1] += p.shapes.dxieta[a] * nodes.col(a);
    p.second[2] += p.shapes.detaeta[a] * nodes.col(a);
  }
}

} // namespace

FaceShapes face_shapes(int degree, double xi, double eta) {
  const Line s = line(degree, xi), t = line(degree, eta);
  FaceShapes result;
  for (int j = 0; j <= degree; ++j)
    for (int i = 0; i <= degree; ++i) {
      const int a = result.n++;
      result.N[a] = s.value[i] * t.value[j];
      result.dxi[a] = s.first[i] * t.value[j];
      result.deta[a] = s.value[i] * t.first[j];
      result.dxixi[a] = s.second[i] * t.value[j];
      result.dxieta[a] = s.first[i] * t.first[j];
      result.detaeta[a] = s.value[i] * t.second[j];
    }
  return result;
}

Projection project(const Eigen::Vector3d &x, const FaceNodes &nodes, int degree, double xi, double eta) {
  Projection p;
  p.xi = xi;
  p.eta = eta;
  for (int iteration = 0; iteration < 20; ++iteration) {
    p.shapes = face_shapes(degree, p.xi, p.eta);
    evaluate(p, nodes);
    const Eigen::Vector3d distance = x - p.point;
    const Eigen::Vector2d residual(p.tangent[0].dot(distance), p.tangent[1].dot(distance));
    Eigen::Matrix2d metric, hessian;
    metric << p.tangent[0].squaredNorm(), p.tangent[0].dot(p.tangent[1]), p.tangent[0].dot(p.tangent[1]),
        p.tangent[1].squaredNorm();
    hessian << p.second[0].dot(distance), p.second[1].dot(distance), p.second[1].dot(distance),
        p.second[2].dot(distance);
    Eigen::Matrix2d tangent = metric - hessian;
    if (tangent.determinant() <= 0.1 * metric.determinant()) tangent = metric; // far away: Gauss-Newton
    const Eigen::Vector2d change = tangent.inverse() * residual;
    if (change.cwiseAbs().maxCoeff() < 1e-13) {
      p.converged = true;
      return p;
    }
    p.xi += change[0];
    p.eta += change[1];
    if (std::abs(p.xi) > 3 || std::abs(p.eta) > 3) return p;
  }
  // Rounding can keep the change just above the threshold; the last point is as close as doubles allow.
  p.shapes = face_shapes(degree, p.xi, p.eta);
  evaluate(p, nodes);
  p.converged = std::isfinite(p.xi) && std::isfinite(p.eta);
  return p;
}

} // namespace rimpact::fe
