/// Plane meshes of 9-node quadrilaterals, and the ways to make solids of them: revolving a section about a
/// vertical axis, raising a plan into layers. Coincident nodes are merged within one body, never between
/// bodies.
#pragma once
#include "meshes/hex_mesh.h"
#include <functional>
#include <map>
#include <optional>

namespace rimpact::meshes {

using Point2 = std::array<double, 2>;

/// Nodes lexicographic (first coordinate fast). Edges 0..3: first-, first+, second-, second+; `groups` of
/// edges.
struct Quad9 {
  std::array<Point2, 9> nodes;
  Volume volume;
  std::map<int, Surface> groups;
};
/// Straight-edged quadrilateral from its corners a (--), b (+-), c (++), d (-+).
Quad9 straight_quad(Point2 a, Point2 b, Point2 c, Point2 d, Volume volume);
/// Moves the centre to follow curved edges (transfinite interpolation).
void centre(Quad9 &quad);

/// Lines between anchors, their spacing following the size wanted at each anchor: geometric, so that the
/// spacing is linear in place. Anchors are hit exactly.
struct Anchor {
  double at, size;
};
std::vector<double> graded_lines(const std::vector<Anchor> &anchors);
/// Between lines: 1.5 is midway from lines[1] to lines[2].
double at_level(const std::vector<double> &lines, double level);

/// Adds bodies to a mesh, merging nodes nearer than `merge_distance` within the body.
class Body {
public:
  explicit Body(HexMesh &mesh) : mesh_(mesh) {}
  /// A body tied to another along the other's nodes where `tied` is true.
  Body(const Body &other, const std::function<bool(const std::array<double, 3> &)> &tied);
  using Place = std::function<std::array<double, 3>(double, double, double)>;
  /// One hexahedron: place(xi, eta, zeta) in half cells 0, 1, 2; groups by face (as hex_faces).
  void add_cell(const std::function<std::array<double, 3>(int, int, int)> &place, Volume volume,
                const std::map<int, Surface> &groups);
  /// Section in (r, z) about the vertical axis through (axis_x, 0), between successive angles.
  void revolve(const std::vector<Quad9> &section, const std::vector<double> &angles, double axis_x,
               std::optional<Surface> first, std::optional<Surface> last);
  /// Plan in (x, y) about the same axis, raised into layers: height(r, level) [m] at radius r, level 0 .. layers.
  void raise(const std::vector<Quad9> &plan, int layers, double axis_x,
             const std::function<double(double, double)> &height, Volume volume, std::optional<Surface> below,
             std::optional<Surface> above);

private:
  static constexpr double merge_distance = 1e-8;
  HexMesh &mesh_;
  std::map<std::array<long, 3>, unsigned> known_;
};

} // namespace rimpact::meshes
