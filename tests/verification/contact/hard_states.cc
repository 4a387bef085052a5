// States contact codes stumble over, on one problem: an elastic block pressed by a plane. Rows that must be right
// carry a reference; the others must end with a status and a sentence.
#include "setups.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::verification {
namespace {

struct Pressed {
  bool converged;
  double force; ///< vertical, on the block [N]
  double shear; ///< friction [N]
  int iterations;
  std::string reason;
};

/// A block of 1 x 1 x 1 m held at the bottom, pressed from above by a plane at z = 1 + gap that moves down by
/// `down` and then sideways by `across` [m].
Pressed press(double gap, double down, double across, double mu, double penalty_factor, bool pushed_off = false) {
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, Volume::rim, {{5, Surface::slider_side}}});
  Setup setup(mesh, elastic(1e9, 0.0));
  for (int i = 0; i < 3; ++i) setup.supports.fix(i, [](const Vector3d &x) { return x.z() < 1e-12; });
  const int body = setup.supports.add_body();
  setup.supports.fix_dof(body + 1);
  setup.make();
  auto &system = *setup.system;
  fe::MasterSurface lid = fe::plane(Vector3d(0, 0, 1 + gap), -Vector3d::UnitZ());
  if (pushed_off) lid.covers = [](const Vector3d &x) { return x.x() < 1.0; }; // the lid ends where the block does
  system.add_contact(Surface::slider_side, lid, contact_options(1e9, 0.5, mu, penalty_factor, body));
  SystemState state = system.at_rest();
  const int x = system.equations().of_dof[body], z = system.equations().of_dof[body + 2];
  fe::StepOptions options;
  options.gap_tolerance = options.slip_tolerance = 1e-8;
  options.max_augmentations = 30;
  Pressed result{true, 0, 0, 0, {}};
  const auto to = [&](double dx, double dz, int pieces) {
    const double from_x = state.u[x], from_z = state.u[z];
    const auto report =
        fe::march(0, 1, {1.0 / pieces, 0.01 / pieces, 1.0 / pieces}, [&](double t, double dt) -> fe::Attempt {
          fe::StepTerms terms{Eigen::VectorXd::Zero(state.u.size())};
          terms.driven = {{x, from_x + (t + dt) * (dx - from_x)}, {z, from_z + (t + dt) * (dz - from_z)}};
          const auto step = static_step(system, state, terms, options);
          result.iterations += step.iterations;
          return {step.converged && !step.capped, 0,
                  step.converged ? "the augmentations' cap was reached" : step.reason};
        });
    result.converged = result.converged && report.finished;
    if (!report.finished) result.reason = report.reason;
  };
  to(0, -down, 2);
  if (across != 0) to(across, -down, 4);
  result.force = -state.reports[0].force.z();
  result.shear = state.reports[0].force.head<2>().norm();
  return result;
}

} // namespace

Table hard_states() {
  Table table;
  // Uniaxial strain of nu = 0: force E ln(l)/l-free form by the law itself: nominal stress E ln(stretch)/stretch.
  const auto nominal = [](double stretch) { return -1e9 * std::log(stretch) / stretch; };
  const auto must = [&](const std::string &name, const Pressed &p, double value, double reference, double scale) {
    constexpr double rounding = 1e-3; // [N], of forces of 10 MN: differs from machine to machine
    table.add({name, 0, std::abs(value) < rounding ? 0 : value, reference, 0, p.iterations, 0});
    table.gate(name + " converged", p.converged ? 0 : 1, 0);
    table.gate(name, (value - reference) / scale, 1e-4);
  };
  const double F = nominal(0.99);
  for (const double factor : {0.01, 1.0, 100.0}) {
    const Pressed p = press(0.0, 0.01, 0, 0, factor);
    must(fmt::format("penalty x {:g}: force", factor), p, p.force, F, F);
  }
  const Pressed overlap = press(-0.01, 0.0, 0, 0, 1);
  must("initial overlap 10 mm: force", overlap, overlap.force, F, F);
  const Pressed never = press(0.5, 0.01, 0, 0.3, 1);
  must("never touching: force", never, never.force, 0, F);
  const Pressed none = press(0, 0, 0, 0.3, 1);
  must("zero load: force", none, none.force, 0, F);
  const Pressed smooth = press(0, 0.01, 0.02, 0.0, 1);
  must("mu 0, slid 20 mm: shear", smooth, smooth.shear, 0, F);
  const Pressed rough = press(0, 0.01, 1e-4, 1.0, 1);
  table.add({"mu 1, moved 0.1 mm: shear", 0, rough.shear, 0, 0, rough.iterations, 0});
  table.gate("mu 1 sticks: shear below the normal force",
             rough.converged ? std::max(0.0, rough.shear / rough.force - 1) : 1, 0);
  const Pressed off = press(0, 0.01, -0.6, 0.1, 1, true);
  table.add({"lid pushed 0.6 m off the block: force", 0, off.force, 0, 0, off.iterations, 0});
  table.gate("pushed off: no NaN", std::isfinite(off.force) ? 0 : 1, 0);
  table.note(off.converged ? "pushed off: converged" : "pushed off: stopped with: " + off.reason);
  return table;
}

} // namespace rimpact::verification
