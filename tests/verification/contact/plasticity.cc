// VERIFICATION 9: the thick cylinder (first yield, collapse) and Cook's membrane.
#include "setups.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::verification {

Table thick_cylinder() {
  Table table;
  constexpr double a = 0.1, yield = 360e6;
  const scene::Material steel{200e9, 0.3, 7850, yield, 0.0};
  for (const int n : {3, 6, 12}) {
    const Timer timer;
    meshes::HexMesh mesh;
    test::add_box(mesh, {{0, 0, 0}, {1, 1, 1}, {n, n, 1}, Volume::rim, {{0, Surface::slider_side}}},
                  [=](std::array<double, 3> x) {
                    const double r = a * (1 + x[0]), angle = x[1] * M_PI / 2;
                    return std::array<double, 3>{r * std::cos(angle), r * std::sin(angle), 0.1 * a * x[2]};
                  });
    Setup setup(mesh, steel);
    setup.supports.fix(0, [](const Vector3d &x) { return x.x() < 1e-12; });
    setup.supports.fix(1, [](const Vector3d &x) { return x.y() < 1e-12; });
    setup.supports.fix(2, [](const Vector3d &) { return true; });
    setup.make();
    auto &system = *setup.system;
    SystemState state = system.at_rest();
    const Eigen::VectorXd unit =
        system.surface_load(Surface::slider_side, [](const Vector3d &, const Vector3d &normal) {
          return Vector3d(-normal); // outward of the ring's steel is towards the axis
        });
    double first_yield = 0;
    int iterations = 0;
    fe::StepOptions options;
    // Load control up to where no equilibrium exists: the march stops at the collapse load.
    const auto report = fe::march(120e6, 400e6, {10e6, 0.05e6, 10e6}, [&](double p, double dp) -> fe::Attempt {
      const SystemState kept = state;
      const auto step = static_step(system, state, fe::StepTerms{(p + dp) * unit}, options);
      iterations += step.iterations;
      double largest = 0;
      for (const auto &point : state.history) largest = std::max(largest, point.alpha);
      if (step.converged && first_yield == 0 && largest > 0) {
        if (dp > 0.06e6) { // find the onset by small steps
          state = kept;
          return {false, 0.5 * dp, "yields"};
        }
        first_yield = p + dp;
      }
      const bool runs_away = step.converged && (state.u - kept.u).norm() > 0.01 * std::sqrt(state.u.size()) * a;
      if (runs_away) state = kept;
      return {step.converged && !runs_away, 0, step.reason};
    });
    const double h = a / n;
    table.add({"first yield [MPa]", h, 1e-6 * first_yield, 155.6, std::size_t(system.equations().n), iterations,
               timer.seconds()});
    table.add({"collapse [MPa]", h, 1e-6 * report.reached, 288.1, std::size_t(system.equations().n), iterations,
               timer.seconds()});
  }
  table.gate("first yield", table.last_error("first yield [MPa]"), 0.02);
  table.gate("collapse", table.last_error("collapse [MPa]"), 0.005);
  table.note("first yield is seen at the innermost Gauss points, which lie inside the bore's surface");
  return table;
}

namespace {

/// Tip's rise [mm] of Cook's membrane; without `plane_strain` its two faces are free, as in the published figure.
void cook(Table &table, int degree, int n, bool plane_strain, double reference) {
  constexpr double G = 422.5e3, nu = 0.3, mm = 1e-3;
  const Timer timer;
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, 0}, {48, 1, 1}, {n, n, 1}, Volume::rim, {{1, Surface::slider_side}}},
                [=](std::array<double, 3> x) {
                  const double s = x[0] / 48, low = 44 * s, high = 44 + 16 * s;
                  return std::array<double, 3>{mm * x[0], mm * (low + (high - low) * x[1]), mm * x[2]};
                });
  Setup setup(mesh, elastic(2 * G * (1 + nu), nu), degree);
  for (int i = 0; i < 3; ++i) setup.supports.fix(i, [](const Vector3d &x) { return x.x() < 1e-12; });
  if (plane_strain) setup.supports.fix(2, [](const Vector3d &) { return true; });
  setup.make();
  auto &system = *setup.system;
  SystemState state = system.at_rest();
  const Eigen::VectorXd load = system.surface_load(
      Surface::slider_side, [](const Vector3d &, const Vector3d &) { return Vector3d(0, 62.5e3, 0); });
  int iterations = 0;
  const auto report = fe::march(0, 1, {0.1, 0.01, 0.25}, [&](double t, double dt) -> fe::Attempt {
    const auto step = static_step(system, state, fe::StepTerms{(t + dt) * load}, fe::StepOptions{});
    iterations += step.iterations;
    return {step.converged, 0, step.reason};
  });
  double tip = 0;
  const Eigen::VectorXd u = system.expand(state);
  for (std::size_t node = 0; node < setup.space.n_nodes; ++node) {
    const Vector3d x = setup.space.positions[node];
    if (std::abs(x.x() - 48 * mm) < 1e-9 && std::abs(x.y() - 60 * mm) < 1e-9) tip = u[3 * node + 1];
  }
  table.add({fmt::format("Q{} tip, {} [mm]", degree, plane_strain ? "plane strain" : "free faces"), 48.0 / n, tip / mm,
             reference, std::size_t(system.equations().n), iterations, timer.seconds()});
  table.gate("finished", report.finished ? 0 : 1, 0);
}

} // namespace

Table cook_membrane() {
  Table table;
  constexpr double independent = 13.9426; // cook_reference.py, extrapolated from 4, 8, 16 cells a side
  constexpr double published = 14.74;
  for (const int degree : {1, 2})
    for (const int n : {4, 8, 16}) cook(table, degree, n, true, independent);
  for (const int n : {2, 4, 8}) cook(table, 2, n, false, published);
  table.gate("Q2 tip, plane strain", table.last_error("Q2 tip, plane strain [mm]"), 0.001);
  table.gate("Q1 tip, plane strain", table.last_error("Q1 tip, plane strain [mm]"), 0.02);
  table.gate("Q2 tip, free faces", table.last_error("Q2 tip, free faces [mm]"), 0.02);
  table.note("plane strain: reference by the independent program cook_reference.py with the same (Hencky) law");
  table.note(
      "free faces: published 14.74, a neo-Hookean law; that program marks its faces by the wrong coordinate and so");
  table.note("does not hold them, which is why the figure is not met in plane strain (neo-Hooke there: 13.77)");
  return table;
}

} // namespace rimpact::verification
