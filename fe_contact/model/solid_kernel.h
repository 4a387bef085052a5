/// The hot loops of one cell: deformation gradients, internal forces and tangent of n nodes at one point.
/// Blocks are stored [i][k][a][b] with b contiguous so that the compiler vectorises over nodes.
#pragma once
#include "fe_contact/laws/hencky_j2.h"
#include <array>
#include <cstring>
#include <Eigen/LU>

namespace rimpact::fe {

template <int n> struct CellKernel {
  static constexpr int padded = (n + 3) / 4 * 4;
  alignas(32) double force[3][padded];
  alignas(32) double block[3][3][n][padded]; ///< upper in (a, b); diagonal blocks are full
  alignas(32) double u[3][n];

  void clear() {
    std::memset(force, 0, sizeof(force));
    std::memset(block, 0, sizeof(block));
  }

  /// F = 1 + sum_a u_a x grad N_a; G: [direction][node].
  Matrix3 deformation_gradient(const double *G) const {
    Matrix3 F = Matrix3::Identity();
    for (int i = 0; i < 3; ++i)
      for (int J = 0; J < 3; ++J) {
        double sum = 0.0;
        for (int a = 0; a < n; ++a) sum += u[i][a] * G[J * n + a];
        F(i, J) += sum;
      }
    return F;
  }

  /// Adds weight * (B^T tau) and, if asked, weight * (B^T c B + grad tau grad).
  void add(const double *G, const Matrix3 &F, double weight, const StressAndTangent &s, bool with_tangent) {
    alignas(32) double g[3][padded] = {};
    const Matrix3 inverse = F.inverse();
    for (int j = 0; j < 3; ++j)
      for (int a = 0; a < n; ++a)
        g[j][a] = G[a] * inverse(0, j) + G[n + a] * inverse(1, j) + G[2 * n + a] * inverse(2, j);
    const Vector6 t = weight * s.stress;
    alignas(32) double traction[3][padded]; // tau g_a
    for (int a = 0; a < padded; ++a) {
      traction[0][a] = t[0] * g[0][a] + t[3] * g[1][a] + t[5] * g[2][a];
      traction[1][a] = t[3] * g[0][a] + t[1] * g[1][a] + t[4] * g[2][a];
      traction[2][a] = t[5] * g[0][a] + t[4] * g[1][a] + t[2] * g[2][a];
    }
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < padded; ++a) force[i][a] += traction[i][a];
    if (with_tangent) add_tangent(g, traction, weight * s.tangent);
  }

private:
  void add_tangent(const double (&g)[3][padded], const double (&traction)[3][padded], const Matrix6 &c) {
    alignas(32) double cb[3][6][padded]; // c B_b, [component k][stress v][node b]
    for (int v = 0; v < 6; ++v)
      for (int b = 0; b < padded; ++b) {
        cb[0][v][b] = c(v, 0) * g[0][b] + c(v, 3) * g[1][b] + c(v, 5) * g[2][b];
        cb[1][v][b] = c(v, 3) * g[0][b] + c(v, 1) * g[1][b] + c(v, 4) * g[2][b];
        cb[2][v][b] = c(v, 5) * g[0][b] + c(v, 4) * g[1][b] + c(v, 2) * g[2][b];
      }
    constexpr int voigt[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    for (int a = 0; a < n; ++a) {
      const int first = a / 4 * 4;
      const double ga[3] = {g[0][a], g[1][a], g[2][a]};
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
          double *row = block[i][k][a];
          const double *c0 = cb[k][voigt[i][0]], *c1 = cb[k][voigt[i][1]], *c2 = cb[k][voigt[i][2]];
          for (int b = first; b < padded; ++b) row[b] += ga[0] * c0[b] + ga[1] * c1[b] + ga[2] * c2[b];
        }
      for (int b = first; b < padded; ++b) {
        const double geometric = ga[0] * traction[0][b] + ga[1] * traction[1][b] + ga[2] * traction[2][b];
        block[0][0][a][b] += geometric;
        block[1][1][a][b] += geometric;
        block[2][2][a][b] += geometric;
      }
    }
  }
};

} // namespace rimpact::fe
