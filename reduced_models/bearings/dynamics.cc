#include "reduced_models/bearings/dynamics.h"

#include "io/files/error.h"
#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/rim_curve_file.h"
#include "scene/stack_terms.h"
#include <cmath>

namespace rimpact::reduced {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

bool weightless(const scene::Scene &scene) {
  return scene.excitation.kind == scene::ExcitationKind::window && !scene.excitation.with_weight;
}

NormalForce reading_of(const scene::Scene &scene) {
  return weightless(scene) ? NormalForce::constant : scene.reduced.normal_force; // nothing changes N in a plane
}

} // namespace

Dynamics::Dynamics(const scene::Scene &scene, bool with_rim, double capacity)
    : building(scene), mass(scene.load.mass - building.mass()), supported_mass(scene.load.mass),
      weight(scene.load.vertical),
      lateral_capacity((capacity >= 0 ? capacity : scene.bearing.lateral_capacity()) + scene.reduced.capacity_offset),
      lift_over_rim(scene::lift_over_rim(scene.bearing)),
      height(weightless(scene) ? RidingHeight::plane(scene.bearing, scene.bearing.lateral_capacity())
                               : RidingHeight(scene.bearing, scene.reduced.finite_pad ? scene.load.vertical : 0.0)),
      heat(scene.reduced.measured.heat), contact_radius(scene::contact_radius(scene)), reading(reading_of(scene)),
      ground(scene.excitation, scene.load.gravity) {
  const auto &r = scene.reduced;
  const bool window = scene.excitation.kind == scene::ExcitationKind::window;
  if (!window || scene.excitation.with_friction) {
    friction_law = scene::sliding_law(scene);
    if (r.socket_friction && !height.is_plane()) socket = scene.bearing.contact.steel_steel * socket_arm(scene.bearing);
    if (r.friction == scene::Friction::park_wen) {
      park_wen_ = true, elastic_slip = r.elastic_slip;
      if (!(elastic_slip > 0))
        throw InputError("reduced.elastic_slip_mm " + std::to_string(elastic_slip * 1e3) + " must be above 0");
    }
  } else {
    friction_law = {.mu_slow = 0, .mu_fast = 0};
  }
  if (with_rim && r.k_i > 0)
    rim = r.impact_law->pushed ? laws::curve_element(rim_curve_of(scene)) : r.element(supported_mass);
  if (has_rim()) foot = foot_limit(scene);
  dents = dent_shape(scene);
  if (reading == NormalForce::pad)
    pad_stiffness = scene::pad_stiffness(scene.bearing), pad_retardation = scene::pad_retardation(scene);
  dead_load_ = height.is_plane() ? 0.0 : weight;
  vertical_restitution_ = r.vertical_restitution;
  limit_squared_ = height.limit_radius() * height.limit_radius();
  speed_scale = std::sqrt(scene.load.gravity * lateral_capacity);
  stop_speed = 5 * r.tolerance * speed_scale;
  slow_speed = 1e-4 * speed_scale;
}

void Dynamics::rim_terms(const Mode &mode, double t, const Vector2d &u, const Vector2d &v, Evaluation &e) const {
  const double r = u.norm();
  e.gap = lateral_capacity - r;
  e.gap_rate = r > 0 ? -u.dot(v) / r : -v.norm();
  e.impact.setZero();
  if (mode.rim != RimContact::pressed) return;
  const RimPush push = rim_push(mode, t, u, v);
  e.rim_force = push.inwards;
  e.impact.head<2>() = -push.inwards / r * u + push.along / r * Vector2d(-u.y(), u.x());
}

Vector3d Dynamics::friction_per_normal(const scene::SurfacePoint &p, const Vector2d &u, const Vector2d &v,
                                       double mu) const {
  const double vz = p.gradient.dot(v), speed = std::sqrt(v.squaredNorm() + vz * vz);
  if (!(speed > 0)) return Vector3d::Zero();
  Vector3d f(-mu / speed * v[0], -mu / speed * v[1], -mu / speed * vz);
  if (socket > 0) {
    const double r = u.norm();
    const Vector2d er = r > 0 ? Vector2d(u / r) : Vector2d::UnitX(), ec(-er[1], er[0]);
    const auto k = height.curvatures(r);
    const double slope = p.gradient.dot(er), S = std::sqrt(1 + slope * slope);
    const double wm = k.meridional * S * v.dot(er), wc = k.circumferential * v.dot(ec), w = std::hypot(wm, wc);
    if (w > 0) {
      const double fm = -socket * k.meridional * wm / w, fc = -socket * k.circumferential * wc / w;
      f.head<2>() += fm / S * er + fc * ec;
      f[2] += fm * slope / S;
    }
  }
  return f;
}

Vector3d Dynamics::applied(const Evaluation &e, const State &y, const FloorMotion &base, const Vector3d &a_g) const {
  Vector3d force = e.impact - mass * a_g;
  force[2] -= dead_load_;
  if (building.any()) force += building.force_on_base(y, base);
  return force;
}

