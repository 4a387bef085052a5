// VERIFICATION 6 between two deformable bodies: a uniform pressure through cells that do not match.
#include "setups.h"

#include <cmath>

namespace rimpact::verification {
namespace {

/// Two blocks of non-matching, distorted cells under a uniform pressure; the interface, at z = 1, is plane.
meshes::HexMesh patch_mesh(int lower, int upper) {
  meshes::HexMesh mesh;
  test::add_box(mesh,
                {{0, 0, 0}, {1, 1, 1}, {lower, lower, lower}, Volume::rim, {{4, Surface::fixed}, {5, Surface::dish}}},
                bumped(0));
  test::add_box(
      mesh, {{0, 0, 1}, {1, 1, 2}, {upper, upper, upper}, Volume::pad, {{4, Surface::slider_side}, {5, Surface::top}}},
      bumped(1));
  return mesh;
}

struct Patch {
  double square, worst, force; ///< pressure's L2 and largest relative error, force over load
  int iterations;
  bool converged;
  std::size_t dofs;
};

/// n^3 cells below, (3 n / 2)^3 above, `points` Gauss points a direction and face.
Patch patch(int n, int points) {
  constexpr double E = 1e9, nu = 0.3, pressure = 1e6;
  Setup setup(patch_mesh(n, 3 * n / 2), {{Volume::rim, elastic(E, nu)}, {Volume::pad, elastic(E, nu)}});
  setup.supports.fix(0, [](const Vector3d &x) { return x.x() < 1e-12; });
  setup.supports.fix(1, [](const Vector3d &x) { return x.y() < 1e-12; });
  setup.supports.fix(Surface::fixed, 2);
  setup.make();
  auto &system = *setup.system;
  auto contact = contact_options(E, 1.0 / n, 0);
  contact.carrier_faces = Surface::dish;
  contact.points = points;
  // The surfaces overlap a little at the start, so that the upper block is held.
  system.add_contact(Surface::slider_side, fe::plane(Vector3d(0, 0, 1 + 1e-6), Vector3d::UnitZ()), contact);
  SystemState state = system.at_rest();
  const Eigen::VectorXd load = pressed_top(system, pressure);
  fe::StepOptions options;
  options.gap_tolerance = 1e-9;
  options.max_augmentations = 20;
  const auto step = static_step(system, state, fe::StepTerms{load}, options);
  Patch result{
      0, 0, state.reports[0].force.z() / pressure, step.iterations, step.converged, std::size_t(system.equations().n)};
  for (const auto &sample : system.contact(0).samples(system.expand(state), state.contacts[0])) {
    result.worst = std::max(result.worst, std::abs(sample.pressure / pressure - 1));
    result.square += sample.area * std::pow(sample.pressure / pressure - 1, 2);
  }
  result.square = std::sqrt(result.square);
  return result;
}

} // namespace

Table patch_two_bodies() {
  Table table;
  for (const int n : {2, 4, 6}) {
    const Timer timer;
    const Patch r = patch(n, 4);
    table.add({"pressure error, L2", 1.0 / n, r.square, 0, r.dofs, r.iterations, timer.seconds()});
    table.add({"pressure error, worst point", 1.0 / n, r.worst, 0, r.dofs, r.iterations, timer.seconds()});
    table.add({"force / load", 1.0 / n, r.force, 1, r.dofs, r.iterations, timer.seconds()});
    table.gate("converged", r.converged ? 0 : 1, 0);
  }
  table.gate("force", table.last_error("force / load"), 1e-6);
  for (const int points : {4, 8, 16}) {
    const Timer timer;
    const Patch r = patch(4, points);
    table.add({"pressure error, L2, by points", 1.0 / points, r.square, 0, r.dofs, r.iterations, timer.seconds()});
    table.gate("converged", r.converged ? 0 : 1, 0);
  }
  table.gate("pressure by 16 points", table.last_error("pressure error, L2, by points"), 2.5e-3);
  table.note("n^3 cells below, (3 n / 2)^3 above, inner nodes moved; size 1/n, or 1 over the Gauss points a direction "
             "and face");
  return table;
}

} // namespace rimpact::verification
