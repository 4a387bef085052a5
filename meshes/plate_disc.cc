// The whole plate of rung R3: a core about the vertex, rings around it, and the rim on the sectors that may be touched.
#include "meshes/half_disc.h"
#include "meshes/plate_section.h"
#include "meshes/rim_mesh.h"
#include <algorithm>

namespace rimpact::meshes {
namespace {

constexpr double mm = 1e-3;

/// 0 .. pi in pairs of equal intervals, as half_disc asks; fine where the rim is touched.
std::vector<double> disc_angles(double fine, double zone, double sector, double h, bool both_sides) {
  std::vector<Anchor> sizes{{0, 2 * fine}, {zone, 2 * fine}, {sector, 0.6 * h}};
  if (both_sides) {
    sizes.push_back({M_PI - sector, 0.6 * h});
    sizes.push_back({M_PI - zone, 2 * fine});
    sizes.push_back({M_PI, 2 * fine});
  } else {
    sizes.push_back({M_PI, 0.6 * h});
  }
  return halved(graded_lines(sizes));
}

} // namespace

void add_whole_plate(HexMesh &mesh, const scene::Bearing &bearing, const RimMeshOptions &options, bool both_sides) {
  constexpr double core = 0.25; // radius [m]
  const double h = size_factor(options.level), wall = bearing.surface.planar_radius + bearing.rim.ledge;
  const double sector = options.sector_half_angle;
  const std::vector<double> angles = disc_angles(10 * mm * h / wall, 20 * mm / wall, sector, h, both_sides);
  const double size = 80 * mm * h; // as coarse as the pad's path allows
  const std::vector<double> layers = plate_layers(bearing, h); // the rim's foot bends the plate as in rung R2
  std::vector<Quad9> plate, rim;
  for (auto &quad : plate_and_rim(bearing, {core, size, layers}, h)) {
    if (quad.groups.count(0) && quad.groups.at(0) == Surface::sector_end) quad.groups.erase(0); // the core goes on there
    (quad.volume == Volume::rim ? rim : plate).push_back(quad);
  }
  Body body(mesh);
  body.revolve(plate, angles, 0.0, Surface::symmetry, Surface::symmetry);
  std::vector<double> front, back;
  for (const double angle : angles) {
    if (angle <= sector + 1e-9) front.push_back(angle);
    if (angle >= M_PI - sector - 1e-9) back.push_back(angle);
  }
  body.revolve(rim, front, 0.0, Surface::symmetry, {});
  if (both_sides) body.revolve(rim, back, 0.0, {}, Surface::symmetry);
  const auto surface = scene::make_surface(bearing.surface);
  const double base = -bearing.plate.base;
  const auto height = [&](double r, double level) { return base + at_level(layers, level) * (surface->at(r, 0).z - base); };
  body.raise(half_disc(core, angles, size), layers.size() - 1, 0.0, height, Volume::plate, Surface::fixed, Surface::dish);
}

} // namespace rimpact::meshes
