// VERIFICATION 8 between two deformable bodies: a die irons a slab of cells that do not match its own.
#include "ironing.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::verification {
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
  std::string reason, residuals;
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
  Ironing die(system, x_equation, z_equation);
  auto report = die.move(Vector3d::Zero(), Vector3d(0, 0, -1 * mm), 20);
  die.turn();
  if (report.finished) report = die.move(Vector3d(0, 0, -1 * mm), Vector3d(10 * mm, 0, -1 * mm), 200);
  Ironed result{};
  result.steps = die.steps, result.cuts = die.cuts, result.iterations = die.iterations, result.most = die.most_a_step;
  result.dofs = system.equations().n, result.finished = report.finished, result.residuals = die.last_residuals();
  if (!report.finished) {
    result.reason = fmt::format("; stopped {:.3f} of the way: {}", report.reached, report.reason);
    return result;
  }
  result.ripple = ripple(die.vertical, std::lround(h / (0.05 * mm)), result.force);
  result.force /= 1 * mm;
  result.friction = std::abs(die.along.back() / die.vertical.back());
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
    table.note(
        fmt::format("h {:.2f} mm: {} steps, {} cuts, {:.1f} iterations a step, {} at most; residuals of the last{}{}",
                    h, r.steps, r.cuts, double(r.iterations) / r.steps, r.most, r.residuals, r.reason));
  }
  return table;
}

} // namespace rimpact::verification
