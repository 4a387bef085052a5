// VERIFICATION 1 and 2: bars thrown against a rigid wall. Contact is a penalty spring without augmentation, a
// conservative potential; steps are cut by their energy error, so a rebound is physics, not the integrator's.
#include "setups.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::verification {
namespace {

struct Throw {
  double rebound = 0, vibration = 0, imbalance = 0, loss = 0, touch = -1, release = -1, mean_force = 0;
  int iterations = 0, steps = 0;
  bool finished = false;
  std::string reason;
};

/// Throws a body along -z with `speed` until `end`; forces are averaged over contact.
Throw thrown(Setup &setup, double speed, double end, const fe::MotionOptions &options) {
  auto &system = *setup.system;
  SystemState state = system.at_rest();
  for (std::size_t dof = 2; dof < system.equations().of_dof.size(); dof += 3)
    if (system.equations().of_dof[dof] >= 0) state.v[system.equations().of_dof[dof]] = -speed;
  const double mass = std::abs(momentum(system, state, 2)) / speed;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(state.u.size());
  Throw result;
  double impulse = 0, before = 0;
  const auto report = fe::run_in_time(
      system, state, end, [&](double) { return none; }, options,
      [&](double t, const SystemState &now, const fe::ContactStepReport &) {
        const double force = now.reports[0].force.z();
        if (force > 0 && result.touch < 0) result.touch = before;
        if (force > 0) result.release = t;
        impulse += (t - before) * force;
        before = t;
      });
  result.rebound = momentum(system, state, 2) / mass;
  const double rigid = 0.5 * mass * result.rebound * result.rebound;
  result.vibration = (report.ledger.kinetic + report.ledger.elastic - rigid) / report.ledger.initial;
  result.imbalance = report.imbalance();
  result.loss = report.ledger.integrator / report.ledger.initial;
  result.mean_force = impulse / (result.release - result.touch);
  result.iterations = report.iterations;
  result.steps = report.march.steps;
  result.finished = report.march.finished;
  if (!result.finished)
    result.reason = fmt::format("; stopped at {:.3g} s: {}", report.march.reached, report.march.reason);
  return result;
}

fe::MotionOptions transient(double step, double energy_tolerance, double rho_inf) {
  fe::MotionOptions options;
  options.step.max_augmentations = 0;
  options.step.rho_inf = rho_inf;
  options.largest_step = step;
  options.contact_step = step;
  options.smallest_step = step * 1e-4;
  options.energy_tolerance = energy_tolerance;
  return options;
}

constexpr double copper_E = 117e9, copper_density = 8930, bar_length = 0.0324, bar_radius = 0.0032;

} // namespace

Table rigid_bar() {
  Table table;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const Timer timer;
    Setup setup(quarter_bar(bar_radius, 0.001, bar_length, 1, 2, Surface::slider_side),
                elastic(copper_E, 0.35, copper_density));
    const auto everywhere = [](const Vector3d &) { return true; };
    for (int i = 0; i < 2; ++i) setup.supports.fix(i, everywhere);
    setup.supports.tie(2, everywhere);
    setup.make();
    setup.system->add_contact(Surface::slider_side, fe::plane(Vector3d::Zero(), Vector3d::UnitZ()),
                              contact_options(copper_E, 0.001, 0));
    // Longest step 2 us: about half the contact's own time, so the cuts do the work.
    const Throw result = thrown(setup, 227, 30e-6, transient(2e-6, tolerance, 1.0));
    table.add({"rebound speed [m/s]", tolerance, result.rebound, 227, 1, result.iterations, timer.seconds()});
    table.gate("run finished", result.finished ? 0 : 1, 0);
    table.note(fmt::format("energy tolerance {:g}: {} steps, imbalance {:.1e}{}", tolerance, result.steps,
                           result.imbalance, result.reason));
  }
  table.gate("rebound of a rigid bar", table.last_error("rebound speed [m/s]"), 0.01);
  table.note("size: energy tolerance of a step; the longest step allowed is 2 us, the penalty's contact takes 5 us");
  return table;
}

