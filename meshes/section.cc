#include "meshes/section.h"

#include "meshes/hex_order.h"
#include <cmath>

namespace rimpact::meshes {
namespace {
Point2 middle(Point2 a, Point2 b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
}
} // namespace

Quad9 straight_quad(Point2 a, Point2 b, Point2 c, Point2 d, Volume volume) {
  Quad9 quad{{a, middle(a, b), b, middle(a, d), {}, middle(b, c), d, middle(d, c), c}, volume, {}};
  centre(quad);
  return quad;
}

void centre(Quad9 &quad) {
  auto &n = quad.nodes;
  for (int i = 0; i < 2; ++i)
    n[4][i] = 0.5 * (n[1][i] + n[3][i] + n[5][i] + n[7][i]) - 0.25 * (n[0][i] + n[2][i] + n[6][i] + n[8][i]);
}

std::vector<double> graded_lines(const std::vector<Anchor> &anchors) {
  std::vector<double> lines{anchors.front().at};
  for (std::size_t k = 0; k + 1 < anchors.size(); ++k) {
    const double a = anchors[k].at, length = anchors[k + 1].at - a, ratio = anchors[k + 1].size / anchors[k].size;
    const bool even = std::abs(ratio - 1) < 1e-3;
    const double wanted =
        even ? length / anchors[k].size : length / (anchors[k + 1].size - anchors[k].size) * std::log(ratio);
    const int n = std::max(1, static_cast<int>(std::ceil(wanted - 0.25)));
    for (int i = 1; i <= n; ++i) {
      const double t = double(i) / n;
      lines.push_back(i == n ? a + length : a + length * (even ? t : (std::pow(ratio, t) - 1) / (ratio - 1)));
    }
  }
  return lines;
}

double at_level(const std::vector<double> &lines, double level) {
  const std::size_t k = std::min(static_cast<std::size_t>(level), lines.size() - 2);
  return lines[k] + (level - k) * (lines[k + 1] - lines[k]);
}

Body::Body(const Body &other, const std::function<bool(const std::array<double, 3> &)> &tied) : mesh_(other.mesh_) {
  for (const auto &[key, node] : other.known_)
    if (tied(mesh_.nodes[node])) known_[key] = node;
}

void Body::add_cell(const std::function<std::array<double, 3>(int, int, int)> &place, Volume volume,
                    const std::map<int, Surface> &groups) {
  std::array<unsigned, 27> cell;
  for (int a = 0; a < 27; ++a) {
    const auto x = place(hex27[a][0], hex27[a][1], hex27[a][2]);
    const std::array<long, 3> key{std::lround(x[0] / merge_distance), std::lround(x[1] / merge_distance),
                                  std::lround(x[2] / merge_distance)};
    // Rounding may fall either side of a cell of the key's grid: look at the neighbours too.
    unsigned node = mesh_.nodes.size();
    for (int shift = 0; shift < 27; ++shift) {
      const auto found = known_.find({key[0] + shift % 3 - 1, key[1] + shift / 3 % 3 - 1, key[2] + shift / 9 - 1});
      if (found != known_.end()) node = found->second;
    }
    if (node == mesh_.nodes.size()) {
      mesh_.nodes.push_back(x);
      known_[key] = node;
    }
    cell[a] = node;
  }
  mesh_.cells.push_back(cell);
  mesh_.volumes.push_back(volume);
  for (const auto &[face, group] : groups) {
    const auto &c = hex_faces[face];
    mesh_.faces.push_back({{cell[c[0]], cell[c[1]], cell[c[2]], cell[c[3]]}, group});
  }
}

void Body::revolve(const std::vector<Quad9> &section, const std::vector<double> &angles, double axis_x,
                   std::optional<Surface> first, std::optional<Surface> last) {
  for (std::size_t k = 0; k + 1 < angles.size(); ++k)
    for (const auto &quad : section) {
      // xi = r, eta = angle, zeta = z
      std::map<int, Surface> groups;
      constexpr int face_of_edge[4] = {0, 1, 4, 5};
      for (const auto &[edge, group] : quad.groups) groups[face_of_edge[edge]] = group;
      if (k == 0 && first) groups[2] = *first;
      if (k + 2 == angles.size() && last) groups[3] = *last;
      add_cell(
          [&](int i, int j, int l) -> std::array<double, 3> {
            const double angle = angles[k] + 0.5 * j * (angles[k + 1] - angles[k]);
            const Point2 p = quad.nodes[i + 3 * l];
            return {axis_x + p[0] * std::cos(angle), p[0] * std::sin(angle), p[1]};
          },
          quad.volume, groups);
    }
}

void Body::raise(const std::vector<Quad9> &plan, int layers, double axis_x,
                 const std::function<double(double, double)> &height, Volume volume, std::optional<Surface> below,
                 std::optional<Surface> above) {
  for (const auto &quad : plan)
    for (int k = 0; k < layers; ++k) {
      std::map<int, Surface> groups = quad.groups; // edges and sides are numbered alike
      if (k == 0 && below) groups[4] = *below;
      if (k + 1 == layers && above) groups[5] = *above;
      add_cell(
          [&](int a, int b, int c) -> std::array<double, 3> {
            const Point2 p = quad.nodes[a + 3 * b];
            return {axis_x + p[0], p[1], height(std::hypot(p[0], p[1]), k + 0.5 * c)};
          },
          volume, groups);
    }
}

} // namespace rimpact::meshes
