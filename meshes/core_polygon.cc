#include "meshes/core_polygon.h"

#include "io/files/error.h"
#include "meshes/gmsh_session.h"
#include <algorithm>
#include <cmath>

namespace rimpact::meshes {
namespace {

void mesh_polygon(const std::vector<Point2> &polygon, bool quarter, double size) {
  namespace geo = gmsh::model::geo;
  gmsh::model::add("core");
  const double coarse = 2 * size; // the subdivision halves every edge
  std::vector<int> points, curves;
  for (std::size_t k = 0; k < polygon.size(); k += 2)
    points.push_back(geo::addPoint(polygon[k][0], polygon[k][1], 0, coarse));
  const std::size_t closing = points.size() - 1;
  if (quarter) points.push_back(geo::addPoint(0, 0, 0, coarse));
  const double straight = quarter ? polygon.front()[0] : polygon.front()[0] - polygon.back()[0];
  for (std::size_t k = 0; k < points.size(); ++k) {
    curves.push_back(geo::addLine(points[k], points[(k + 1) % points.size()]));
    const int n = k < closing ? 1 : std::max(1, static_cast<int>(std::lround(straight / coarse)));
    geo::mesh::setTransfiniteCurve(curves.back(), n + 1);
  }
  geo::addPlaneSurface({geo::addCurveLoop(curves)});
  geo::synchronize();
  gmsh::model::mesh::generate(2);
}

} // namespace

std::vector<Quad9> polygon_quads(const std::vector<Point2> &polygon, bool quarter, double size) {
  const GmshSession session;
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1); // leaves quadrilaterals only
  try {
    mesh_polygon(polygon, quarter, size);
  } catch (const std::string &message) { // what gmsh 4.8 throws
    throw DataError("gmsh could not mesh the slider's core: " + message);
  }
  std::vector<std::size_t> tags, elements, connectivity, triangles, triangle_nodes;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::map<std::size_t, Point2> nodes;
  const auto at = [&](std::size_t i) { return std::abs(coordinates[i]) < 1e-12 ? 0.0 : coordinates[i]; };
  for (std::size_t k = 0; k < tags.size(); ++k) nodes[tags[k]] = {at(3 * k), at(3 * k + 1)};
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

} // namespace rimpact::meshes