Table elastic_bars() {
  Table table;
  for (const int n : {12, 18, 27}) { // steel, 1-D theory: touch 20 us, contact 80 us, 1.6 MN, rebound 100 m/s
    const Timer timer;
    meshes::HexMesh mesh;
    test::add_box(mesh, {{0, 0, 0.002}, {0.02, 0.02, 0.202}, {1, 1, n}, Volume::rim, {{4, Surface::slider_side}}});
    Setup setup(mesh, elastic(200e9, 0.0, 8000));
    const auto everywhere = [](const Vector3d &) { return true; };
    for (int i = 0; i < 2; ++i) setup.supports.fix(i, everywhere);
    setup.make();
    const double h = 0.2 / n;
    setup.system->add_contact(Surface::slider_side, fe::plane(Vector3d::Zero(), Vector3d::UnitZ()),
                              contact_options(200e9, h, 0, 10));
    const Throw result = thrown(setup, 100, 130e-6, transient(h / 5000 / 4, 1e-4, 0.8));
    const int dofs = setup.system->equations().n;
    table.add({"steel: rebound [m/s]", h, result.rebound, 100, std::size_t(dofs), result.iterations, timer.seconds()});
    table.add({"steel: touch [s]", h, result.touch, 20e-6, std::size_t(dofs), result.iterations, timer.seconds()});
    table.add({"steel: contact time [s]", h, result.release - result.touch, 80e-6, std::size_t(dofs), result.iterations,
               timer.seconds()});
    table.add(
        {"steel: mean force [N]", h, result.mean_force, 1.6e6, std::size_t(dofs), result.iterations, timer.seconds()});
    table.note(fmt::format("steel, {} steps{}", result.steps, result.reason));
    table.note(fmt::format("steel, h {:.4g} m: vibration {:.2f} %, integrator {:.2f} % of the energy, imbalance {:.1e}",
                           h, 100 * result.vibration, 100 * result.loss, result.imbalance));
    table.gate("steel: imbalance", result.imbalance, 1e-3);
    table.gate("steel: run finished", result.finished ? 0 : 1, 0);
  }
  table.gate("steel: rebound", table.last_error("steel: rebound [m/s]"), 0.02);
  table.gate("steel: touch", table.last_error("steel: touch [s]"), 0.02);
  table.gate("steel: contact time", table.last_error("steel: contact time [s]"), 0.05);
  for (const int n : {1, 2}) { // the ANSYS case as an elastic bar
    const Timer timer;
    Setup setup(quarter_bar(bar_radius, 0.001, bar_length, n, 8 * n, Surface::slider_side),
                elastic(copper_E, 0.35, copper_density));
    setup.supports.fix(0, [](const Vector3d &x) { return x.x() < 1e-9; });
    setup.supports.fix(1, [](const Vector3d &x) { return x.y() < 1e-9; });
    setup.make();
    const double h = bar_length / (8 * n);
    setup.system->add_contact(Surface::slider_side, fe::plane(Vector3d::Zero(), Vector3d::UnitZ()),
                              contact_options(copper_E, h, 0, 4));
    const Throw result = thrown(setup, 227, 40e-6, transient(4e-7, 1e-4, 0.8));
    const std::size_t dofs = setup.system->equations().n;
    table.add({"copper: centre's rebound [m/s]", h, result.rebound, 227, dofs, result.iterations, timer.seconds()});
    table.add({"copper: energy in vibration", h, result.vibration, 0, dofs, result.iterations, timer.seconds()});
    table.add({"copper: energy unaccounted", h, result.imbalance, 0, dofs, result.iterations, timer.seconds()});
    table.gate("copper: imbalance", result.imbalance, 1e-3);
    table.gate("copper: rebound not above the approach", std::max(0.0, result.rebound / 227 - 1), 0.0);
    table.note(fmt::format("copper, h {:.4g} m: integrator {:.2f} % of the energy", h, 100 * result.loss));
  }
  table.note("size: cell along the bar [m]. The copper bar's reference is the rigid body's speed: what is missing is "
             "vibration, listed below it.");
  return table;
}

