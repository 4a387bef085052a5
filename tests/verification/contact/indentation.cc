#include "indentation.h"

#include <cmath>
#include <stdexcept>

namespace rimpact::verification {
namespace {

/// Block below z = 0 with graded cells; x >= 0 (both halves when it is pushed sideways), y >= 0 or one strip.
meshes::HexMesh block(const Indentation &p, double L, double first, bool both_sides) {
  meshes::HexMesh mesh;
  const auto grade = graded(p.cells, first / L);
  const auto signed_grade = [=](double s) { return s < 0 ? -grade(-s) : grade(s); };
  test::Box box{{both_sides ? -1.0 : 0.0, 0, -1},
                {1, 1, 0},
                {both_sides ? 2 * p.cells : p.cells, p.sphere ? p.cells : 1, p.cells},
                Volume::rim,
                {{5, Surface::slider_side}}};
  test::add_box(mesh, box, [&](std::array<double, 3> x) {
    return std::array<double, 3>{L * signed_grade(x[0]), p.sphere ? L * grade(x[1]) : x[1] * first, -L * grade(-x[2])};
  });
  return mesh;
}

/// Displacement of a half-space z < 0 under forces P (down) and Q (along x) at its origin (Boussinesq, Cerruti).
Vector3d far_field(const Vector3d &x, double P, double Q, double E, double nu) {
  const double G = E / (2 * (1 + nu)), z = -x.z(), r = x.norm(), k = 1 - 2 * nu;
  const Vector3d down =
      P / (4 * M_PI * G) *
      Vector3d(x.x() * z / std::pow(r, 3) - k * x.x() / (r * (r + z)),
               x.y() * z / std::pow(r, 3) - k * x.y() / (r * (r + z)), z * z / std::pow(r, 3) + 2 * (1 - nu) / r);
  const double s = r + z;
  const Vector3d along = Q / (4 * M_PI * G) *
                         Vector3d(1 / r + x.x() * x.x() / std::pow(r, 3) + k * (1 / s - x.x() * x.x() / (r * s * s)),
                                  x.x() * x.y() * (1 / std::pow(r, 3) - k / (r * s * s)),
                                  x.x() * z / std::pow(r, 3) + k * x.x() / (r * s));
  return {down.x() + along.x(), down.y() + along.y(), -down.z() - along.z()};
}

/// Mean of sqrt(1 - r^2/c^2) over r < r0 <= c, on a disc or a strip.
double mean_profile(bool sphere, double c, double r0) {
  const double edge = std::sqrt(1 - r0 * r0 / (c * c));
  return sphere ? 2 * c * c / (3 * r0 * r0) * (1 - std::pow(edge, 3)) : 0.5 * (edge + c / r0 * std::asin(r0 / c));
}

/// Mindlin's stick radius over a from the share q of the friction limit used, on average, inside r < r0:
/// 1 - q = (c/a) mean_profile(c) / mean_profile(a).
double stick_ratio(bool sphere, double a, double r0, double q) {
  double low = r0, high = a;
  for (int i = 0; i < 60; ++i) {
    const double c = 0.5 * (low + high);
    (c / a * mean_profile(sphere, c, r0) < (1 - q) * mean_profile(sphere, a, r0) ? low : high) = c;
  }
  return low / a;
}

} // namespace

void measure(const Indentation &p, const std::vector<fe::SurfaceContact::Sample> &samples,
             const fe::SurfaceContactState &state, IndentationResult &result) {
  double force = 0, moment = 0, contact_area = 0, stick_area = 0, friction_inside = 0, force_inside = 0;
  const double inside = 0.4 * p.half_size;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto &s = samples[k];
    if (s.pressure <= 0) continue;
    const double r2 = p.sphere ? s.position.head<2>().squaredNorm() : s.position.x() * s.position.x();
    force += s.area * s.pressure;
    moment += s.area * s.pressure * r2;
    contact_area += s.area;
    if (state.status[k] == fe::ContactStatus::stick) stick_area += s.area;
    if (r2 > inside * inside) continue;
    friction_inside += s.area * s.friction.x();
    force_inside += s.area * s.pressure;
  }
  // Hertz's profile is p^2 = p0^2 (1 - r^2/a^2): its height by least squares over the contact's inside.
  double s0 = 0, s1 = 0, s2 = 0, t0 = 0, t1 = 0;
  for (const auto &s : samples) {
    const double r2 = p.sphere ? s.position.head<2>().squaredNorm() : s.position.x() * s.position.x();
    if (s.pressure <= 0 || r2 > 0.8 * 0.8 * p.half_size * p.half_size) continue;
    const double x = r2 / (p.half_size * p.half_size), y = s.pressure * s.pressure, w = s.area;
    s0 += w, s1 += w * x, s2 += w * x * x, t0 += w * y, t1 += w * x * y;
  }
  result.peak_pressure = std::sqrt((t0 * s2 - t1 * s1) / (s0 * s2 - s1 * s1));
  result.half_size = std::sqrt((p.sphere ? 2.5 : 4.0) * moment / force); // Hertz: <r^2> = 2 a^2/5, <x^2> = b^2/4
  result.stick_ratio_area = p.sphere ? std::sqrt(stick_area / contact_area) : stick_area / contact_area;
  if (p.tangential > 0)
    result.stick_ratio_traction =
        stick_ratio(p.sphere, p.half_size, inside, std::abs(friction_inside) / (p.mu * force_inside));
}

