#include "buildings/implicit_run.h"
#include "files/error.h"
#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <fmt/format.h>

namespace rimpact::buildings {

using Eigen::MatrixXd, Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;
using reduced::rigid::tr_bdf2_outer, reduced::rigid::tr_bdf2_own;

namespace {
constexpr double wall_width = 1e-9;    ///< within which a wall's touch is located [m]
constexpr double own_bodies = 3;       ///< their positions' tolerance over the building's: they weigh next to nothing
constexpr double converged = 1e-12;    ///< Newton's last correction of a position [m]
constexpr double shortest_step = 1e-9; ///< [s]
} // namespace

ImplicitRun::ImplicitRun(MountedBuilding &building, const scene::Scene &scene)
    : building_(building), excitation_(scene.excitation) {
  const double C = *std::min_element(building.capacity.begin(), building.capacity.end());
  position_tolerance_ = scene.isolator.step_tolerance * 0.01 * C;
  velocity_tolerance_ = scene.isolator.step_tolerance * 0.01 * std::sqrt(building.gravity * C);
  start(scene);
}

VectorXd ImplicitRun::load(const Vector3d &ground) const {
  const auto &m = building_.model;
  VectorXd f = VectorXd::Zero(building_.n);
  for (int d = 0; d < m.n_diaphragms; ++d) f.segment<2>(3 * d) = -m.mass[3 * d] * ground.head<2>();
  f.tail(m.n_nodes) = -(building_.gravity + ground[2]) * m.mass.tail(m.n_nodes);
  return f;
}

void ImplicitRun::start(const scene::Scene &scene) {
  auto &b = building_;
  State &s = at_[0];
  s.q = b.at_rest().head(b.n), s.v = VectorXd::Zero(b.n), s.works = VectorXd::Zero(BuildingBasis::n_works);
  if (scene.excitation.kind == scene::ExcitationKind::free) {
    const Vector2d u = scene.excitation.start_displacement(), v = scene.excitation.start_velocity();
    const double rise = b.mounts[0]->height(u), slope = (b.mounts[0]->height(u + 1e-6 * v) - rise) / 1e-6;
    for (int d = 0; d < b.model.n_diaphragms; ++d) s.q.segment<2>(3 * d) += u, s.v.segment<2>(3 * d) = v;
    s.q.tail(b.model.n_nodes).array() += rise, s.v.tail(b.model.n_nodes).setConstant(slope);
  }
  restart();
}

/// Rates anew, where forces have jumped.
void ImplicitRun::restart() {
  auto &b = building_;
  State &s = at_[0];
  const Vector3d ground = b.ground.acceleration(s.t);
  VectorXd f = load(ground) + b.structure->start(s.q, s.v);
  for (int i = 0; i < b.n_bearings(); ++i) {
    b.mounts[i]->start(s.t, b.node(i, s.q, s.v), ground);
    f += b.over_q[i].transpose() * b.mounts[i]->force();
  }
  s.a = f.cwiseQuotient(b.model.mass);
  s.power = powers(s, 0);
}

VectorXd ImplicitRun::powers(const State &s, int stage) const {
  const auto &b = building_;
  VectorXd p = VectorXd::Zero(BuildingBasis::n_works);
  VectorXd f = load(b.ground.acceleration(s.t));
  f.tail(b.model.n_nodes) += b.gravity * b.model.mass.tail(b.model.n_nodes);
  const auto taken = b.structure->power(stage, s.v);
  p[BuildingBasis::external] = f.dot(s.v);
  p[BuildingBasis::damping] = taken.damping, p[BuildingBasis::hysteretic] = taken.hysteretic;
  for (const auto &mount : b.mounts) {
    const auto one = mount->power(stage);
    p[BuildingBasis::external] += one.external, p[BuildingBasis::friction] += one.friction;
    p[BuildingBasis::rim] += one.rim, p[BuildingBasis::contact] += one.contact;
  }
  return p;
}

bool ImplicitRun::stage(double h, bool last) {
  auto &b = building_;
  const State &from = at_[0], &middle = at_[1];
  State &to = at_[last ? 2 : 1];
  const double own = h * tr_bdf2_own, w1 = last ? h * tr_bdf2_outer : own, w2 = last ? w1 : 0;
  const double reach = last ? h : 2 * own;
  to.t = from.t + reach;
  const Vector3d ground = b.ground.acceleration(to.t);
  const Stage stage{to.t, w1, w2, reach, own, ground};
  VectorXd moved = w1 * from.v, base = from.v + w1 * from.a;
  to.v = from.v + reach * from.a;
  if (last) {
    moved += w2 * middle.v, base += w2 * middle.a;
    to.v = middle.v + (1 - 2 * tr_bdf2_own) * h * middle.a;
  }
  for (const auto &mount : b.mounts) mount->begin_stage(stage);
  b.structure->begin_stage(stage);
  const MatrixXd inertia = (b.model.mass / own).asDiagonal();
  const VectorXd f = load(ground);
  for (int iteration = 0; iteration < 12; ++iteration) {
    to.q = from.q + moved + own * to.v, to.a = (to.v - base) / own;
    VectorXd r = f - b.model.mass.cwiseProduct(to.a);
    MatrixXd J = inertia;
    b.structure->linearise(to.q, to.v, r, J);
    for (int i = 0; i < b.n_bearings(); ++i) {
      const MountForce m = b.mounts[i]->linearise(b.node(i, to.q, to.v));
      const auto &W = b.over_q[i];
      r += W.transpose() * m.force;
      J -= W.transpose() * (m.tangent * W);
    }
    const VectorXd correction = J.partialPivLu().solve(r);
    ++n_newton;
    if (!correction.allFinite()) return false;
    to.v += correction;
    double largest = std::max(correction.lpNorm<Eigen::Infinity>(), b.structure->correct(correction));
    for (int i = 0; i < b.n_bearings(); ++i)
      largest = std::max(largest, b.mounts[i]->correct(b.over_q[i] * correction));
    if (largest * own < converged || largest < 10 * converged) {
      to.q = from.q + moved + own * to.v, to.a = (to.v - base) / own;
      for (const auto &mount : b.mounts) mount->end_stage();
      b.structure->end_stage();
      to.power = powers(to, last ? 2 : 1);
      return true;
    }
  }
  return false;
}

bool ImplicitRun::step(double h) {
  h_ = h;
  if (!stage(h, false) || !stage(h, true)) return false;
  at_[2].works = at_[0].works + h * (tr_bdf2_outer * (at_[0].power + at_[1].power) + tr_bdf2_own * at_[2].power);
  return true;
}

double ImplicitRun::error() const {
  const double e1 = h_ * (4 * tr_bdf2_outer - 1) / 3, e2 = -h_ / 3, e3 = h_ * 2 * tr_bdf2_own / 3;
  const VectorXd x = e1 * at_[0].v + e2 * at_[1].v + e3 * at_[2].v, v = e1 * at_[0].a + e2 * at_[1].a + e3 * at_[2].a;
  double largest = 0;
  for (int d = 0; d < building_.model.n_diaphragms; ++d)
    largest = std::max(
        {largest, x.segment<2>(3 * d).norm() / position_tolerance_, v.segment<2>(3 * d).norm() / velocity_tolerance_});
  const int nn = building_.model.n_nodes;
  largest = std::max({largest, x.tail(nn).lpNorm<Eigen::Infinity>() / position_tolerance_,
                      v.tail(nn).lpNorm<Eigen::Infinity>() / velocity_tolerance_});
  for (const auto &mount : building_.mounts)
    largest = std::max(largest, mount->error(h_) / (own_bodies * position_tolerance_));
  return largest;
}

double ImplicitRun::wall(int stage) const {
  double least = 1e300;
  for (const auto &mount : building_.mounts) least = std::min(least, mount->wall(stage));
  return least;
}

/// The step of length h passes a wall: steps anew to where the first of them stands at zero.
void ImplicitRun::locate_wall(double h) {
  double low = 0, high = h, f_low = std::max(wall(0), 1e-12), f_high = wall(2);
  for (int i = 0; i < 60 && high - low > 1e-13; ++i) {
    double next = (low * (f_high - wall_width / 2) - high * f_low) / (f_high - wall_width / 2 - f_low);
    if (!(next > low && next < high) || i % 8 == 7) next = (low + high) / 2;
    if (!step(next)) {
      high = next;
      continue;
    }
    const double f = wall(2);
    if (f <= 0 && f >= -wall_width) return;
    if (f > 0)
      low = next, f_low = f;
    else
      high = next, f_high = f;
  }
  step(high);
}

bool ImplicitRun::advance(double limit, double &h) {
  for (;;) {
    h = std::min(h, largest_step_);
    const bool clipped = at_[0].t + h * 1.001 >= limit;
    const double length = clipped ? limit - at_[0].t : h;
    if (!(length > 1e-13))
      throw SolverStopped(fmt::format("the time step of the building became too small at t = {:.6g} s", at_[0].t));
    if (!step(length)) {
      h = length / 4;
      continue;
    }
    const double e = error(), factor = std::clamp(0.9 / std::cbrt(std::max(e, 1e-9)), 0.2, 2.0);
    if (e > 1 && length > 1e-6 * largest_step_) {
      h = length * std::min(factor, 0.5);
      continue;
    }
    const bool passed = wall(2) < -wall_width && length > shortest_step;
    if (passed) locate_wall(length);
    const bool at_wall = passed || wall(2) <= 0;
    h = clipped || passed ? std::max(h, length * factor) : length * factor;
    std::swap(at_[0], at_[2]);
    if (clipped && !passed) at_[0].t = limit;
    for (const auto &mount : building_.mounts) mount->accept();
    building_.structure->accept();
    return at_wall;
  }
}

VectorXd ImplicitRun::state() const {
  const auto &b = building_;
  VectorXd y = VectorXd::Zero(b.n_state());
  y.head(b.n) = at_[0].q, y.segment(b.n, b.n) = at_[0].v, y.tail(BuildingBasis::n_works) = at_[0].works;
  y[b.work(BuildingBasis::strain)] = b.structure->stored(at_[0].q);
  for (const auto &mount : b.mounts) {
    y[b.work(BuildingBasis::sliders_kinetic)] += mount->kinetic_energy();
    y[b.work(BuildingBasis::sliders_potential)] += mount->potential_energy();
  }
  return y;
}

BuildingResponse ImplicitRun::response() const {
  BuildingResponse r;
  r.acceleration = at_[0].a, r.ground = building_.ground.acceleration(at_[0].t);
  r.ground_power = at_[0].power[BuildingBasis::external];
  for (const auto &mount : building_.mounts) r.bearings.push_back(mount->response());
  r.members = building_.structure->members(at_[0].q);
  return r;
}

void ImplicitRun::run(double t_end, BuildingRecorder &recorder) {
  double h = 1e-2 * largest_step_;
  recorder.begin(state(), response());
  while (at_[0].t < t_end - 1e-12) {
    const bool at_wall = advance(std::min(recorder.next_sample(), t_end), h);
    recorder.steps.add(at_[0].t);
    for (int b = 0; b < building_.n_bearings(); ++b)
      if (const char *why = building_.mounts[b]->lost())
        throw SolverStopped(fmt::format("bearing {}: {} at t = {:.6g} s", b + 1, why, at_[0].t));
    bool changed = false;
    for (const auto &mount : building_.mounts) changed = (at_wall && mount->change_walls()) || changed;
    if (changed) restart(), h = std::min(h, 1e-2 * largest_step_);
    recorder.step(at_[0].t, state(), response());
  }
  recorder.end(at_[0].t, state(), response());
}

} // namespace rimpact::buildings
