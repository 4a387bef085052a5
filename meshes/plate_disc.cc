// The whole plate of rung full: a core about the vertex, rings around it, and the rim on the sectors that may be
// touched.
#include "meshes/plate_disc.h"

#include "meshes/half_disc.h"
#include "meshes/plate_section.h"
#include "meshes/touched_places.h"
#include "meshes/units.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace rimpact::meshes {
namespace {

/// 0 .. pi in pairs of equal intervals, as half_disc asks; fine where the rim is touched.
std::vector<double> disc_angles(const std::vector<double> &places, const PlaceSizes &sizes) {
  std::vector<Anchor> anchors = anchors_at(places, sizes);
  const double last = places.back(), left = M_PI - last;
  if (left > sizes.past_zone()) anchors.push_back({last + sizes.zone, sizes.fine});
  if (left > sizes.past_reach()) anchors.push_back({last + sizes.reach, sizes.coarse});
  if (last < M_PI) anchors.push_back({M_PI, sizes.coarse});
  return halved(graded_lines(anchors));
}

/// Runs of the grid's intervals that belong to a sector of the rim.
std::vector<std::vector<double>> rim_runs(const std::vector<double> &angles, const std::vector<double> &places,
                                          double reach) {
  std::vector<std::vector<double>> runs;
  bool in_rim = false;
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    const double middle = 0.5 * (angles[k] + angles[k + 1]);
    const bool was_in_rim = std::exchange(in_rim, std::any_of(places.begin(), places.end(), [&](double place) {
                                            return std::abs(middle - place) < reach;
                                          }));
    if (!in_rim) continue;
    if (!was_in_rim) runs.push_back({angles[k]});
    runs.back().push_back(angles[k + 1]);
  }
  return runs;
}

} // namespace

void add_whole_plate(HexMesh &mesh, const scene::Bearing &bearing, const MeshOrder &order) {
  constexpr double core = 0.25; // radius [m]
  const double h = size_factor(order.level), wall = bearing.wall_radius();
  const PlaceSizes sizes{2 * 10 * mm * h / wall, 20 * mm / wall, order.sector_half_angle, 0.6 * h};
  const std::vector<double> places = folded(from_the_first(order.directions), sizes.apart()),
                            angles = disc_angles(places, sizes);
  const double size = 80 * mm * h;                             // as coarse as the pad's path allows
  const std::vector<double> layers = plate_layers(bearing, h); // the rim's foot bends the plate as in rung rigid-dish
  std::vector<Quad9> plate, rim;
  for (auto &quad : plate_and_rim(bearing, {core, size, layers}, h)) {
    if (quad.groups.count(0) && quad.groups.at(0) == Surface::sector_end)
      quad.groups.erase(0); // the core goes on there
    (quad.volume == Volume::rim ? rim : plate).push_back(quad);
  }
  Body body(mesh);
  body.revolve(plate, angles, 0.0, Surface::symmetry, Surface::symmetry);
  for (const auto &run : rim_runs(angles, places, sizes.reach)) {
    const auto end = [&](double at, double symmetry) {
      return std::abs(at - symmetry) < 1e-9 ? std::optional(Surface::symmetry) : std::nullopt;
    };
    body.revolve(rim, run, 0.0, end(run.front(), 0), end(run.back(), M_PI));
  }
  const auto surface = scene::make_surface(bearing.surface);
  const double base = -bearing.plate.base;
  const auto height = [&](double r, double level) {
    return base + at_level(layers, level) * (surface->at(r, 0).z - base);
  };
  body.raise(half_disc(core, angles, size), layers.size() - 1, 0.0, height, Volume::plate, Surface::fixed,
             Surface::dish);
}

} // namespace rimpact::meshes