namespace {

FloorMotion on_surface(const scene::SurfacePoint &p, const State &y) {
  return {{y[iX], y[iY], p.z}, {y[iVX], y[iVY], p.gradient[0] * y[iVX] + p.gradient[1] * y[iVY]}};
}

FloorMotion in_space(const State &y) {
  return {{y[iX], y[iY], y[iZ]}, {y[iVX], y[iVY], y[iVZ]}};
}

} // namespace

/// Of a mass that the dish carries, by the pad's spring or as it stands.
FloorMotion Dynamics::above(const scene::SurfacePoint &p, const State &y) const {
  return reading == NormalForce::pad ? in_space(y) : on_surface(p, y);
}

/// Of the pad's spring, from where it bears nothing [m]; < 0: the mass is lifted off it.
double Dynamics::pad_compression(const scene::SurfacePoint &p, const State &y) const {
  return dead_load_ / pad_stiffness + p.z - y[iZ];
}

double Dynamics::pad_compression_rate(const scene::SurfacePoint &p, const State &y) const {
  return p.gradient.dot(Vector2d(y[iVX], y[iVY])) - y[iVZ];
}

/// Of spring and dashpot [N]; the pad does not pull. The dashpot comes in over the first tenth of what the dead load
/// compresses, so that no landing jumps.
double Dynamics::pad_force(const scene::SurfacePoint &p, const State &y) const {
  const double pressed = pad_compression(p, y);
  if (!(pressed > 0)) return 0;
  const double share = std::min(1.0, 10 * pad_stiffness * pressed / dead_load_);
  return std::max(0.0, pad_stiffness * (pressed + share * pad_retardation * pad_compression_rate(p, y)));
}

/// What the pad loses [W], >= 0: all that its spring gives back while the mass leaves it behind.
double Dynamics::pad_loss(const scene::SurfacePoint &p, const State &y) const {
  if (!(pad_retardation > 0)) return 0;
  const double of_spring = pad_stiffness * std::max(0.0, pad_compression(p, y));
  return (pad_force(p, y) - of_spring) * pad_compression_rate(p, y);
}

Site Dynamics::on_dish(double t, const State &y) const {
  const auto p = height.at(y[iX], y[iY]);
  return {p, above(p, y), ground.acceleration(t)};
}

Site Dynamics::on_dish(double t, const State &y, Footing &footing) const {
  const Vector2d u(y[iX], y[iY]);
  if (footing.u != u) {
    footing.u = u, footing.dish = height.at(u[0], u[1]);
    footing.frame = TangentFrame(footing.dish, u);
  }
  return {footing.dish, above(footing.dish, y), ground.acceleration(t), &footing.frame};
}

Site Dynamics::site(const Mode &mode, double t, const State &y) const {
  if (mode.support != Support::airborne) return on_dish(t, y);
  return {{}, in_space(y), ground.acceleration(t)};
}

FloorMotion Dynamics::base(const Mode &mode, const State &y) const {
  if (rises(mode)) return in_space(y);
  return on_surface(height.at(y[iX], y[iY]), y);
}

Evaluation Dynamics::evaluate(const Mode &mode, double t, const State &y) const {
  return evaluate(mode, t, y, site(mode, t, y));
}

/// Friction in a direction (Park and Wen: their state), the heat it makes, and N where that follows from friction too.
Vector3d Dynamics::friction_of(const Site &site, const State &y, const Vector2d &direction, Evaluation &e) const {
  const Vector2d u(y[iX], y[iY]), v(y[iVX], y[iVY]);
  const double vz = site.dish.gradient.dot(v), speed = std::sqrt(v.squaredNorm() + vz * vz);
  const double share = park_wen_ ? direction.norm() : 1.0;
  const auto per_normal = [&](double normal) {
    const Vector3d f = friction_per_normal(site.dish, u, direction, mu(speed, normal, y).value);
    return park_wen_ ? Vector3d(f * share) : f;
  };
  if (reading == NormalForce::statics || reading == NormalForce::pad) {
    // N n_z + f_z = -F_z; by pressure N enters its own coefficient, a contraction by mu times the slope.
    const double up = 1 / std::sqrt(1 + site.dish.gradient.squaredNorm()), load = e.normal;
    e.normal = std::max(0.0, load / (up + per_normal(load).z()));
    for (int i = 0; i < 30 && friction_law.by_pressure(); ++i)
      e.normal = std::max(0.0, load / (up + per_normal(e.normal).z()));
  }
  const Vector3d f = per_normal(e.normal);
  if (heats() && e.normal > 0 && friction::passes_over(friction_law.face_share * u.norm(), contact_radius))
    e.heat_flux = mu(speed, e.normal, y).value * e.normal / (friction_law.faces * friction_law.area) * speed * share;
  return e.normal * f;
}

