#include "buildings/dynamics.h"
#include "io/files/error.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::buildings {

using Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;
using reduced::Support, reduced::RimContact;

namespace {

void check(const scene::Scene &s) {
  const auto refuse = [](const std::string &what) { throw InputError(what); };
  check_building_scene(s);
  if (s.rigid_bodies() || s.reduced.model != scene::ModelKind::physical)
    refuse(fmt::format("reduced.model \"{}\" by branches: bearings of rigid bodies take the implicit steps",
                       word(s.reduced.model)));
  refuse_friction_beyond_speed(s.reduced.measured, "bearings by branches",
                               "N follows from friction per N; implicit steps take it");
  if (s.reduced.friction != scene::Friction::park_wen)
    refuse("reduced.friction \"coulomb\" by branches: bearings under one rigid base that stick together share their "
           "forces in no definite way; implicit steps have an elastic slip");
}

/// The bearing's scene under its share of the weight.
scene::Scene one_bearing(const scene::Scene &whole, double reaction) {
  scene::Scene s = whole;
  s.load.vertical = std::max(0.0, reaction);
  s.load.mass = s.load.vertical > 0 ? s.load.vertical / s.load.gravity : whole.load.mass;
  return s;
}

} // namespace

void check_building_scene(const scene::Scene &s) {
  if (s.superstructure.any()) throw InputError("a building stands in [building] or in [superstructure], not in both");
  if (!s.excitation.is_dynamic() || s.excitation.kind == scene::ExcitationKind::window)
    throw InputError(
        fmt::format("excitation.kind \"{}\" moves a single bearing; a building takes ricker, record or free",
                    word(s.excitation.kind)));
  if (s.reduced.integrator == scene::Integrator::cvode)
    throw InputError("reduced.integrator \"cvode\" moves a mass on one dish, not a building");
  if (s.reduced.normal_force != scene::NormalForce::inertia)
    throw InputError(fmt::format("reduced.normal_force \"{}\": every bearing of a building has its own, by \"inertia\"",
                                 word(s.reduced.normal_force)));
}

BuildingDynamics::BuildingDynamics(const BuildingModel &m, const scene::Scene &scene,
                                   const std::vector<scene::Scene> &bearings)
    : BuildingBasis(m, scene.load.gravity), vertical_restitution(scene.reduced.vertical_restitution),
      excitation_(scene.excitation) {
  check(scene);
  for (int b = 0; b < static_cast<int>(slider.size()); ++b) {
    laws.emplace_back(one_bearing(bearings.empty() ? scene : bearings.at(b), reactions[b]));
    capacity.push_back(laws[b].lateral_capacity), rim_stiffness.push_back(laws[b].rim.stiffness);
  }
}

VectorXd BuildingDynamics::start() const {
  VectorXd y = start_;
  if (excitation_.kind != scene::ExcitationKind::free) return y;
  const Vector2d u = excitation_.start_displacement(), v = excitation_.start_velocity();
  for (int d = 0; d < model.n_diaphragms; ++d) y.segment<2>(3 * d) += u, y.segment<2>(n + 3 * d) = v;
  const auto p = laws[0].height.at(u[0], u[1]);
  y.segment(3 * model.n_diaphragms, model.n_nodes).array() += p.z;
  y.segment(n + 3 * model.n_diaphragms, model.n_nodes).setConstant(p.gradient.dot(v));
  BearingModes closed(laws.size());
  project(closed, y);
  return y;
}

reduced::State BuildingDynamics::bearing_state(int b, const VectorXd &y) const {
  reduced::State s;
  const Vector3d u = slider[b].of(y.data()), v = slider[b].of(y.data() + n);
  for (int c = 0; c < 3; ++c) s[reduced::iX + c] = u[c], s[reduced::iVX + c] = v[c];
  return s;
}

BearingResponse BuildingDynamics::contact(int b, const reduced::Mode &mode, double t, const VectorXd &y,
                                          Vector3d &per_normal) const {
  const auto &law = laws[b];
  BearingResponse r;
  r.u = slider[b].of(y.data()), r.v = slider[b].of(y.data() + n);
  const Vector2d u = r.u.head<2>(), v = r.v.head<2>();
  const double travel = u.norm();
  r.gap = law.lateral_capacity - travel;
  if (mode.rim == RimContact::pressed) {
    const auto push = law.rim_push(mode, t, u, v);
    r.rim_force = push.inwards;
    r.impact.head<2>() = -push.inwards / travel * u + push.along / travel * Vector2d(-u.y(), u.x());
  }
  if (!(travel < law.height.limit_radius())) { // beyond the dish: inadmissible, the step control cuts the step
    r.height = std::nan("");
    return r;
  }
  const auto p = law.height.at(u[0], u[1]);
  r.height = p.z, r.gradient = p.gradient;
  if (mode.support == Support::airborne) return r;
  r.v[2] = p.gradient.dot(v);
  const Vector2d eta = y.segment<2>(this->eta(b));
  const double mu = law.friction_law.at({.speed = r.v.norm()}).value;
  r.eta_rate = friction::park_wen_rate(eta, v, law.elastic_slip);
  r.friction = law.friction_per_normal(p, u, eta, mu) * eta.norm(); // per unit of N until N is known
  r.pendular = Vector3d(-p.gradient[0], -p.gradient[1], 1) / std::sqrt(1 + p.gradient.squaredNorm());
  r.normal = v.dot(p.hessian * v); // the constraint's v^T H v until N is known
  per_normal = r.pendular + r.friction;
  return r;
}

