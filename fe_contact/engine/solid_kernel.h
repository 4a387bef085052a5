/// The hot loops of one cell: deformation gradients, internal forces and tangent of n nodes at one point.
/// Blocks are stored [i][k][a][b] with b contiguous, four nodes to a vector. They are too large for the first cache:
/// four points are summed up at a time, so that the blocks are passed once for all four.
#pragma once
#include "fe_contact/laws/hencky_j2.h"
#include <algorithm>
#include <cstring>
#include <Eigen/LU>

namespace rimpact::fe {

template <int n> struct CellKernel {
  using Lanes [[gnu::vector_size(32), gnu::may_alias]] = double; ///< four nodes at a time
  static constexpr int padded = (n + 3) / 4 * 4;
  static constexpr int batch = 4;
  alignas(32) double force[3][padded];
  alignas(32) double block[3][3][padded][padded]; ///< upper in (a, b); diagonal blocks are full
  alignas(32) double u[3][n];

  void clear(bool with_tangent) {
    std::memset(force, 0, sizeof(force));
    if (with_tangent) std::memset(block, 0, sizeof(block));
    waiting_ = 0;
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
    double(&g)[3][padded] = gradient_[waiting_];
    double(&t)[3][padded] = traction_[waiting_];
    const Matrix3 inverse = F.inverse();
    for (int j = 0; j < 3; ++j) {
      for (int a = 0; a < n; ++a)
        g[j][a] = G[a] * inverse(0, j) + G[n + a] * inverse(1, j) + G[2 * n + a] * inverse(2, j);
      std::fill(g[j] + n, g[j] + padded, 0.0);
    }
    const Vector6 tau = weight * s.stress;
    for (int a = 0; a < padded; ++a) {
      t[0][a] = tau[0] * g[0][a] + tau[3] * g[1][a] + tau[5] * g[2][a];
      t[1][a] = tau[3] * g[0][a] + tau[1] * g[1][a] + tau[4] * g[2][a];
      t[2][a] = tau[5] * g[0][a] + tau[4] * g[1][a] + tau[2] * g[2][a];
    }
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < padded; ++a) force[i][a] += t[i][a];
    if (!with_tangent) return;
    const Matrix6 c = weight * s.tangent;
    for (int v = 0; v < 6; ++v)
      for (int b = 0; b < padded; ++b) {
        cb_[0][v][waiting_][b] = c(v, 0) * g[0][b] + c(v, 3) * g[1][b] + c(v, 5) * g[2][b];
        cb_[1][v][waiting_][b] = c(v, 3) * g[0][b] + c(v, 1) * g[1][b] + c(v, 4) * g[2][b];
        cb_[2][v][waiting_][b] = c(v, 5) * g[0][b] + c(v, 4) * g[1][b] + c(v, 2) * g[2][b];
      }
    if (++waiting_ == batch) sum_up();
  }

  /// To be called after the last add(): the blocks are complete then.
  void finish() {
    if (waiting_ == 0) return;
    for (int p = waiting_; p < batch; ++p) {
      std::memset(gradient_[p], 0, sizeof(gradient_[p]));
      std::memset(traction_[p], 0, sizeof(traction_[p]));
      for (int k = 0; k < 3; ++k)
        for (int v = 0; v < 6; ++v) std::memset(cb_[k][v][p], 0, sizeof(cb_[k][v][p]));
    }
    sum_up();
  }

private:
  using PairOfNodes = Lanes[2][3][batch]; ///< their gradients, each value on all lanes

  void sum_up() {
    waiting_ = 0;
    for (int a = 0; a < padded; a += 2) {
      PairOfNodes ga;
      for (int r = 0; r < 2; ++r)
        for (int j = 0; j < 3; ++j)
          for (int p = 0; p < batch; ++p) ga[r][j][p] = Lanes{} + gradient_[p][j][a + r];
      for (int b = a / 4 * 4; b < padded; b += 4) {
        Lanes geometric[2] = {};
        for (int p = 0; p < batch; ++p)
          for (int j = 0; j < 3; ++j)
            for (int r = 0; r < 2; ++r) geometric[r] += ga[r][j][p] * lanes(&traction_[p][j][b]);
        for (int r = 0; r < 2; ++r)
          for (int i = 0; i < 3; ++i) lanes(&block[i][i][a + r][b]) += geometric[r];
      }
      add_rows<0>(a, ga);
      add_rows<1>(a, ga);
      add_rows<2>(a, ga);
    }
  }

  template <int i> void add_rows(int a, const PairOfNodes &ga) {
    constexpr int voigt[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    for (int k = 0; k < 3; ++k)
      for (int b = a / 4 * 4; b < padded; b += 4) {
        Lanes sum[2] = {lanes(&block[i][k][a][b]), lanes(&block[i][k][a + 1][b])};
        for (int p = 0; p < batch; ++p)
          for (int j = 0; j < 3; ++j) {
            const Lanes c = lanes(&cb_[k][voigt[i][j]][p][b]);
            sum[0] += ga[0][j][p] * c;
            sum[1] += ga[1][j][p] * c;
          }
        lanes(&block[i][k][a][b]) = sum[0];
        lanes(&block[i][k][a + 1][b]) = sum[1];
      }
  }

  static Lanes &lanes(double *x) { return *reinterpret_cast<Lanes *>(x); }

  // Of points not yet in the blocks, `waiting_` of them:
  int waiting_ = 0;
  alignas(32) double gradient_[batch][3][padded]; ///< of the shape functions, in the deformed body
  alignas(32) double traction_[batch][3][padded]; ///< tau g_a
  alignas(32) double cb_[3][6][batch][padded];    ///< c B_b, [component k][stress v][point][node b]
};

} // namespace rimpact::fe
