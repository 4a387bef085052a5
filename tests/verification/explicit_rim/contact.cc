#include "contact.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace explicit_rim {
namespace {

Vec3 minus(const Vec3 &a, const Vec3 &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vec3 cross(const Vec3 &a, const Vec3 &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A face at r, s in -1..1.
struct Spot {
  std::array<double, 4> n;
  Vec3 at{}, along_r{}, along_s{};
  Spot(const std::array<int, 4> &face, const std::vector<Vec3> &x, double r, double s)
      : n{(1 - r) * (1 - s) / 4, (1 + r) * (1 - s) / 4, (1 + r) * (1 + s) / 4, (1 - r) * (1 + s) / 4} {
    const std::array<double, 4> dr{-(1 - s) / 4, (1 - s) / 4, (1 + s) / 4, -(1 + s) / 4},
        ds{-(1 - r) / 4, -(1 + r) / 4, (1 + r) / 4, (1 - r) / 4};
    for (int a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i)
        at[i] += n[a] * x[face[a]][i], along_r[i] += dr[a] * x[face[a]][i], along_s[i] += ds[a] * x[face[a]][i];
  }
};

/// The closest point by Gauss and Newton; false where it lies beside the face.
bool project(const std::array<int, 4> &face, const std::vector<Vec3> &x, const Vec3 &from, double &r, double &s) {
  constexpr double beside = 1.02;
  r = s = 0;
  for (int i = 0; i < 6; ++i) {
    const Spot spot(face, x, r, s);
    const Vec3 off = minus(from, spot.at);
    const double a = dot(spot.along_r, spot.along_r), b = dot(spot.along_r, spot.along_s),
                 c = dot(spot.along_s, spot.along_s);
    const double p = dot(spot.along_r, off), q = dot(spot.along_s, off), D = a * c - b * b;
    const double dr = (p * c - q * b) / D, ds = (a * q - b * p) / D;
    r += dr, s += ds;
    if (std::abs(r) > 3 || std::abs(s) > 3) return false;
    if (std::abs(dr) + std::abs(ds) < 1e-9) break;
  }
  return std::abs(r) <= beside && std::abs(s) <= beside;
}

} // namespace

Contact::Contact(Faces one, Faces other, const std::vector<Vec3> &x, const ContactOptions &options)
    : options_(options) {
  passes_[0].faces = other, passes_[1].faces = one;
  for (int side = 0; side < 2; ++side) {
    std::map<int, double> area;
    for (const auto &face : side == 0 ? one : other) {
      const Spot middle(face, x, 0, 0);
      const Vec3 n = cross(middle.along_r, middle.along_s);
      for (const int node : face) area[node] += std::sqrt(dot(n, n));
    }
    for (const auto &[node, own] : area) passes_[side].nodes.push_back(node), passes_[side].area.push_back(own);
  }
}

void Contact::search(Pass &pass, const std::vector<Vec3> &x) const {
  constexpr std::size_t most = 8;
  std::vector<Vec3> middles;
  for (const auto &face : pass.faces) middles.push_back(Spot(face, x, 0, 0).at);
  pass.near.assign(pass.nodes.size(), {});
  std::vector<int> all(pass.faces.size());
  std::iota(all.begin(), all.end(), 0);
  for (std::size_t i = 0; i < pass.nodes.size(); ++i) {
    const auto distance = [&](int f) {
      return dot(minus(middles[f], x[pass.nodes[i]]), minus(middles[f], x[pass.nodes[i]]));
    };
    auto sorted = all;
    const auto n = std::min(most, sorted.size());
    std::partial_sort(sorted.begin(), sorted.begin() + n, sorted.end(),
                      [&](int a, int b) { return distance(a) < distance(b); });
    pass.near[i].assign(sorted.begin(), sorted.begin() + n);
  }
}

Vec3 Contact::one_pass(const Pass &pass, const std::vector<Vec3> &x, const std::vector<Vec3> &v,
                       std::vector<Vec3> &force) const {
  Vec3 sum{};
  for (std::size_t i = 0; i < pass.nodes.size(); ++i) {
    const int node = pass.nodes[i];
    for (const int f : pass.near[i]) {
      const auto &face = pass.faces[f];
      double r, s;
      if (!project(face, x, x[node], r, s)) continue;
      const Spot spot(face, x, r, s);
      Vec3 normal = cross(spot.along_r, spot.along_s);
      const double length = std::sqrt(dot(normal, normal));
      for (double &component : normal) component /= length;
      const double gap = dot(minus(x[node], spot.at), normal);
      if (gap >= 0 || gap < -options_.reach) break;
      Vec3 slip = v[node];
      for (int a = 0; a < 4; ++a)
        for (int j = 0; j < 3; ++j) slip[j] -= spot.n[a] * v[face[a]][j];
      const double across = dot(slip, normal), push = -options_.stiffness / 2 * gap * pass.area[i];
      for (int j = 0; j < 3; ++j) slip[j] -= across * normal[j];
      const double speed = std::sqrt(dot(slip, slip)),
                   hold = options_.friction * push / std::max(speed, options_.creep);
      for (int j = 0; j < 3; ++j) {
        const double total = push * normal[j] - hold * slip[j];
        force[node][j] += total, sum[j] += total;
        for (int a = 0; a < 4; ++a) force[face[a]][j] -= spot.n[a] * total;
      }
      break;
    }
  }
  return sum;
}

Vec3 Contact::push(const std::vector<Vec3> &x, const std::vector<Vec3> &v, std::vector<Vec3> &force) {
  constexpr int every = 200;
  if (calls_++ % every == 0)
    for (auto &pass : passes_) search(pass, x);
  const Vec3 a = one_pass(passes_[0], x, v, force), b = one_pass(passes_[1], x, v, force);
  return minus(a, b);
}

} // namespace explicit_rim
