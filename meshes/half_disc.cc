#include "meshes/half_disc.h"

#include "io/files/error.h"
#include "meshes/gmsh_session.h"
#include <algorithm>
#include <cmath>

namespace rimpact::meshes {
namespace {

/// Steps narrower than `least` of the mean one widened to it, at the others' cost: lines that are fine on the arc would
/// meet in slivers further in. 0: as they are.
std::vector<double> widened(const std::vector<double> &angles, double least) {
  if (least == 0) return angles;
  const double narrowest = least * M_PI / (angles.size() - 1);
  std::vector<double> result{0};
  for (std::size_t k = 0; k + 1 < angles.size(); ++k)
    result.push_back(result.back() + std::max(angles[k + 1] - angles[k], narrowest));
  for (double &angle : result) angle *= M_PI / result.back();
  return result;
}

/// Nodes of the polygon that gmsh fills: corners at the even angles, the middles of its edges between them.
std::vector<Point2> polygon(double radius, const std::vector<double> &angles) {
  constexpr double share = 0.55;
  const auto corner = [&](std::size_t k) -> Point2 {
    const double r = share * radius;
    return {r * std::cos(angles[k]), k + 1 == angles.size() ? 0.0 : r * std::sin(angles[k])};
  };
  std::vector<Point2> result{corner(0)};
  for (std::size_t k = 2; k < angles.size(); k += 2) {
    const Point2 a = result.back(), b = corner(k);
    result.insert(result.end(), {{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}, b});
  }
  return result;
}

void mesh_polygon(const std::vector<Point2> &polygon, double size) {
  namespace geo = gmsh::model::geo;
  gmsh::model::add("core");
  const double coarse = 2 * size; // the subdivision halves every edge
  std::vector<int> points, curves;
  for (std::size_t k = 0; k < polygon.size(); k += 2)
    points.push_back(geo::addPoint(polygon[k][0], polygon[k][1], 0, coarse));
  for (std::size_t k = 0; k < points.size(); ++k) {
    curves.push_back(geo::addLine(points[k], points[(k + 1) % points.size()]));
    const double length = k + 1 == points.size() ? polygon.front()[0] - polygon.back()[0] : 0; // of the diameter
    const int n = std::max(1, static_cast<int>(std::lround(length / coarse)));
    geo::mesh::setTransfiniteCurve(curves.back(), n + 1);
  }
  geo::addPlaneSurface({geo::addCurveLoop(curves)});
  geo::synchronize();
  gmsh::model::mesh::generate(2);
}

/// Straight-edged quadrilaterals of the polygon.
std::vector<Quad9> polygon_quads(const std::vector<Point2> &polygon, double size) {
  const GmshSession session;
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1); // leaves quadrilaterals only
  try {
    mesh_polygon(polygon, size);
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

std::vector<Quad9> disc(double radius, const std::vector<double> &angles, const std::vector<Point2> &polygon,
                        double size) {
  std::vector<Quad9> quads = polygon_quads(polygon, size);
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    const auto arc = [&](double angle) -> Point2 {
      return {radius * std::cos(angle), angle > M_PI - 1e-12 ? 0.0 : radius * std::sin(angle)};
    };
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

} // namespace

std::vector<Quad9> half_disc(double radius, const std::vector<double> &angles, double size) {
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
