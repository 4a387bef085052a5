#include "meshes/own_mesh.h"

#include "io/files/error.h"
#include "meshes/exact_surfaces.h"
#include "meshes/mesh_process.h"
#include "meshes/mirror.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <utility>

namespace rimpact::meshes {
namespace {

/// The cells of some bodies, and the faces and nodes these use.
HexMesh only(const HexMesh &mesh, const std::vector<Volume> &bodies) {
  HexMesh kept;
  std::vector<unsigned> number(mesh.nodes.size(), ~0u);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (std::find(bodies.begin(), bodies.end(), mesh.volumes[c]) == bodies.end()) continue;
    kept.cells.push_back(mesh.cells[c]);
    kept.volumes.push_back(mesh.volumes[c]);
    for (unsigned &node : kept.cells.back()) {
      if (number[node] == ~0u) {
        number[node] = static_cast<unsigned>(kept.nodes.size());
        kept.nodes.push_back(mesh.nodes[node]);
      }
      node = number[node];
    }
  }
  for (BoundaryFace face : mesh.faces) {
    if (std::any_of(face.corners.begin(), face.corners.end(), [&](unsigned node) { return number[node] == ~0u; }))
      continue;
    for (unsigned &node : face.corners) node = number[node];
    kept.faces.push_back(face);
  }
  return kept;
}

struct Drawn {
  const HexMesh mesh;
  const std::string &file;

  [[noreturn]] void fail(const std::string &what) const { throw DataError(fmt::format("{}: {}", file, what)); }
  bool has(Volume body) const { return std::count(mesh.volumes.begin(), mesh.volumes.end(), body) > 0; }
  std::set<unsigned> nodes_of(Surface group) const {
    std::set<unsigned> nodes;
    for (const auto &face : mesh.faces)
      if (face.group == group) nodes.insert(face.corners.begin(), face.corners.end());
    return nodes;
  }
  std::set<unsigned> nodes_of(Volume body) const {
    std::set<unsigned> nodes;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      if (mesh.volumes[c] == body) nodes.insert(mesh.cells[c].begin(), mesh.cells[c].end());
    return nodes;
  }
  /// Smallest and largest coordinate of a group's corners.
  std::pair<double, double> range(Surface group, int axis) const {
    double low = INFINITY, high = -INFINITY;
    for (const unsigned node : nodes_of(group))
      low = std::min(low, mesh.nodes[node][axis]), high = std::max(high, mesh.nodes[node][axis]);
    return {low, high};
  }
};

void check_groups(const Drawn &drawn, const OwnMeshNeed &need) {
  for (const Volume body : need.bodies)
    if (!drawn.has(body) && body != Volume::rim) // which may be one volume with the plate
      drawn.fail(fmt::format(
          "volume '{0}' is missing; if it has another name there, say {0} = \"...\" in [model.own_mesh.groups]",
          to_string(body)));
  for (const Surface group : need.groups)
    if (drawn.nodes_of(group).empty())
      drawn.fail(fmt::format(
          "surface '{0}' is missing; if it has another name there, say {0} = \"...\" in [model.own_mesh.groups]",
          to_string(group)));
  if (need.half && drawn.nodes_of(Surface::symmetry).empty())
    drawn.fail("no group 'symmetry': the drawing is of the whole bearing, and this scene needs half of it only; set "
               "model.symmetry = \"whole\"");
}

/// The slider's width tells a wrong unit before any other dimension is looked at.
void check_unit(const Drawn &drawn, const scene::OwnMesh &own, const scene::Bearing &bearing) {
  const auto [low, high] = drawn.range(Surface::slider_side, 0);
  const double ratio = (high - low) / bearing.slider.diameter;
  if (ratio > 0.2 && ratio < 5) return;
  drawn.fail(fmt::format("slider_side is {:.4g} mm wide where the bearing's slider has {:g} mm, {:.3g} times as much: "
                         "model.own_mesh.unit is \"{}\"",
                         1e3 * (high - low), 1e3 * bearing.slider.diameter, ratio, word(own.unit)));
}

/// Bodies that touch have nodes of their own, tied ones share them.
void check_welds(const Drawn &drawn, bool pad_is_tied) {
  constexpr Volume all[] = {Volume::plate, Volume::rim, Volume::pad, Volume::foot, Volume::upper_slider};
  for (const Volume a : all)
    for (const Volume b : all) {
      if (a >= b || !drawn.has(a) || !drawn.has(b)) continue;
      const bool tied =
          (a == Volume::plate && b == Volume::rim) || (pad_is_tied && a == Volume::pad && b == Volume::foot);
      std::vector<unsigned> shared;
      const auto of_a = drawn.nodes_of(a), of_b = drawn.nodes_of(b);
      std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(shared));
      if (tied && shared.empty())
        drawn.fail(fmt::format("{} and {} share no nodes, but are one piece: draw them with a common face",
                               to_string(a), to_string(b)));
      if (tied || shared.empty()) continue;
      const auto &x = drawn.mesh.nodes[shared.front()];
      drawn.fail(fmt::format("{} and {} are welded: they share {} nodes, one at ({:.1f}, {:.1f}, {:.1f}) mm; bodies "
                             "that touch need nodes of their own",
                             to_string(a), to_string(b), shared.size(), 1e3 * x[0], 1e3 * x[1], 1e3 * x[2]));
    }
}