Evaluation Dynamics::evaluate(const Mode &mode, double t, const State &y, const Site &site) const {
  Evaluation e;
  const Vector2d u(y[iX], y[iY]), v(y[iVX], y[iVY]);
  rim_terms(mode, t, u, v, e);
  e.eta_rate.setZero();
  const Vector3d &a_g = site.ground;
  const Vector2d &g = site.dish.gradient;
  if (mode.support == Support::stuck) {
    const double S = std::sqrt(1 + g.squaredNorm());
    const Hold h = hold(mode, t, y, site);
    e.normal = h.normal, e.excess = h.excess;
    e.pendular = h.normal / S * Vector3d(-g[0], -g[1], 1), e.friction = h.friction;
    e.acceleration.setZero();
    return e;
  }
  const Vector3d F = applied(e, y, site.base, a_g);
  if (mode.support == Support::airborne) {
    e.pendular.setZero(), e.friction.setZero();
    e.acceleration = F / mass;
    e.ground_power = -mass * (a_g[0] * v[0] + a_g[1] * v[1] + a_g[2] * y[iVZ]);
    return e;
  }
  const auto &p = site.dish;
  const double S = std::sqrt(1 + g.squaredNorm()), vz = g.dot(v), curvature = v.dot(p.hessian * v);
  if (reading == NormalForce::inertia) e.normal = (mass * curvature + g.dot(F.head<2>()) - F[2]) / S;
  if (reading == NormalForce::constant) e.normal = weight;
  if (reading == NormalForce::statics) e.normal = -F[2]; // what N and friction have to carry together
  if (reading == NormalForce::pad) e.normal = pad_force(p, y);
  Vector2d direction(y[iEX], y[iEY]);
  if (park_wen_) {
    e.eta_rate = friction::park_wen_rate(direction, v, elastic_slip);
  } else {
    const double side = v.squaredNorm() > stop_speed * stop_speed ? v.dot(mode.e0) : 0.0;
    direction = mode.slow ? slow_direction(mode, t, y, site) : side > 0 ? v : side < 0 ? Vector2d(-v) : mode.e0;
  }
  e.friction = friction_of(site, y, direction, e);
  e.pendular = e.normal / S * Vector3d(-g[0], -g[1], 1);
  e.acceleration.head<2>() = (F + e.pendular + e.friction).head<2>() / mass;
  const bool sprung = reading == NormalForce::pad;
  e.acceleration[2] = sprung ? (F + e.pendular + e.friction)[2] / mass : g.dot(e.acceleration.head<2>()) + curvature;
  const double rise = reading == NormalForce::constant ? 0.0 : sprung ? y[iVZ] : vz;
  e.ground_power = -mass * (a_g[0] * v[0] + a_g[1] * v[1] + a_g[2] * rise);
  return e;
}

Evaluation Dynamics::rhs(const Mode &mode, double t, const State &y, State &dy, Footing *footing) const {
  dy.fill(0.0);
  if (!inside(y)) { // beyond the dish: inadmissible, the step control cuts the step
    dy.fill(std::nan(""));
    return {};
  }
  const Site here = footing && mode.support == Support::stuck ? on_dish(t, y, *footing) : site(mode, t, y);
  const Evaluation e = evaluate(mode, t, y, here);
  dy[iX] = y[iVX], dy[iY] = y[iVY];
  dy[iVX] = e.acceleration[0], dy[iVY] = e.acceleration[1];
  dy[iExternal] = e.ground_power;
  dy[iImpact] = -e.impact[0] * y[iVX] - e.impact[1] * y[iVY];
  if (building.any()) building.rates(y, here.base, here.ground, dy);
  if (heats()) heat.rates(y.begin() + heat_begins(), e.heat_flux, dy.begin() + heat_begins());
  if (rises(mode)) dy[iZ] = y[iVZ], dy[iVZ] = e.acceleration[2];
  if (mode.support == Support::airborne) return e;
  dy[iEX] = e.eta_rate[0], dy[iEY] = e.eta_rate[1];
  dy[iSupport] =
      reading == NormalForce::pad ? pad_loss(here.dish, y) : -e.pendular[0] * y[iVX] - e.pendular[1] * y[iVY];
  dy[iFriction] = -e.friction[0] * y[iVX] - e.friction[1] * y[iVY];
  if (reading != NormalForce::constant && e.pendular[2] > 0) // v_z = grad h . v, and grad h = -pendular_xy / pendular_z
    dy[iFriction] += e.friction[2] * (e.pendular[0] * y[iVX] + e.pendular[1] * y[iVY]) / e.pendular[2];
  return e;
}

double Dynamics::kinetic_energy(const State &y) const {
  const double vz = reading == NormalForce::inertia || reading == NormalForce::pad ? y[iVZ] : 0.0;
  return mass / 2 * (y[iVX] * y[iVX] + y[iVY] * y[iVY] + vz * vz) + building.kinetic_energy(y);
}

double Dynamics::potential_energy(const State &y) const {
  if (reading == NormalForce::constant) return y[iSupport];
  double energy = dead_load_ * y[iZ];
  if (reading == NormalForce::pad) { // beyond what the dead load keeps in it
    const double now = std::max(0.0, pad_compression(height.at(y[iX], y[iY]), y)), still = dead_load_ / pad_stiffness;
    energy += pad_stiffness / 2 * (now * now - still * still);
  }
  return energy;
}

} // namespace rimpact::reduced
