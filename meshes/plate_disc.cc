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
  const std::vector<double> coarse = graded_lines(sizes);
  std::vector<double> angles;
  for (std::size_t k = 0; k + 1 < coarse.size(); ++k) {
    angles.push_back(coarse[k]);
    angles.push_back(0.5 * (coarse[k] + coarse[k + 1]));
  }
  angles.push_back(M_PI);
  return angles;
}

/// The core's plan raised between base and dish.
void add_core(Body &body, const scene::Bearing &bearing, double radius, const std::vector<double> &angles,
              const std::vector<double> &layers, double size) {
  const auto surface = scene::make_surface(bearing.surface);
  const double base = -bearing.plate.base;
  for (const auto &quad : half_disc(radius, angles, size))
    for (std::size_t j = 0; j + 1 < layers.size(); ++j) {
      std::map<int, Surface> groups;
      for (const auto &[edge, group] : quad.groups) groups[edge] = group;
      if (j == 0) groups[4] = Surface::fixed;
      if (j + 2 == layers.size()) groups[5] = Surface::dish;
      body.add_cell(
          [&](int a, int b, int c) -> std::array<double, 3> {
            const Point2 p = quad.nodes[a + 3 * b];
            const double share = layers[j] + 0.5 * c * (layers[j + 1] - layers[j]);
            return {p[0], p[1], base + share * (surface->at(std::hypot(p[0], p[1]), 0).z - base)};
          },
          Volume::plate, groups);
    }
}

} // namespace

void add_whole_plate(HexMesh &mesh, const scene::Bearing &bearing, const RimMeshOptions &options, bool both_sides) {
  constexpr double core = 0.25; // radius [m]
  const double h = size_factor(options.level), wall = bearing.surface.planar_radius + bearing.rim.ledge;
  const double sector = options.sector_half_angle;
  const std::vector<double> angles = disc_angles(10 * mm * h / wall, 20 * mm / wall, sector, h, both_sides);
  // The massive plate hardly gives: its cells are as coarse as the pad's path allows.
  const double size = 80 * mm * h;
  std::vector<double> layers;
  for (int k = 0, n = options.level; k <= n; ++k) layers.push_back(static_cast<double>(k) / n);
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
  add_core(body, bearing, core, angles, layers, size);
}

} // namespace rimpact::meshes
