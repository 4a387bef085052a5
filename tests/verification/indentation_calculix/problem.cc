#include "problem.h"

#include "../../fe_contact/box_mesh.h"
#include "../contact/setups.h"
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace rimpact::verification {

using meshes::Surface;
using meshes::Volume;

double Problem::contact() const {
  return std::sqrt(radius * depth);
}
double Problem::side() const {
  return 6 * contact();
}

Problem problem(const std::string &name) {
  constexpr double E = 200e9, nu = 0.3, density = 7850;
  // Small strains where it stays elastic, for the two codes' elastic laws agree at small strains only.
  if (name == "elastic") return {name, {E, nu, density, {}, {}}, 0.3, 0.1, 1e-5, 10, 1e17};
  if (name == "steel") return {name, {E, nu, density, 300e6, 2e9}, 0.1, 0.01, 1e-4, 1, 1e16};
  throw std::invalid_argument(fmt::format("problem {} is neither elastic nor steel", name));
}

double smallest_cell(const Problem &problem, int cells) {
  return problem.contact() / (0.7 * cells);
}

meshes::HexMesh block(const Problem &problem, int cells) {
  meshes::HexMesh mesh;
  const double L = problem.side();
  const auto grade = graded(cells, smallest_cell(problem, cells) / L);
  test::add_box(mesh, {{0, 0, -1}, {1, 1, 0}, {cells, cells, cells}, Volume::rim, {{5, Surface::slider_side}}},
                [&](std::array<double, 3> x) {
                  return std::array<double, 3>{L * grade(x[0]), L * grade(x[1]), -L * grade(-x[2])};
                });
  return mesh;
}

void add_cap(meshes::HexMesh &mesh, const Problem &problem, int cells) {
  const double width = 1.8 * problem.contact(), thickness = 0.5 * problem.contact(), R = problem.radius;
  test::add_box(
      mesh, {{0, 0, 0}, {width, width, thickness}, {cells, cells, 1}, Volume::upper_slider, {{4, Surface::rim_wall}}},
      [&](std::array<double, 3> x) {
        return std::array<double, 3>{x[0], x[1], R - std::sqrt(R * R - x[0] * x[0] - x[1] * x[1]) + x[2]};
      });
}

} // namespace rimpact::verification
