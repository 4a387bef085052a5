#include "solid.h"

#include <algorithm>
#include <cmath>

namespace explicit_rim {
namespace {

/// Derivatives of the 8 shape functions at the 8 Gauss points.
struct Shape {
  double d[8][8][3], n[8][8];
  Shape() {
    const double g = 1 / std::sqrt(3.0);
    const int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                            {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    for (int q = 0; q < 8; ++q)
      for (int a = 0; a < 8; ++a) {
        double f[3];
        for (int i = 0; i < 3; ++i) f[i] = (1 + sign[a][i] * sign[q][i] * g) / 2;
        n[q][a] = f[0] * f[1] * f[2];
        for (int i = 0; i < 3; ++i) d[q][a][i] = sign[a][i] * f[(i + 1) % 3] * f[(i + 2) % 3] / 2;
      }
  }
};
const Shape shape;

/// Gradients of the shape functions at each point, and the volumes of the points.
struct Gradients {
  double g[8][8][3], volume[8];
  template <class Nodes> explicit Gradients(const Nodes &x) {
    for (int q = 0; q < 8; ++q) {
      double J[3][3] = {};
      for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) J[i][j] += x[a][i] * shape.d[q][a][j];
      double C[3][3];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
          C[i][j] = J[i1][j1] * J[i2][j2] - J[i1][j2] * J[i2][j1];
        }
      volume[q] = J[0][0] * C[0][0] + J[0][1] * C[0][1] + J[0][2] * C[0][2];
      for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i)
          g[q][a][i] =
              (C[i][0] * shape.d[q][a][0] + C[i][1] * shape.d[q][a][1] + C[i][2] * shape.d[q][a][2]) / volume[q];
    }
  }
};

/// Plastic strain of a step: trial - 3 G gain = (yield + H gain) (1 + (gain / dt / D)^(1/q)). In the root s =
/// gain^(1/q) it is a convex polynomial, which Newton's method comes down from the gain without a rate.
double plastic_gain(double trial, double yield, double dt, const Steel &steel) {
  const double stiff = 3 * steel.shear + steel.hardening, without = (trial - yield) / stiff, q = steel.rate_q;
  if (steel.rate_D <= 0) return without;
  const double scale = std::pow(dt * steel.rate_D, -1 / q);
  double s = std::pow(without, 1 / q);
  for (int i = 0; i < 60; ++i) {
    const double gain = std::pow(s, q), slope = q * gain / s, flow = yield + steel.hardening * gain;
    const double off = stiff * gain + flow * scale * s - (trial - yield);
    const double less = off / (stiff * slope + steel.hardening * slope * scale * s + flow * scale);
    s -= less;
    if (std::abs(less) < 1e-10 * s) break;
  }
  return std::pow(s, q);
}

/// Jaumann's rate, then radial return; the plastic work per volume.
double update(Point &point, const double L[3][3], double divergence, double dt, const Steel &steel) {
  auto &s = point.stress;
  const double wz = (L[1][0] - L[0][1]) / 2 * dt, wx = (L[2][1] - L[1][2]) / 2 * dt, wy = (L[0][2] - L[2][0]) / 2 * dt;
  const auto [xx, yy, zz, xy, yz, zx] = s;
  // W s - s W, with W the spin: w = (wx, wy, wz)
  s[0] += 2 * (-wz * xy + wy * zx), s[1] += 2 * (wz * xy - wx * yz), s[2] += 2 * (-wy * zx + wx * yz);
  s[3] += wz * (xx - yy) + wy * yz - wx * zx;
  s[4] += wx * (yy - zz) + wz * zx - wy * xy;
  s[5] += wy * (zz - xx) + wx * xy - wz * yz;
  const double mean = (L[0][0] + L[1][1] + L[2][2]) / 3, G2 = 2 * steel.shear * dt;
  const double p = (s[0] + s[1] + s[2]) / 3 + steel.bulk * divergence * dt, old = (s[0] + s[1] + s[2]) / 3;
  double e[6];
  for (int i = 0; i < 3; ++i) e[i] = s[i] - old + G2 * (L[i][i] - mean);
  e[3] = s[3] + G2 * (L[0][1] + L[1][0]) / 2, e[4] = s[4] + G2 * (L[1][2] + L[2][1]) / 2;
  e[5] = s[5] + G2 * (L[2][0] + L[0][2]) / 2;
  const double trial =
      std::sqrt(1.5 * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + 2 * (e[3] * e[3] + e[4] * e[4] + e[5] * e[5])));
  const double yield = steel.yield + steel.hardening * point.plastic;
  double work = 0, share = 1;
  if (trial > yield) {
    const double gain = plastic_gain(trial, yield, dt, steel);
    share = 1 - 3 * steel.shear * gain / trial, point.plastic += gain, work = gain * share * trial;
  }
  for (int i = 0; i < 6; ++i) s[i] = share * e[i] + (i < 3 ? p : 0);
  return work;
}

} // namespace

