// VERIFICATION 4, 5, 6 and 8 between two deformable bodies: the master is the deformed face of one of them, which
// carries its exact reference surface. Meshes never match.
#include "indentation.h"

#include <cmath>
#include <fmt/format.h>
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
    system.contact(0).options().law.friction = fe::FrictionCoefficient::constant(p.mu);
    load_in_steps(
        system, state, [&](double share) { return terms_at(1, share); }, step_options, result);
  }
  measure(p, system.contact(0).samples(system.expand(state), state.contacts[0]), state.contacts[0], result);
  result.size = first;
  result.dofs = system.equations().n;
  result.seconds = timer.seconds();
  return result;
}

/// Two blocks of non-matching, distorted cells under a uniform pressure; the interface, at z = 1, is plane.
meshes::HexMesh patch_mesh(int lower, int upper) {
  meshes::HexMesh mesh;
  const auto bumped = [](double z0) {
    return [=](std::array<double, 3> x) {
      const double z = x[2] - z0, bump = 0.25 * x[0] * (1 - x[0]) * x[1] * (1 - x[1]) * z * (1 - z);
      return std::array<double, 3>{x[0] + bump, x[1] - bump, x[2] + 2 * bump};
    };
  };
  test::add_box(mesh,
                {{0, 0, 0}, {1, 1, 1}, {lower, lower, lower}, Volume::rim, {{4, Surface::fixed}, {5, Surface::dish}}},
                bumped(0));
  test::add_box(
      mesh, {{0, 0, 1}, {1, 1, 2}, {upper, upper, upper}, Volume::pad, {{4, Surface::slider_side}, {5, Surface::top}}},
      bumped(1));
  return mesh;
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

namespace {

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
  const Eigen::VectorXd load = system.surface_load(
      Surface::top, [&](const Vector3d &, const Vector3d &normal) { return Vector3d(-pressure * normal); });
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

namespace {

constexpr double mm = 1e-3, die_radius = 5 * mm;

/// Slab of 20 x 4 mm in n by n/5 cells, the slave; a die with a cylindrical lower face over x = 5 mm, wider than its
/// contact.
meshes::HexMesh ironing_mesh(int n, int die_cells) {
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, -4 * mm}, {20 * mm, 1 * mm, 0}, {n, 1, n / 5}, Volume::rim, {{5, Surface::slider_side}}});
  test::add_box(mesh,
                {{-4.2 * mm, 0, 0},
                 {4.2 * mm, 1 * mm, 1},
                 {die_cells, 1, die_cells / 3},
                 Volume::pad,
                 {{4, Surface::dish}, {5, Surface::top}}},
                [](std::array<double, 3> x) {
                  const double bottom = die_radius - std::sqrt(die_radius * die_radius - x[0] * x[0]);
                  return std::array<double, 3>{5 * mm + x[0], x[1], bottom + (4 * mm - bottom) * x[2]};
                });
  return mesh;
}

struct Ironed {
  double force, ripple, friction; ///< mean [N/m], over the mean, friction over normal force
  int steps = 0, cuts = 0, iterations = 0, most = 0;
  std::size_t dofs = 0;
  bool finished = false;
  std::string reason;
  std::vector<double> residuals;
};

/// The die goes 1 mm down and 10 mm across.
Ironed iron(int n) {
  constexpr double E = 6.896e8, nu = 0.32, mu = 0.3;
  const double h = 20 * mm / n;
  Setup setup(ironing_mesh(n, std::max(9, 3 * (n / 6))),
              {{Volume::rim, elastic(E, nu)}, {Volume::pad, elastic(10 * E, nu)}});
  for (int i = 0; i < 3; ++i) setup.supports.fix(i, [](const Vector3d &x) { return x.z() < -4 * mm + 1e-12; });
  setup.supports.fix(1, [](const Vector3d &) { return true; });
  const int x_equation = setup.supports.tie(Surface::top, 0), z_equation = setup.supports.tie(Surface::top, 2);
  setup.make();
  auto &system = *setup.system;
  auto contact = contact_options(E, h, mu);
  contact.carrier_faces = Surface::dish;
  contact.margin = h;
  system.add_contact(Surface::slider_side,
                     fe::cylinder(Vector3d(5 * mm, 0, die_radius), Vector3d::UnitY(), die_radius, fe::Side::outside),
                     contact);
  SystemState state = system.at_rest();
  fe::StepOptions options;
  options.max_augmentations = 2;
  options.tolerance_between = 1e-2;
  options.gap_tolerance = options.slip_tolerance = 1e-6;
  Ironed result{};
  std::vector<double> vertical, along;
  Eigen::VectorXd change;
  const auto move = [&](const Vector3d &from, const Vector3d &to, int pieces) {
    const auto report =
        fe::march(0, 1, {1.0 / pieces, 0.05 / pieces, 1.0 / pieces}, [&](double t, double dt) -> fe::Attempt {
          fe::StepTerms terms{Eigen::VectorXd::Zero(state.u.size())};
          const Vector3d at = from + (t + dt) * (to - from);
          terms.driven = {{x_equation, at.x()}, {z_equation, at.z()}};
          const Eigen::VectorXd before = state.u;
          const auto step = static_step(system, state, terms, options,
                                        change.size() ? Eigen::VectorXd(state.u + change) : Eigen::VectorXd());
          result.iterations += step.iterations;
          if (!step.converged) {
            change.resize(0);
            return {false, 0, step.reason};
          }
          change = state.u - before;
          result.most = std::max(result.most, step.iterations);
          ++result.steps;
          result.residuals = step.residuals;
          vertical.push_back(-state.reports[0].force.z());
          along.push_back(state.reports[0].force.x());
          return {true, 0, {}};
        });
    result.cuts += report.cuts;
    if (!report.finished) result.reason = fmt::format("; stopped {:.3f} of the way: {}", report.reached, report.reason);
    return report.finished;
  };
  result.finished = move(Vector3d::Zero(), Vector3d(0, 0, -1 * mm), 20);
  change.resize(0);
  vertical.clear(), along.clear();
  result.finished = result.finished && move(Vector3d(0, 0, -1 * mm), Vector3d(10 * mm, 0, -1 * mm), 200);
  result.dofs = system.equations().n;
  if (!result.finished) return result;
  result.ripple = ripple(vertical, std::lround(h / (0.05 * mm)), result.force);
  result.force /= 1 * mm;
  result.friction = std::abs(along.back() / vertical.back());
  return result;
}

} // namespace

Table ironing_two_bodies() {
  Table table;
  for (const int n : {20, 30, 40}) {
    const Timer timer;
    const Ironed r = iron(n);
    const double h = 20.0 / n;
    table.gate("finished", r.finished ? 0 : 1, 0);
    if (r.finished) {
      table.add({"vertical force [N/mm]", h, 1e-3 * r.force, 0, r.dofs, r.iterations, timer.seconds()});
      table.add({"ripple / mean", h, r.ripple, 0, r.dofs, r.iterations, timer.seconds()});
      table.add({"friction / normal at the end", h, r.friction, 0.3, r.dofs, r.iterations, timer.seconds()});
      table.gate("ripple", r.ripple, 0.02);
    }
    std::string residuals;
    for (const double value : r.residuals) residuals += fmt::format(" {:.1e}", value);
    table.note(
        fmt::format("h {:.2f} mm: {} steps, {} cuts, {:.1f} iterations a step, {} at most; residuals of the last{}{}",
                    h, r.steps, r.cuts, double(r.iterations) / r.steps, r.most, residuals, r.reason));
  }
  return table;
}

} // namespace rimpact::verification
