#include "meshes/half_disc.h"

#include "meshes/core_polygon.h"
#include <algorithm>
#include <cmath>

namespace rimpact::meshes {
namespace {

/// On a circle about the origin, on the axes exactly.
Point2 on_circle(double r, double angle) {
  const double x = std::cos(angle), y = std::sin(angle);
  return {std::abs(x) < 1e-12 ? 0 : r * x, std::abs(y) < 1e-12 ? 0 : r * y};
}

/// Of a quarter, not a half.
bool is_quarter(const std::vector<double> &angles) {
  return angles.back() < 0.75 * M_PI;
}

/// Steps narrower than `least` of the mean one widened to it, at the others' cost: lines that are fine on the arc would
/// meet in slivers further in. 0: as they are.
std::vector<double> widened(const std::vector<double> &angles, double least) {
  if (least == 0) return angles;
  const double narrowest = least * angles.back() / (angles.size() - 1);
  std::vector<double> result{0};
  for (std::size_t k = 0; k + 1 < angles.size(); ++k)
    result.push_back(result.back() + std::max(angles[k + 1] - angles[k], narrowest));
  const double scale = angles.back() / result.back();
  for (double &angle : result) angle *= scale;
  return result;
}

/// Nodes of the polygon's outer side that gmsh fills: corners at the even angles, the middles of its edges between
/// them.
std::vector<Point2> polygon(double radius, const std::vector<double> &angles) {
  constexpr double share = 0.55;
  const auto corner = [&](std::size_t k) { return on_circle(share * radius, angles[k]); };
  std::vector<Point2> result{corner(0)};
  for (std::size_t k = 2; k < angles.size(); k += 2) {
    const Point2 a = result.back(), b = corner(k);
    result.insert(result.end(), {{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}, b});
  }
  return result;
}

std::vector<Quad9> disc(double radius, const std::vector<double> &angles, const std::vector<Point2> &polygon,
                        double size) {
  std::vector<Quad9> quads = polygon_quads(polygon, is_quarter(angles), size);
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    const auto arc = [&](double angle) { return on_circle(radius, angle); };
    Quad9 quad = straight_quad(polygon[k], arc(angles[k]), arc(angles[k + 1]), polygon[k + 1], Volume::upper_slider);
    quad.nodes[5] = arc(0.5 * (angles[k] + angles[k + 1]));
    centre(quad);
    quads.push_back(quad);
  }
  return quads;
}

/// Smallest sine of an angle between two edges, below zero where a quadrilateral is turned over; of the `core` first
/// ones also twice the smallest ratio of two edges, and five times that of an edge to the wanted `size`.
double soundness(const std::vector<Quad9> &quads, std::size_t core, double size) {
  constexpr int around[4] = {0, 2, 8, 6};
  double smallest = 1;
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (int c = 0; c < 4; ++c) {
      const auto at = [&](int shift) { return quads[q].nodes[around[(c + shift) % 4]]; };
      const double a[2] = {at(1)[0] - at(0)[0], at(1)[1] - at(0)[1]}, b[2] = {at(3)[0] - at(0)[0], at(3)[1] - at(0)[1]},
                   la = std::hypot(a[0], a[1]), lb = std::hypot(b[0], b[1]);
      smallest = std::min(smallest, (a[0] * b[1] - a[1] * b[0]) / (la * lb));
      if (q < core) smallest = std::min({smallest, 2 * la / lb, 2 * lb / la, 5 * la / size});
    }
  return smallest;
}

/// Of the half or the quarter that the angles go round, as sound as widening its inner lines makes it.
std::vector<Quad9> soundest(double radius, const std::vector<double> &angles, double size) {
  constexpr double sound = 0.13;
  std::vector<Quad9> quads;
  double best = -1;
  for (const double finer : {1.0, 0.7, 0.5})
    for (const double least : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
      if (best > sound) break;
      auto tried = disc(radius, angles, polygon(radius, widened(angles, least)), finer * size);
      const double reached = soundness(tried, tried.size() + 1 - angles.size(), size);
      if (reached > best) best = reached, quads = std::move(tried);
    }
  return quads;
}

void mark_symmetry(std::vector<Quad9> &quads) {
  constexpr int ends[4][2] = {{0, 6}, {2, 8}, {0, 2}, {6, 8}};
  for (auto &quad : quads)
    for (int e = 0; e < 4; ++e)
      if (quad.nodes[ends[e][0]][1] == 0 && quad.nodes[ends[e][1]][1] == 0) quad.groups[e] = Surface::symmetry;
}

/// In the plane x = 0.
Quad9 image_of(const Quad9 &quad) {
  Quad9 result = quad;
  for (int k = 0; k < 9; ++k) {
    const auto &[x, y] = quad.nodes[k - k % 3 + 2 - k % 3];
    result.nodes[k] = {x == 0 ? 0.0 : -x, y};
  }
  return result;
}

} // namespace

std::vector<Quad9> half_disc(double radius, const std::vector<double> &angles, double size) {
  std::vector<Quad9> quads = soundest(radius, angles, size);
  mark_symmetry(quads);
  return quads;
}

std::vector<Quad9> symmetric_half_disc(double radius, const std::vector<double> &quarter, double size) {
  std::vector<Quad9> quads = soundest(radius, quarter, size);
  const std::size_t n = quads.size();
  for (std::size_t k = 0; k < n; ++k) quads.push_back(image_of(quads[k]));
  mark_symmetry(quads);
  return quads;
}

std::vector<double> halved(const std::vector<double> &lines) {
  std::vector<double> result;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    result.push_back(lines[k]);
    result.push_back(0.5 * (lines[k] + lines[k + 1]));
  }
  result.push_back(lines.back());
  return result;
}

} // namespace rimpact::meshes