/// Travel of the slider as it is drawn: at rest, or where it first touches the rim.
double drawn_travel(const Drawn &drawn, const scene::Bearing &bearing, double wanted) {
  constexpr double tolerance = 0.5e-3;
  const auto [low, high] = drawn.range(Surface::slider_side, 0);
  const double axis = 0.5 * (low + high), height = drawn.range(Surface::top, 2).second,
               capacity = bearing.lateral_capacity();
  for (const double travel : {0.0, capacity})
    if (std::abs(axis - travel) < tolerance &&
        std::abs(height - bearing.slider.top - scene::lift(bearing, travel)) < tolerance &&
        (travel == 0 || wanted != 0)) // pad and foot are not carried back from the rim
      return travel;
  drawn.fail(fmt::format("the slider's axis is drawn at x = {:.2f} mm and its top at z = {:.2f} mm; the bearing has "
                         "them at 0 and {:.2f} mm at rest{}",
                         1e3 * axis, 1e3 * height, 1e3 * bearing.slider.top,
                         wanted == 0 ? ", where this rung starts"
                                     : fmt::format(", {:.2f} and {:.2f} mm at first touch", 1e3 * capacity,
                                                   1e3 * (bearing.slider.top + scene::lift(bearing, capacity)))));
}

void move_slider(HexMesh &mesh, double along_x, double up) {
  std::vector<char> moved(mesh.nodes.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.volumes[c] != Volume::plate && mesh.volumes[c] != Volume::rim)
      for (const unsigned node : mesh.cells[c])
        if (!std::exchange(moved[node], 1)) mesh.nodes[node][0] += along_x, mesh.nodes[node][2] += up;
}

/// Whether the rim's wall reaches a direction of +x or -x.
void check_wall(const Drawn &drawn, bool both_sides) {
  if (drawn.nodes_of(Surface::rim_wall).empty()) return;
  const auto [low, high] = drawn.range(Surface::rim_wall, 0);
  if (!(high > 0) || (both_sides && !(low < 0)))
    drawn.fail(fmt::format("the rim's wall is drawn from x = {:.1f} to {:.1f} mm, but the slider comes near it {}",
                           1e3 * low, 1e3 * high, both_sides ? "on both sides" : "at +x"));
}

} // namespace

HexMesh own_mesh(const scene::OwnMesh &own, const scene::Bearing &bearing, const OwnMeshNeed &need) {
  const DrawnMesh read = read_mesh_apart(
      own, {.sizes = sizes_of(own, bearing, std::count(need.bodies.begin(), need.bodies.end(), Volume::pad) > 0),
            .pad_is_tied = !bearing.pad_is_seated()});
  const Drawn drawn{only(read.mesh, need.bodies), own.file};
  check_groups(drawn, need);
  check_unit(drawn, own, bearing);
  check_welds(drawn, !bearing.pad_is_seated());
  check_wall(drawn, need.both_sides);
  const double travel = drawn_travel(drawn, bearing, need.travel);
  HexMesh mesh = drawn.mesh;
  move_slider(mesh, need.travel - travel, scene::lift(bearing, need.travel) - scene::lift(bearing, travel));
  fit_to_surfaces(mesh, bearing, need.travel, own.file, read.divided);
  if (!need.half && !drawn.nodes_of(Surface::symmetry).empty()) mesh = mirrored(mesh);
  try {
    check_cells(mesh);
  } catch (const DataError &error) {
    drawn.fail(error.what());
  }
  return mesh;
}

} // namespace rimpact::meshes
