// VERIFICATION 4 and 5 between two deformable bodies: the master is the deformed face of one of them, which carries its
// exact reference surface. Meshes never match.
#include "indentation.h"

#include <cmath>
#include <stdexcept>

namespace rimpact::verification {
namespace {

/// A block with a cylindrical lower face (radius R, axis y) on a flat one, plane strain; the upper is `harder` times
/// as stiff. Of the faces that meet, `plane_is_master` says which carries its surface.
struct Pair {
  Indentation problem; ///< E: of the lower body
  double harder = 1;
  bool plane_is_master = true;
};

meshes::HexMesh pair_mesh(const Pair &pair, double L, double first, double strip) {
  meshes::HexMesh mesh;
  const Indentation &p = pair.problem;
  const bool both = p.tangential > 0;
  const auto add = [&](bool upper, int cells, double smallest) {
    const auto grade = graded(cells, smallest / L);
    const auto signed_grade = [=](double s) { return s < 0 ? -grade(-s) : grade(s); };
    const Surface group = upper == pair.plane_is_master ? Surface::slider_side : Surface::dish;
    test::Box box{{both ? -1.0 : 0.0, 0, upper ? 0.0 : -1.0},
                  {1, 1, upper ? 1.0 : 0.0},
                  {both ? 2 * cells : cells, 1, cells},
                  upper ? Volume::pad : Volume::rim,
                  {{upper ? 4 : 5, group}}};
    if (upper) box.groups[5] = Surface::top;
    test::add_box(mesh, box, [&](std::array<double, 3> x) {
      const double along = L * signed_grade(x[0]),
                   bottom = upper ? p.radius - std::sqrt(p.radius * p.radius - along * along) : 0;
      const double s = std::abs(x[2]), height = upper ? bottom * (1 - grade(s)) + L * grade(s) : -L * grade(s);
      return std::array<double, 3>{along, x[1] * strip, height};
    });
  };
  add(false, p.cells, first);
  add(true, p.cells + 2, 0.83 * first);
  return mesh;
}

/// Presses the bodies together and pushes the upper one along x. Throws std::runtime_error when a step fails.
IndentationResult press(const Pair &pair) {
  const Timer timer;
  const Indentation &p = pair.problem;
  const bool both = p.tangential > 0;
  const double first = p.half_size / (0.45 * p.cells), L = 40 * p.half_size, edge = L * (1 - 1e-9);
  Setup setup(pair_mesh(pair, L, first, first),
              {{Volume::rim, elastic(p.E, p.nu)}, {Volume::pad, elastic(pair.harder * p.E, p.nu)}});
  for (const int i : {0, 2})
    setup.supports.fix(i,
                       [=](const Vector3d &x) { return x.z() < 1e-12 && (std::abs(x.x()) > edge || x.z() < -edge); });
  if (!both) setup.supports.fix(0, [](const Vector3d &x) { return x.x() < 1e-12; });
  setup.supports.fix(1, [](const Vector3d &) { return true; });
  const int down = setup.supports.tie(Surface::top, 2), along = both ? setup.supports.tie(Surface::top, 0) : -1;
  setup.make();
  auto &system = *setup.system;
  auto options = contact_options(p.E, first, 0, p.penalty_factor);
  options.carrier_faces = Surface::dish;
  options.margin = first;
  system.add_contact(Surface::slider_side,
                     pair.plane_is_master
                         ? fe::plane(Vector3d::Zero(), Vector3d::UnitZ())
                         : fe::cylinder({0, 0, p.radius}, Vector3d::UnitY(), p.radius, fe::Side::outside),
                     options);
  SystemState state = system.at_rest();
  const double scale = p.half_size * p.half_size / p.radius, load = p.load * first / (both ? 1 : 2);
  fe::StepOptions step_options;
  step_options.gap_tolerance = 1e-3 * scale;
  step_options.slip_tolerance = step_options.gap_tolerance * std::max(p.mu, 0.1);
  step_options.max_augmentations = 15;
  const auto terms_at = [&](double normal, double tangential) {
    fe::StepTerms terms{Eigen::VectorXd::Zero(state.u.size())};
    terms.load[down] = -normal * load;
    if (along >= 0) terms.load[along] = tangential * p.tangential * p.mu * load;
    return terms;
  };
  IndentationResult result{};
  fe::StepTerms lowered = terms_at(0, 0); // by hand at first, so that contact can carry the load
  lowered.driven.push_back({down, -0.05 * scale});
  if (along >= 0) lowered.driven.push_back({along, 0.0});
  if (const auto step = static_step(system, state, lowered, step_options); !step.converged)
    throw std::runtime_error("the first touch did not converge: " + step.reason);
  const auto pressed = [&](double share) {
    auto terms = terms_at(share, 0);
    if (along >= 0) terms.driven.push_back({along, 0.0});
    return terms;
  };
  load_in_steps(system, state, pressed, step_options, result);
  if (both) {
    system.contact(0).law().friction = fe::FrictionCoefficient::constant(p.mu);
    load_in_steps(
        system, state, [&](double share) { return terms_at(1, share); }, step_options, result);
  }
  measure(p, system.contact(0).samples(system.expand(state), state.contacts[0]), state.contacts[0], result);
  result.size = first;
  result.dofs = system.equations().n;
  result.seconds = timer.seconds();
  return result;
}

} // namespace

Table hertz_two_bodies() {
  Table table;
  constexpr double E = 200e9, nu = 0.3, R = 0.1, load = 1e6; // N/m; the upper body three times as stiff
  const double reduced = E / (1 - nu * nu) * 3 / 4, b = std::sqrt(4 * load * R / (M_PI * reduced)),
               p0 = 2 * load / (M_PI * b);
  for (const bool plane_is_master : {true, false}) {
    const std::string of = plane_is_master ? "plane" : "cylinder";
    for (const int cells : {10, 15, 22}) {
      const auto r = press({{false, E, nu, R, load, b, cells}, 3, plane_is_master});
      table.add({of + ": half-width b [mm]", r.size, 1e3 * r.half_size, 1e3 * b, r.dofs, r.iterations, r.seconds});
      table.add(
          {of + ": peak pressure [MPa]", r.size, 1e-6 * r.peak_pressure, 1e-6 * p0, r.dofs, r.iterations, r.seconds});
      table.gate("cuts", r.cuts, 0);
    }
    table.gate(of + ": half-width", table.last_error(of + ": half-width b [mm]"), 0.01);
    table.gate(of + ": peak pressure", table.last_error(of + ": peak pressure [MPa]"), 0.01);
  }
  table.note("plane, cylinder: which body's face is the master");
  return table;
}

Table mindlin_two_bodies() {
  Table table;
  constexpr double E = 200e9, nu = 0.3, R = 0.1, load = 1e6; // alike bodies: normal and tangential do not couple
  const double b = std::sqrt(8 * load * R * (1 - nu * nu) / (M_PI * E)), reference = std::sqrt(0.5);
  for (const int cells : {10, 15, 22}) {
    const auto r = press({{false, E, nu, R, load, b, cells, 0.3, 0.5}});
    add_stick_rows(table, r, reference);
  }
  table.gate("stick ratio, by traction", table.last_error("stick ratio, by traction"), 0.03);
  table.gate("stick ratio, by area", table.last_error("stick ratio, by area"), 0.08);
  return table;
}

} // namespace rimpact::verification