Solid::Solid(std::vector<Vec3> nodes, std::vector<std::array<int, 8>> cells, const Steel &steel, double longest_step)
    : nodes_(std::move(nodes)), cells_(std::move(cells)), steel_(steel), points_(8 * cells_.size()),
      mass_(nodes_.size()) {
  const double modulus = steel.bulk + 4 * steel.shear / 3, safety = 0.8;
  for (const auto &c : cells_) {
    std::array<Vec3, 8> x;
    for (int a = 0; a < 8; ++a) x[a] = nodes_[c[a]];
    const Gradients at(x);
    double square = 0, volume = 0;
    for (int q = 0; q < 8; ++q) {
      double sum = 0; // the largest eigenvalue is at most modulus * sum of |gradient|^2 over the mass of a node's share
      for (int a = 0; a < 8; ++a)
        sum += dot({at.g[q][a][0], at.g[q][a][1], at.g[q][a][2]}, {at.g[q][a][0], at.g[q][a][1], at.g[q][a][2]});
      square = std::max(square, sum), volume += at.volume[q];
    }
    const double step = safety * 2 / std::sqrt(8 * modulus * square / steel.density);
    const double heavier = std::max(1.0, std::pow(longest_step / step, 2));
    added_ += (heavier - 1) * steel.density * volume;
    for (int q = 0; q < 8; ++q)
      for (int a = 0; a < 8; ++a) mass_[c[a]] += heavier * steel.density * shape.n[q][a] * at.volume[q];
  }
}

void Solid::advance(const std::vector<Vec3> &x, const std::vector<Vec3> &v, double step, std::vector<Vec3> &force) {
  for (std::size_t c = 0; c < cells_.size(); ++c) cell(cells_[c], &points_[8 * c], x, v, step, force);
}

void Solid::cell(const std::array<int, 8> &nodes, Point *points, const std::vector<Vec3> &x, const std::vector<Vec3> &v,
                 double step, std::vector<Vec3> &force) {
  std::array<Vec3, 8> own, rate;
  for (int a = 0; a < 8; ++a) own[a] = x[nodes[a]], rate[a] = v[nodes[a]];
  const Gradients at(own);
  double mean[8][3] = {}, volume = 0;
  for (int q = 0; q < 8; ++q) {
    volume += at.volume[q];
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i) mean[a][i] += at.g[q][a][i] * at.volume[q];
  }
  double divergence = 0, pressure = 0, f[8][3] = {};
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i) mean[a][i] /= volume, divergence += mean[a][i] * rate[a][i];
  for (int q = 0; q < 8; ++q) {
    double L[3][3] = {};
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) L[i][j] += rate[a][i] * at.g[q][a][j];
    plastic_ += at.volume[q] * update(points[q], L, divergence, step, steel_);
    const auto &s = points[q].stress;
    const double p = (s[0] + s[1] + s[2]) / 3, V = at.volume[q];
    pressure += p * V;
    for (int a = 0; a < 8; ++a) {
      const double *g = at.g[q][a];
      f[a][0] += V * ((s[0] - p) * g[0] + s[3] * g[1] + s[5] * g[2]);
      f[a][1] += V * (s[3] * g[0] + (s[1] - p) * g[1] + s[4] * g[2]);
      f[a][2] += V * (s[5] * g[0] + s[4] * g[1] + (s[2] - p) * g[2]);
    }
  }
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i) force[nodes[a]][i] -= f[a][i] + pressure * mean[a][i];
}

double Solid::largest_plastic_strain() const {
  double most = 0;
  for (const auto &point : points_) most = std::max(most, point.plastic);
  return most;
}

} // namespace explicit_rim