void load_in_steps(fe::ContactSystem &system, SystemState &state, const std::function<fe::StepTerms(double)> &terms,
                   const fe::StepOptions &options, IndentationResult &result) {
  const auto report = fe::march(0, 1, {0.25, 0.01, 0.25}, [&](double t, double dt) -> fe::Attempt {
    const auto step = static_step(system, state, terms(t + dt), options);
    result.iterations += step.iterations;
    result.residuals = step.residuals;
    return {step.converged, 0, step.reason};
  });
  result.cuts += report.cuts;
  if (!report.finished) throw std::runtime_error("loading stopped: " + report.reason);
}

IndentationResult indent(const Indentation &p) {
  const Timer timer;
  const bool both = p.tangential > 0;
  const double first = p.half_size / (0.45 * p.cells), L = (p.sphere ? 5 : 40) * p.half_size;
  Setup setup(block(p, L, first, both), elastic(p.E, p.nu));
  const double edge = L * (1 - 1e-9);
  const auto outer = [=](const Vector3d &x) {
    return std::abs(x.x()) > edge || (p.sphere && x.y() > edge) || x.z() < -edge;
  };
  if (!both) setup.supports.fix(0, [](const Vector3d &x) { return x.x() < 1e-12; });
  setup.supports.fix(1, [&](const Vector3d &x) { return !p.sphere || x.y() < 1e-12; });
  if (!p.sphere)
    for (const int i : {0, 2}) setup.supports.fix(i, outer);
  const int body = setup.supports.add_body();
  setup.supports.fix_dof(body + 1);
  if (!both) setup.supports.fix_dof(body);
  setup.make();
  auto &system = *setup.system;
  auto options = contact_options(p.E, first, 0, p.penalty_factor, body);
  const Vector3d centre(0, 0, p.radius);
  system.add_contact(Surface::slider_side,
                     p.sphere ? fe::sphere(centre, p.radius, fe::Side::outside)
                              : fe::cylinder(centre, Vector3d::UnitY(), p.radius, fe::Side::outside),
                     options);
  SystemState state = system.at_rest();
  const int x_equation = system.equations().of_dof[body], z_equation = system.equations().of_dof[body + 2];
  const double share = p.sphere ? (both ? 2.0 : 4.0) : (both ? 1.0 : 2.0) / first; // of the whole load
  const double load = p.load / share;

  IndentationResult result{};
  const auto terms_at = [&](double normal, double tangential) {
    fe::StepTerms terms{Eigen::VectorXd::Zero(state.u.size())};
    terms.load[z_equation] = -normal * load;
    if (x_equation >= 0) terms.load[x_equation] = tangential * p.tangential * p.mu * load;
    if (p.sphere)
      for (std::size_t node = 0; node < setup.space.n_nodes; ++node)
        if (const Vector3d x = setup.space.positions[node]; outer(x)) {
          const Vector3d u = far_field(x, normal * p.load, tangential * p.tangential * p.mu * p.load, p.E, p.nu);
          for (int i = 0; i < 3; ++i)
            if (const int equation = setup.equation(node, i); equation >= 0) terms.driven.push_back({equation, u[i]});
        }
    return terms;
  };
  fe::StepOptions step_options;
  step_options.gap_tolerance = 1e-3 * p.half_size * p.half_size / p.radius;
  step_options.slip_tolerance = step_options.gap_tolerance * std::max(p.mu, 0.1);
  step_options.max_augmentations = 15;
  // Bring the body down a little by hand, so that contact can carry the load.
  fe::StepTerms lowered = terms_at(0, 0);
  lowered.driven.push_back({z_equation, -0.05 * p.half_size * p.half_size / p.radius});
  if (x_equation >= 0) lowered.driven.push_back({x_equation, 0.0});
  if (!static_step(system, state, lowered, step_options).converged)
    throw std::runtime_error("the first touch did not converge");
  const auto pressed = [&](double share) {
    auto terms = terms_at(share, 0);
    if (x_equation >= 0) terms.driven.push_back({x_equation, 0.0});
    return terms;
  };
  load_in_steps(system, state, pressed, step_options, result);
  result.depth = -state.u[z_equation];
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

} // namespace rimpact::verification
