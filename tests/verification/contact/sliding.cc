// VERIFICATION 6 (analytic half), 7 and 8: patch test, block on an incline, shallow ironing.
#include "ironing.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::verification {

Table contact_patch() {
  Table table;
  constexpr double E = 1e9, nu = 0.3, pressure = 1e6;
  for (const int n : {2, 3, 4}) {
    const Timer timer;
    meshes::HexMesh mesh;
    test::add_box(mesh, {{0, 0, 0}, {1, 1, 1}, {n, n, n}, Volume::rim, {{4, Surface::slider_side}, {5, Surface::top}}},
                  bumped(0));
    Setup setup(mesh, elastic(E, nu));
    setup.supports.fix(0, [](const Vector3d &x) { return x.x() < 1e-12; });
    setup.supports.fix(1, [](const Vector3d &x) { return x.y() < 1e-12; });
    setup.make();
    auto &system = *setup.system;
    // The plane overlaps a little at the start, so that the block is held.
    system.add_contact(Surface::slider_side, fe::plane(Vector3d(0, 0, 1e-6), Vector3d::UnitZ()),
                       contact_options(E, 1.0 / n, 0));
    SystemState state = system.at_rest();
    const Eigen::VectorXd load = pressed_top(system, pressure);
    fe::StepOptions options;
    options.gap_tolerance = 1e-9;
    options.max_augmentations = 20;
    options.newton.tolerance = 1e-11; // what is left is the test's own error
    const auto step = static_step(system, state, fe::StepTerms{load}, options);
    double worst = 0;
    for (const auto &sample : system.contact(0).samples(system.expand(state), state.contacts[0]))
      worst = std::max(worst, std::abs(sample.pressure / pressure - 1));
    const std::size_t dofs = system.equations().n;
    table.add({"worst pressure error", 1.0 / n, worst, 0, dofs, step.iterations, timer.seconds()});
    table.add(
        {"force / load", 1.0 / n, state.reports[0].force.z() / pressure, 1, dofs, step.iterations, timer.seconds()});
    table.gate("converged", step.converged ? 0 : 1, 0);
  }
  // Dead load on 0.1 % strain: the side faces' traction-free deformation is of that order, nothing else is left.
  table.gate("pressure uniform", table.rows()[table.rows().size() - 2].value, 5e-3);
  table.gate("force", table.last_error("force / load"), 1e-7);
  table.note("pressures are per reference area; distorted inner cells, plane outer faces");
  return table;
}

namespace {

/// A stiff block on a plane tilted by `degrees`: its centre's displacement along the slope after 0.2 s from rest.
double slide(double degrees, double mu, double tolerance, int &iterations, std::size_t &dofs, double &imbalance) {
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, 0}, {0.2, 0.1, 0.05}, {4, 1, 1}, Volume::rim, {{4, Surface::slider_side}}});
  Setup setup(mesh, elastic(1e9, 0.3, 2000));
  setup.supports.fix(1, [](const Vector3d &) { return true; });
  setup.make();
  auto &system = *setup.system;
  auto contact = contact_options(1e9, 0.05, mu);
  system.add_contact(Surface::slider_side, fe::plane(Vector3d(0, 0, 1e-9), Vector3d::UnitZ()), contact);
  SystemState state = system.at_rest();
  const double angle = degrees * M_PI / 180, g = 9.81;
  // Rest first, tilted to where friction only just holds: a sudden release would add the speed of the block's own
  // elastic recoil (a few nanometres of shear, 0.1 mm/s), which Coulomb's rigid block does not have.
  fe::StepOptions still;
  still.gap_tolerance = 1e-9;
  const Eigen::VectorXd normal = system.gravity({0, 0, -g * std::cos(angle)});
  fe::preload(system, state,
              normal + system.gravity({g * std::min(std::sin(angle), 0.99 * mu * std::cos(angle)), 0, 0}), 1e9, still);
  fe::MotionOptions options;
  options.step.gap_tolerance = 1e-8;
  options.step.slip_tolerance = 1e-8;
  options.step.max_augmentations = 3;
  options.step.rho_inf = 0.5;
  options.largest_step = options.contact_step = 0.01;
  options.smallest_step = 1e-5;
  options.energy_tolerance = tolerance;
  const Eigen::VectorXd load = normal + system.gravity({g * std::sin(angle), 0, 0});
  const auto report = fe::run_in_time(
      system, state, 0.2, [&](double) { return load; }, options,
      [](double, const SystemState &, const fe::ContactStepReport &) {});
  iterations = report.iterations;
  dofs = system.equations().n;
  imbalance = report.imbalance();
  const Eigen::VectorXd unit = system.gravity({1, 0, 0});
  return unit.dot(state.u) / unit.dot(Eigen::VectorXd::Ones(state.u.size()));
}

} // namespace

