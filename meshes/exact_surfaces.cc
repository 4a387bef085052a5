#include "meshes/exact_surfaces.h"

#include "io/files/error.h"
#include "meshes/cell_nodes.h"
#include "meshes/curved_edges.h"
#include "meshes/hex_order.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <optional>
#include <set>

namespace rimpact::meshes {
namespace {

/// The nearest place on a group's surface; none where the group has no exact one (the slider's rounded edge).
using Place = std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector3d &)>;

/// Of a circular cylinder upright at (x, 0).
Eigen::Vector3d on_cylinder(const Eigen::Vector3d &p, double x, double radius) {
  const Eigen::Vector2d out = (p.head<2>() - Eigen::Vector2d(x, 0)).normalized();
  return {x + radius * out.x(), radius * out.y(), p.z()};
}

std::map<Surface, Place> places(const scene::Bearing &bearing, double travel) {
  const std::shared_ptr<const scene::SlidingSurface> dish = scene::make_surface(bearing.surface);
  const double wall = bearing.wall_radius(), side = bearing.slider.diameter / 2, cap = bearing.foot.cap_radius;
  const double height = scene::lift(bearing, travel),
               edge = height + bearing.slider.bottom + bearing.slider.edge_radius + 1e-6;
  const double top = bearing.slider.top + height;
  const Eigen::Vector3d centre(travel, 0, height);
  const Place ball = [=](const Eigen::Vector3d &p) -> Eigen::Vector3d {
    return centre + cap * (p - centre).normalized();
  };
  std::map<Surface, Place> result = {
      {Surface::rim_wall, [=](const Eigen::Vector3d &p) { return on_cylinder(p, 0, wall); }},
      {Surface::slider_side,
       [=](const Eigen::Vector3d &p) {
         return p.z() > edge ? std::optional(on_cylinder(p, travel, side)) : std::nullopt;
       }},
      {Surface::dish,
       [=](const Eigen::Vector3d &p) { return Eigen::Vector3d(p.x(), p.y(), dish->at(p.x(), p.y()).z); }},
      {Surface::foot_cap, ball},
      {Surface::socket, ball},
      {Surface::top, [=](const Eigen::Vector3d &p) { return Eigen::Vector3d(p.x(), p.y(), top); }},
      {Surface::symmetry, [](const Eigen::Vector3d &p) { return Eigen::Vector3d(p.x(), 0, p.z()); }}};
  if (!bearing.pad_is_seated()) return result;
  const double seat = height + bearing.pad.thickness, pad = bearing.pad.outer_radius, recess = bearing.recess_radius();
  for (const Surface group : {Surface::pad_top, Surface::foot_seat})
    result[group] = [=](const Eigen::Vector3d &p) { return Eigen::Vector3d(p.x(), p.y(), seat); };
  result[Surface::pad_side] = [=](const Eigen::Vector3d &p) { return on_cylinder(p, travel, pad); };
  result[Surface::foot_recess] = [=](const Eigen::Vector3d &p) { return on_cylinder(p, travel, recess); };
  return result;
}

/// Of every face of the cells, by its sorted corners: middles of its edges, and its own.
struct Middles {
  std::vector<unsigned> edges;
  unsigned centre;
};
std::map<std::array<unsigned, 4>, Middles> middles_of_faces(const HexMesh &mesh) {
  std::map<std::array<unsigned, 4>, Middles> result;
  for (const auto &cell : mesh.cells)
    for (int f = 0; f < 6; ++f) {
      const auto &face = hex27_faces[f];
      Middles middles{{}, cell[20 + f]};
      for (int e = 0; e < 12; ++e)
        if (std::count(face, face + 4, hex27_edges[e][0]) && std::count(face, face + 4, hex27_edges[e][1]))
          middles.edges.push_back(cell[8 + e]);
      result[sorted({cell[face[0]], cell[face[1]], cell[face[2]], cell[face[3]]})] = middles;
    }
  return result;
}

/// Moves nodes of grouped faces, one kind of node after the other.
class Fitting {
public:
  Fitting(HexMesh &mesh, std::map<Surface, Place> exact, const std::string &file)
      : mesh_(mesh), exact_(std::move(exact)), file_(file) {}
  /// `nodes`: of a face, with how far they may lie off [m].
  template <class Nodes> void fit(const Nodes &nodes) {
    for (const auto &face : mesh_.faces)
      if (const auto place = exact_.find(face.group); place != exact_.end()) {
        const auto [list, allowed] = nodes(face);
        for (const unsigned node : list) move(node, *place, allowed);
      }
  }
  /// Cells of which an edge was moved: what lies between their edges follows.
  void complete_cells() {
    for (const auto &cell : mesh_.cells)
      if (std::any_of(cell.begin() + 8, cell.begin() + 20, [&](unsigned node) { return moved_.count(node) > 0; }))
        complete_from_edges(mesh_, cell);
  }

private:
  void move(unsigned node, const std::pair<const Surface, Place> &to, double allowed) {
    Eigen::Map<Eigen::Vector3d> p(mesh_.nodes[node].data());
    const auto target = to.second(p);
    if (!target) return;
    const double off = (*target - p).norm();
    if (!(off < allowed))
      throw DataError(fmt::format("{}: group '{}' at ({:.2f}, {:.2f}, {:.2f}) mm lies {:.2f} mm off the bearing's "
                                  "surface, which passes ({:.2f}, {:.2f}, "
                                  "{:.2f}) mm: drawing and bearing file differ",
                                  file_, to_string(to.first), 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z(), 1e3 * off,
                                  1e3 * target->x(), 1e3 * target->y(), 1e3 * target->z()));
    if (off > 1e-9) moved_.insert(node);
    p = *target;
  }
  HexMesh &mesh_;
  const std::map<Surface, Place> exact_;
  const std::string &file_;
  std::set<unsigned> moved_;
};

} // namespace

void fit_to_surfaces(HexMesh &mesh, const scene::Bearing &bearing, double travel, const std::string &file,
                     bool divided) {
  constexpr double tolerance = 0.2e-3, chord = 0.3; // of a straight face's diagonal: its corners are what counts
  const auto middles = middles_of_faces(mesh);
  const auto allowed = [&](const BoundaryFace &face) {
    return tolerance + chord * (Eigen::Vector3d(mesh.nodes[face.corners[2]].data()) -
                                Eigen::Vector3d(mesh.nodes[face.corners[0]].data()))
                                   .norm();
  };
  Fitting fitting(mesh, places(bearing, travel), file);
  fitting.fit([&](const BoundaryFace &face) { return std::pair(face.corners, divided ? allowed(face) : tolerance); });
  curve_edges(mesh, travel);
  fitting.fit(
      [&](const BoundaryFace &face) { return std::pair(middles.at(sorted(face.corners)).edges, allowed(face)); });
  fitting.complete_cells();
  fitting.fit([&](const BoundaryFace &face) {
    return std::pair(std::array{middles.at(sorted(face.corners)).centre}, allowed(face));
  });
}

} // namespace rimpact::meshes
