// run_indentation PROBLEM CELLS: our side of the comparison. Prints one line of JSON: the force on the whole
// sphere at full depth, and what it took.
#include "../contact/setups.h"
#include "problem.h"
#include <fmt/format.h>
#include <iostream>
#include <petscsys.h>

namespace rimpact::verification {
namespace {

std::string run(const Problem &p, int cells) {
  Setup setup(block(p, cells), p.material);
  const double edge = 1e-9 * p.side();
  for (int i = 0; i < 2; ++i) setup.supports.fix(i, [=](const Vector3d &x) { return x[i] < edge; });
  for (int i = 0; i < 3; ++i) setup.supports.fix(i, [&](const Vector3d &x) { return x.z() < edge - p.side(); });
  const int sphere = setup.supports.add_body();
  for (int i = 0; i < 2; ++i) setup.supports.fix_dof(sphere + i);
  setup.make();
  auto &system = *setup.system;
  system.add_contact(Surface::slider_side, fe::sphere({0, 0, p.radius}, p.radius, fe::Side::outside),
                     contact_options(p.material.E, smallest_cell(p, cells), p.mu, p.penalty_factor, sphere));
  SystemState state = system.at_rest();
  const int down = system.equations().of_dof[sphere + 2];

  fe::StepOptions options;
  options.gap_tolerance = options.slip_tolerance = 3e-3 * p.depth;
  int iterations = 0, capped = 0;
  const auto march = fe::march(0, 1, {0.1, 1e-4, 0.25}, [&](double t, double dt) -> fe::Attempt {
    const fe::StepTerms terms{Eigen::VectorXd::Zero(state.u.size()), {{down, -p.depth * (t + dt)}}};
    const auto step = static_step(system, state, terms, options);
    iterations += step.iterations;
    capped += step.capped;
    return {step.converged, 0, step.reason};
  });
  const auto &report = state.reports[0];
  return fmt::format("{{\"finished\": {}, \"reason\": \"{}\", \"force_N\": {:.6f}, \"unknowns\": {}, \"steps\": {}, "
                     "\"cuts\": {}, \"iterations\": {}, \"capped_steps\": {}, \"penetration_m\": {:.3e}}}",
                     march.finished, march.reason, -4 * report.force.z(), system.equations().n, march.steps, march.cuts,
                     iterations, capped, report.penetration);
}

} // namespace
} // namespace rimpact::verification

int main(int argc, char **argv) {
  using namespace rimpact::verification;
  if (argc != 3) {
    std::cerr << "usage: run_indentation PROBLEM CELLS\n";
    return 2;
  }
  PetscInitialize(nullptr, nullptr, nullptr, nullptr);
  try {
    std::cout << run(problem(argv[1]), std::stoi(argv[2])) << "\n";
  } catch (const std::exception &error) {
    std::cerr << "error: " << error.what() << "\n";
    return 2;
  }
  return 0;
}