Table incline() {
  Table table;
  constexpr double mu = 0.07, g = 9.81;
  int iterations = 0;
  std::size_t dofs = 0;
  double imbalance = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const Timer timer;
    const double angle = 10 * M_PI / 180, exact = 0.5 * g * (std::sin(angle) - mu * std::cos(angle)) * 0.04;
    const double distance = slide(10, mu, tolerance, iterations, dofs, imbalance);
    table.add({"10 deg: distance in 0.2 s [m]", tolerance, distance, exact, dofs, iterations, timer.seconds()});
  }
  table.gate("distance", table.last_error("10 deg: distance in 0.2 s [m]"), 0.005);
  for (const double degrees : {3.9, 4.1}) { // sticks below 4.004 degrees
    const Timer timer;
    const double angle = degrees * M_PI / 180;
    const double exact = std::max(0.0, 0.5 * g * (std::sin(angle) - mu * std::cos(angle)) * 0.04);
    const double distance = slide(degrees, mu, 1e-3, iterations, dofs, imbalance);
    table.add({fmt::format("{} deg: distance [mm]", degrees), 1e-3, 1e3 * distance, 1e3 * exact, dofs, iterations,
               timer.seconds()});
    table.gate("imbalance", imbalance, 5e-3);
    table.gate(fmt::format("{} deg", degrees), 1e3 * (distance - exact),
               degrees < 4 ? 2e-3 : 2e-2 * 1e3 * exact + 2e-3);
  }
  return table;
}

Table ironing() {
  Table table;
  // Die: an exact cylinder of 3 mm radius, 1 mm down and 10 mm across a slab of 20 x 4 mm.
  constexpr double E = 6.896e8, nu = 0.32, mm = 1e-3, R = 3 * mm, mu = 0.3;
  for (const int n : {20, 30, 45}) {
    const Timer timer;
    meshes::HexMesh mesh;
    test::add_box(mesh,
                  {{0, 0, -4 * mm}, {20 * mm, 1 * mm, 0}, {n, 1, n / 5}, Volume::rim, {{5, Surface::slider_side}}});
    Setup setup(mesh, elastic(E, nu));
    for (int i = 0; i < 3; ++i) setup.supports.fix(i, [](const Vector3d &x) { return x.z() < -4 * mm + 1e-12; });
    setup.supports.fix(1, [](const Vector3d &) { return true; });
    const int die = setup.supports.add_body();
    setup.supports.fix_dof(die + 1);
    setup.make();
    auto &system = *setup.system;
    const double h = 20 * mm / n;
    system.add_contact(Surface::slider_side,
                       fe::cylinder(Vector3d(5 * mm, 0, R), Vector3d::UnitY(), R, fe::Side::outside),
                       contact_options(E, h, mu, 1.0, die));
    Ironing run(system, system.equations().of_dof[die], system.equations().of_dof[die + 2]);
    const auto pressed = run.move(Vector3d::Zero(), Vector3d(0, 0, -1 * mm), 10);
    const int pressing_iterations = run.iterations, pressing_steps = run.steps;
    run.turn();
    const auto slid = run.move(Vector3d(0, 0, -1 * mm), Vector3d(10 * mm, 0, -1 * mm), 200);
    const auto &vertical = run.vertical, &along = run.along;
    const int iterations = run.iterations;
    double mean = 0;
    const double rippled = ripple(vertical, std::max(1, int(std::lround(h / (0.05 * mm)))), mean);
    const std::size_t dofs = system.equations().n;
    table.add({"vertical force [N/mm]", h / mm, std::abs(mean), 0, dofs, iterations, timer.seconds()});
    table.add({"ripple / mean", h / mm, rippled, 0, dofs, iterations, timer.seconds()});
    table.add({"friction / normal at the end", h / mm, std::abs(along.back() / vertical.back()), mu, dofs, iterations,
               timer.seconds()});
    table.add(
        {"Newton iterations a solution", h / mm, double(run.most_a_solution), 0, dofs, iterations, timer.seconds()});
    table.gate("finished", pressed.finished && slid.finished ? 0 : 1, 0);
    const double per_step = double(iterations - pressing_iterations) / (run.steps - pressing_steps);
    table.gate("Newton iterations a sliding step, all augmentations", per_step, 5);
    table.gate("cuts", run.cuts, 0);
    table.note(fmt::format(
        "h {:.2f} mm: {} steps, {} cuts, {:.2f} iterations a sliding step with augmentations; residuals of the last{}",
        h / mm, run.steps, run.cuts, per_step, run.last_residuals()));
  }
  for (const auto &row : table.rows())
    if (row.quantity == "ripple / mean" && row.size < 0.5) table.gate("ripple", row.value, 1e-3);
  return table;
}

} // namespace rimpact::verification
