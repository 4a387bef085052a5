#include "meshes/half_disc.h"

#include "files/error.h"
#include "meshes/gmsh_session.h"
#include <cmath>

namespace rimpact::meshes {
namespace {

constexpr double polygon_share = 0.55; ///< of the radius

/// Corners of the polygon at the even angles; its edges' middles lie under the odd ones.
Point2 polygon_node(double radius, const std::vector<double> &angles, std::size_t k) {
  const auto corner = [&](std::size_t i) -> Point2 {
    const double r = polygon_share * radius;
    return {r * std::cos(angles[i]), i + 1 == angles.size() ? 0.0 : r * std::sin(angles[i])};
  };
  if (k % 2 == 0) return corner(k);
  const Point2 a = corner(k - 1), b = corner(k + 1);
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
}

void mesh_polygon(double radius, const std::vector<double> &angles, double size) {
  namespace geo = gmsh::model::geo;
  gmsh::model::add("core");
  const double coarse = 2 * size; // the subdivision halves every edge
  std::vector<int> points, curves;
  for (std::size_t k = 0; k < angles.size(); k += 2) {
    const Point2 p = polygon_node(radius, angles, k);
    points.push_back(geo::addPoint(p[0], p[1], 0, coarse));
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    curves.push_back(geo::addLine(points[k], points[(k + 1) % points.size()]));
    const bool diameter = k + 1 == points.size();
    const int n = diameter ? std::max(1, static_cast<int>(std::lround(2 * polygon_share * radius / coarse))) : 1;
    geo::mesh::setTransfiniteCurve(curves.back(), n + 1);
  }
  geo::addPlaneSurface({geo::addCurveLoop(curves)});
  geo::synchronize();
  gmsh::model::mesh::generate(2);
}

/// Straight-edged quadrilaterals of the polygon.
std::vector<Quad9> polygon_quads(double radius, const std::vector<double> &angles, double size) {
  const GmshSession session;
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1); // leaves quadrilaterals only
  try {
    mesh_polygon(radius, angles, size);
  } catch (const std::string &message) { // what gmsh 4.8 throws
    throw DataError("gmsh could not mesh the slider's core: " + message);
  }
  std::vector<std::size_t> tags, elements, connectivity, triangles, triangle_nodes;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::map<std::size_t, Point2> nodes;
  for (std::size_t k = 0; k < tags.size(); ++k)
    nodes[tags[k]] = {coordinates[3 * k], std::abs(coordinates[3 * k + 1]) < 1e-12 ? 0.0 : coordinates[3 * k + 1]};
  gmsh::model::mesh::getElementsByType(3, elements, connectivity);
  gmsh::model::mesh::getElementsByType(2, triangles, triangle_nodes);
  if (elements.empty() || !triangles.empty())
    throw DataError("gmsh did not fill the slider's core with quadrilaterals");
  std::vector<Quad9> quads;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    Point2 c[4];
    for (int i = 0; i < 4; ++i) c[i] = nodes.at(connectivity[4 * k + i]);
    const double area = (c[2][0] - c[0][0]) * (c[3][1] - c[1][1]) - (c[3][0] - c[1][0]) * (c[2][1] - c[0][1]);
    if (area < 0) std::swap(c[1], c[3]);
    quads.push_back(straight_quad(c[0], c[1], c[2], c[3], Volume::upper_slider));
  }
  return quads;
}

} // namespace

std::vector<Quad9> half_disc(double radius, const std::vector<double> &angles, double size) {
  std::vector<Quad9> quads = polygon_quads(radius, angles, size);
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    const auto arc = [&](double angle) -> Point2 {
      return {radius * std::cos(angle), angle > M_PI - 1e-12 ? 0.0 : radius * std::sin(angle)};
    };
    Quad9 quad = straight_quad(polygon_node(radius, angles, k), arc(angles[k]), arc(angles[k + 1]),
                               polygon_node(radius, angles, k + 1), Volume::upper_slider);
    quad.nodes[5] = arc(0.5 * (angles[k] + angles[k + 1]));
    centre(quad);
    quads.push_back(quad);
  }
  constexpr int ends[4][2] = {{0, 6}, {2, 8}, {0, 2}, {6, 8}};
  for (auto &quad : quads)
    for (int e = 0; e < 4; ++e)
      if (quad.nodes[ends[e][0]][1] == 0 && quad.nodes[ends[e][1]][1] == 0) quad.groups[e] = Surface::symmetry;
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
