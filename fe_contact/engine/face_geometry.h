/// Points on a deformed quadrilateral face (Lagrange, degree 1 or 2), and the closest-point projection onto
/// it.
#pragma once
#include <array>
#include <Eigen/Core>

namespace rimpact::fe {

/// Lagrange shape functions of a face at (xi, eta) in [-1, 1]^2, lexicographic, with derivatives.
struct FaceShapes {
  static constexpr int max_nodes = 9;
  int n = 0;
  double N[max_nodes], dxi[max_nodes], deta[max_nodes], dxixi[max_nodes], dxieta[max_nodes], detaeta[max_nodes];
};
FaceShapes face_shapes(int degree, double xi, double eta);

/// Nodal coordinates of a face, one column a node.
using FaceNodes = Eigen::Matrix<double, 3, FaceShapes::max_nodes>;

struct Projection {
  bool converged = false;
  double xi = 0, eta = 0;
  FaceShapes shapes;
  Eigen::Vector3d point;
  std::array<Eigen::Vector3d, 2> tangent;
  std::array<Eigen::Vector3d, 3> second; ///< derivatives: xixi, xieta, etaeta
};
/// Closest point of the (extended) face to x, started at (xi, eta). Stops when it wanders beyond |xi| = 3.
Projection project(const Eigen::Vector3d &x, const FaceNodes &nodes, int degree, double xi, double eta);

} // namespace rimpact::fe