Table signorini_bar() {
  Table table;
  constexpr double s = 1e-6; // the problem is homogeneous in its amplitude: small strains by choice
  for (const int n : {20, 40, 80}) {
    const Timer timer;
    meshes::HexMesh mesh;
    test::add_box(
        mesh, {{0, 0, 0}, {0.1, 0.1, 1.0}, {1, 1, n}, Volume::rim, {{4, Surface::slider_side}, {5, Surface::fixed}}});
    Setup setup(mesh, elastic(1.0, 0.0, 1.0));
    const auto everywhere = [](const Vector3d &) { return true; };
    for (int i = 0; i < 2; ++i) setup.supports.fix(i, everywhere);
    setup.supports.fix(Surface::fixed, 2);
    setup.make();
    auto &system = *setup.system;
    const double h = 1.0 / n;
    system.add_contact(Surface::slider_side, fe::plane(Vector3d::Zero(), Vector3d::UnitZ()),
                       contact_options(1.0, h, 0, 10));
    SystemState state = system.at_rest();
    int tip = -1;
    for (std::size_t node = 0; node < setup.space.n_nodes; ++node)
      if (const int equation = setup.equation(node, 2); equation >= 0) {
        state.u[equation] = s * (1 - setup.space.positions[node].z()) / 2;
        if (setup.space.positions[node].z() < 1e-12) tip = equation;
      }
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(state.u.size());
    const fe::StepTerms terms{none};
    system.prepare(state, terms); // the compressed bar's energies, before it is let go
    system.evaluate(state.u, true);
    system.commit(state.u, state, {fe::NextMultipliers::none});
    double square = 0, stress = 0, stress_time = 0, before = 0, energy = 0;
    fe::MotionOptions options = transient(h / 4, 1e-3, 0.8);
    options.smallest_step = h / 64;
    const auto report = fe::run_in_time(
        system, state, 3.0, [&](double) { return none; }, options,
        [&](double t, const SystemState &now, const fe::ContactStepReport &) {
          const double exact = s / 2 * std::max({0.0, 1 - t, t - 2});
          square += (t - before) * std::pow(now.u[tip] - exact, 2);
          if (t > 1.1 && t < 1.9) {
            stress += (t - before) * now.reports[0].force.z() / 0.01;
            stress_time += t - before;
          }
          energy = system.kinetic_energy(now) + now.energies.elastic;
          before = t;
        });
    const std::size_t dofs = system.equations().n;
    table.add(
        {"contact stress / -amplitude", h, stress / stress_time / s, 0.5, dofs, report.iterations, timer.seconds()});
    table.add(
        {"tip displacement, L2 error", h, std::sqrt(square / 3) / s, 0, dofs, report.iterations, timer.seconds()});
    table.add({"energy after a period", h, energy / (s * s * 0.01), 0.125, dofs, report.iterations, timer.seconds()});
    table.gate("imbalance", report.imbalance(), 1e-3);
    table.gate("finished", report.march.finished ? 0 : 1, 0);
    table.note(fmt::format("h {:g}: {} steps, {} cuts, integrator {:.2f} % of the energy", h, report.march.steps,
                           report.march.cuts, 100 * report.ledger.integrator / report.ledger.initial));
  }
  table.gate("contact stress", table.last_error("contact stress / -amplitude"), 0.01);
  table.gate("tip displacement", table.last_error("tip displacement, L2 error"), 0.01);
  table.gate("energy after a period", table.last_error("energy after a period"), 0.05);
  return table;
}

} // namespace rimpact::verification
