#include "fe_contact/engine/face_geometry.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <limits>

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
  // On a face whose corner is nearly straight a full step from the middle can lead away for good, so steps are bounded,
  // and halved until the point comes nearer.
  constexpr double longest = 1.0; // half widths
  Projection p;
  p.xi = xi;
  p.eta = eta;
  Eigen::Vector2d step = Eigen::Vector2d::Zero();
  double nearest = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 40; ++iteration) {
    p.shapes = face_shapes(degree, p.xi, p.eta);
    evaluate(p, nodes);
    const Eigen::Vector3d distance = x - p.point;
    const double square = distance.squaredNorm();
    if (square > nearest * (1 + 1e-9) && step.cwiseAbs().maxCoeff() > 1e-6) {
      step *= 0.5;
      p.xi -= step[0];
      p.eta -= step[1];
      continue;
    }
    nearest = square;
    const Eigen::Vector2d residual(p.tangent[0].dot(distance), p.tangent[1].dot(distance));
    Eigen::Matrix2d metric, hessian;
    metric << p.tangent[0].squaredNorm(), p.tangent[0].dot(p.tangent[1]), p.tangent[0].dot(p.tangent[1]),
        p.tangent[1].squaredNorm();
    hessian << p.second[0].dot(distance), p.second[1].dot(distance), p.second[1].dot(distance),
        p.second[2].dot(distance);
    Eigen::Matrix2d tangent = metric - hessian;
    if (tangent.determinant() <= 0.1 * metric.determinant() || tangent.trace() <= 0)
      tangent = metric; // far away: Gauss-Newton
    const Eigen::Vector2d change = tangent.inverse() * residual;
    const double size = change.cwiseAbs().maxCoeff();
    if (size < 1e-13) {
      p.converged = true;
      return p;
    }
    step = change * std::min(1.0, longest / size);
    p.xi += step[0];
    p.eta += step[1];
    if (std::abs(p.xi) > 3 || std::abs(p.eta) > 3) return p;
  }
  // Rounding can keep the change just above the threshold; the last point is as close as doubles allow.
  p.shapes = face_shapes(degree, p.xi, p.eta);
  evaluate(p, nodes);
  p.converged = std::isfinite(p.xi) && std::isfinite(p.eta);
  return p;
}

} // namespace rimpact::fe