SupportEquations BuildingDynamics::support_equations(const BuildingResponse &r, const std::vector<int> &closed,
                                                     const std::vector<Vector3d> &per_normal) const {
  SupportEquations equations(model.n_diaphragms);
  const VectorXd &mass = model.mass;
  for (const int b : closed) {
    const Slider &s = slider[b];
    const Vector3d G(-r.bearings[b].gradient[0], -r.bearings[b].gradient[1], 1), &f = per_normal[b];
    equations.add(
        {.diaphragm = s.dof[0] / 3,
         .own = f[2] / mass[s.dof[3]],
         .response = {G[0] / mass[s.dof[0]], G[1] / mass[s.dof[1]], (s.arm_x * G[1] - s.arm_y * G[0]) / mass[s.dof[2]]},
         .push = {f[0], f[1], s.arm_x * f[1] - s.arm_y * f[0]},
         .rest = r.bearings[b].normal - G.dot(s.of(r.acceleration.data()))});
  }
  return equations;
}

BuildingResponse BuildingDynamics::unsupported(const BearingModes &modes, double t, const VectorXd &y,
                                               std::vector<int> &closed, std::vector<Vector3d> &per_normal) const {
  BuildingResponse r;
  r.ground = laws[0].ground.acceleration(t);
  const VectorXd dashpots = model.damping * y.segment(n, n);
  VectorXd force = -(model.stiffness * y.head(n)) - dashpots;
  r.damping_power = y.segment(n, n).dot(dashpots);
  const int nd = model.n_diaphragms, nn = model.n_nodes;
  for (int d = 0; d < nd; ++d) {
    const Vector2d inertia = model.mass[3 * d] * r.ground.head<2>();
    force.segment<2>(3 * d) -= inertia;
    r.ground_power -= inertia.dot(y.segment<2>(n + 3 * d));
  }
  force.tail(nn) -= (gravity + r.ground[2]) * model.mass.tail(nn);
  r.ground_power -= r.ground[2] * model.mass.tail(nn).dot(y.segment(n + 3 * nd, nn));
  per_normal.resize(laws.size()), r.bearings.reserve(laws.size()), closed.reserve(laws.size());
  for (int b = 0; b < n_bearings(); ++b) {
    r.bearings.push_back(contact(b, modes[b], t, y, per_normal[b]));
    if (modes[b].rim == RimContact::pressed) slider[b].add(r.bearings[b].impact, force);
    if (modes[b].support != Support::airborne) closed.push_back(b);
  }
  r.acceleration = force.cwiseQuotient(model.mass);
  return r;
}

BuildingResponse BuildingDynamics::evaluate(const BearingModes &modes, double t, const VectorXd &y) const {
  std::vector<int> closed;
  std::vector<Vector3d> per_normal;
  BuildingResponse r = unsupported(modes, t, y, closed, per_normal);
  if (closed.empty()) return r;
  const VectorXd N = support_equations(r, closed, per_normal).solve();
  VectorXd added = VectorXd::Zero(n);
  for (std::size_t i = 0; i < closed.size(); ++i) {
    auto &b = r.bearings[closed[i]];
    b.normal = N[i], b.pendular *= N[i], b.friction *= N[i];
    slider[closed[i]].add(N[i] * per_normal[closed[i]], added);
  }
  r.acceleration += added.cwiseQuotient(model.mass);
  return r;
}

BuildingResponse BuildingDynamics::rhs(const BearingModes &modes, double t, const VectorXd &y, VectorXd &dy) const {
  BuildingResponse r = evaluate(modes, t, y);
  dy.setZero(n_state());
  dy.head(n) = y.segment(n, n), dy.segment(n, n) = r.acceleration;
  double friction_power = 0, rim_power = 0;
  for (int b = 0; b < n_bearings(); ++b) {
    const auto &bearing = r.bearings[b];
    dy.segment<2>(eta(b)) = bearing.eta_rate;
    friction_power -= bearing.friction.dot(bearing.v), rim_power -= bearing.impact.dot(bearing.v);
    if (std::isnan(bearing.height)) dy.setConstant(bearing.height);
  }
  dy[work(external)] = r.ground_power, dy[work(damping)] = r.damping_power;
  dy[work(friction)] = friction_power, dy[work(rim)] = rim_power;
  return r;
}

void BuildingDynamics::project(const BearingModes &modes, VectorXd &y) const {
  for (int b = 0; b < n_bearings(); ++b) {
    if (modes[b].support == Support::airborne) continue;
    const Vector3d u = slider[b].of(y.data()), v = slider[b].of(y.data() + n);
    const auto p = laws[b].height.at(u[0], u[1]);
    y[slider[b].dof[3]] = p.z, y[n + slider[b].dof[3]] = p.gradient.dot(v.head<2>());
  }
}

} // namespace rimpact::buildings
