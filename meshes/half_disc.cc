#include "meshes/half_disc.h"

#include "scene/error.h"
#include <cmath>
#include <gmsh.h>

namespace rimpact::meshes {
namespace {

/// gmsh is a process-wide singleton: one session an owner, quiet and deterministic.
struct GmshSession {
  GmshSession() {
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.RecombineAll", 1);
    gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 3); // blossom, then one subdivision: quadrilaterals only
    gmsh::option::setNumber("Mesh.Algorithm", 8);
  }
  ~GmshSession() { gmsh::finalize(); }
};

void make_geometry(double radius, const std::vector<double> &angles, double size) {
  namespace geo = gmsh::model::geo;
  const double coarse = 2 * size; // halved by the subdivision
  const int origin = geo::addPoint(0, 0, 0, coarse);
  std::vector<int> points, curves;
  for (std::size_t k = 0; k < angles.size(); k += 2)
    points.push_back(geo::addPoint(radius * std::cos(angles[k]), radius * std::sin(angles[k]), 0, coarse));
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    curves.push_back(geo::addCircleArc(points[k], origin, points[k + 1]));
    geo::mesh::setTransfiniteCurve(curves.back(), 2);
  }
  curves.push_back(geo::addLine(points.back(), origin));
  curves.push_back(geo::addLine(origin, points.front()));
  const int n = std::max(1, static_cast<int>(std::lround(radius / coarse)));
  geo::mesh::setTransfiniteCurve(curves[curves.size() - 2], n + 1);
  geo::mesh::setTransfiniteCurve(curves.back(), n + 1);
  geo::addPlaneSurface({geo::addCurveLoop(curves)});
  geo::synchronize();
}

/// Middle of an edge: on the arc where both ends are.
Point2 edge_middle(Point2 a, Point2 b, double radius) {
  Point2 m{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  const auto on_arc = [&](Point2 p) { return std::abs(std::hypot(p[0], p[1]) - radius) < 1e-9; };
  if (!on_arc(a) || !on_arc(b)) return m;
  const double angle = 0.5 * (std::atan2(a[1], a[0]) + std::atan2(b[1], b[0]));
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

} // namespace

std::vector<Quad9> half_disc(double radius, const std::vector<double> &angles, double size) {
  const GmshSession session;
  make_geometry(radius, angles, size);
  gmsh::model::mesh::generate(2);
  std::vector<std::size_t> tags, elements;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::map<std::size_t, Point2> nodes;
  for (std::size_t k = 0; k < tags.size(); ++k) {
    Point2 p{coordinates[3 * k], coordinates[3 * k + 1]};
    if (std::abs(p[1]) < 1e-9) p[1] = 0;
    const double r = std::hypot(p[0], p[1]);
    if (std::abs(r - radius) < 1e-4 * radius) // on the arc: exactly at one of the given angles
      for (const double angle : angles)
        if (std::abs(std::atan2(p[1], p[0]) - angle) < 1e-4) p = {radius * std::cos(angle), angle > M_PI - 1e-9 ? 0 : radius * std::sin(angle)};
    nodes[tags[k]] = p;
  }
  std::vector<std::size_t> connectivity;
  gmsh::model::mesh::getElementsByType(3, elements, connectivity);
  std::vector<std::size_t> triangles, triangle_nodes;
  gmsh::model::mesh::getElementsByType(2, triangles, triangle_nodes);
  if (elements.empty() || !triangles.empty()) throw DataError("gmsh did not fill the slider's core with quadrilaterals");
  std::vector<Quad9> quads;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    Point2 c[4];
    for (int i = 0; i < 4; ++i) c[i] = nodes.at(connectivity[4 * k + i]);
    const double area = (c[2][0] - c[0][0]) * (c[3][1] - c[1][1]) - (c[3][0] - c[1][0]) * (c[2][1] - c[0][1]);
    if (area < 0) std::swap(c[1], c[3]);
    Quad9 quad = straight_quad(c[0], c[1], c[2], c[3], Volume::upper_slider);
    constexpr int ends[4][3] = {{0, 6, 3}, {2, 8, 5}, {0, 2, 1}, {6, 8, 7}}; // edge: two corners, middle
    for (int e = 0; e < 4; ++e) {
      const Point2 a = quad.nodes[ends[e][0]], b = quad.nodes[ends[e][1]];
      quad.nodes[ends[e][2]] = edge_middle(a, b, radius);
      if (a[1] == 0 && b[1] == 0) quad.groups[e] = Surface::symmetry;
    }
    centre(quad);
    quads.push_back(quad);
  }
  return quads;
}

} // namespace rimpact::meshes
