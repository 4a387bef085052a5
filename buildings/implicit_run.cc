#include "buildings/implicit_run.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::buildings {

using Eigen::MatrixXd, Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;
namespace tr_bdf2 = reduced::tr_bdf2;

namespace {
constexpr double wall_width = 1e-9;    ///< within which a wall's touch is located [m]
constexpr double own_bodies = 3;       ///< their positions' tolerance over the building's: they weigh next to nothing
constexpr double converged = 1e-12;    ///< Newton's last correction of a position [m]
constexpr double shortest_step = 1e-9; ///< [s]
constexpr double longest = 5e-3;       ///< step [s]
constexpr double steps_a_contact = 20; ///< no fewer over half a period of the base on a rim
constexpr int most_iterations = 12;
/// A correction this small leaves the tangent as it is [m/s]: the next one is measured with the same.
constexpr double kept_below = 1e-6;
} // namespace

ImplicitRun::ImplicitRun(MountedBuilding &building, const scene::Scene &scene)
    : building_(building), excitation_(scene.excitation), contact_step_(longest) {
  for (const double stiffness : building.rim_stiffness)
    if (stiffness > 0)
      contact_step_ =
          std::min(contact_step_, std::numbers::pi * std::sqrt(building.model.mass[0] / stiffness) / steps_a_contact);
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
  s.q = b.at_rest().head(b.n), s.velocity = VectorXd::Zero(b.n), s.works = VectorXd::Zero(BuildingBasis::n_works);
  if (scene.excitation.kind == scene::ExcitationKind::free) {
    const Vector2d u = scene.excitation.start_displacement(), v = scene.excitation.start_velocity();
    const double rise = b.mounts[0]->height(u), slope = (b.mounts[0]->height(u + 1e-6 * v) - rise) / 1e-6;
    for (int d = 0; d < b.model.n_diaphragms; ++d) s.q.segment<2>(3 * d) += u, s.velocity.segment<2>(3 * d) = v;
    s.q.tail(b.model.n_nodes).array() += rise, s.velocity.tail(b.model.n_nodes).setConstant(slope);
  }
  restart();
}

/// Rates anew, where forces have jumped.
void ImplicitRun::restart() {
  auto &b = building_;
  State &s = at_[0];
  const Vector3d ground = b.ground.acceleration(s.t);
  VectorXd f = load(ground) + b.structure->start(s.q, s.velocity);
  for (int i = 0; i < b.n_bearings(); ++i) {
    b.mounts[i]->start(s.t, b.node(i, s.q, s.velocity), ground);
    f += b.over_q[i].transpose() * b.mounts[i]->force();
  }
  s.acceleration = f.cwiseQuotient(b.model.mass);
  s.power = powers(s, 0);
}

VectorXd ImplicitRun::powers(const State &s, int stage) const {
  const auto &b = building_;
  VectorXd p = VectorXd::Zero(BuildingBasis::n_works);
  VectorXd f = load(b.ground.acceleration(s.t));
  f.tail(b.model.n_nodes) += b.gravity * b.model.mass.tail(b.model.n_nodes);
  const auto taken = b.structure->power(stage, s.velocity);
  p[BuildingBasis::external] = f.dot(s.velocity);
  p[BuildingBasis::damping] = taken.damping, p[BuildingBasis::hysteretic] = taken.hysteretic;
  for (const auto &mount : b.mounts) {
    const auto one = mount->power(stage);
    p[BuildingBasis::external] += one.external, p[BuildingBasis::friction] += one.friction;
    p[BuildingBasis::rim] += one.rim, p[BuildingBasis::contact] += one.contact;
  }
  return p;
}

void ImplicitRun::linearise(const State &to, bool renew, VectorXd &residual, MatrixXd &tangent) {
  auto &b = building_;
  residual -= b.model.mass.cwiseProduct(to.acceleration);
  std::vector<NodeMoment> moments;
  for (int i = 0; i < b.n_bearings(); ++i) {
    const ElementForce m = b.mounts[i]->linearise(b.node(i, to.q, to.velocity), renew);
    const auto &W = b.over_q[i];
    residual += W.transpose() * m.force;
    if (renew) tangent -= W.transpose() * (m.tangent * W);
    if (b.structure->turns_nodes())
      moments.push_back({m.force[4], W.transpose() * m.tangent.row(4).transpose(), W.transpose() * m.tangent.col(4),
                         m.tangent(4, 4)});
  }
  b.structure->linearise(to.q, to.velocity, moments, residual, tangent);
}

double ImplicitRun::correct(const VectorXd &correction) {
  auto &b = building_;
  double largest = std::max(correction.lpNorm<Eigen::Infinity>(), b.structure->correct(correction));
  for (int i = 0; i < b.n_bearings(); ++i) {
    Vector6 of_node = b.over_q[i] * correction;
    of_node[4] += b.structure->turn_rate_correction(i);
    largest = std::max(largest, b.mounts[i]->correct(of_node));
  }
  return largest;
}

void ImplicitRun::end_stage(State &to, int stage) {
  for (const auto &mount : building_.mounts) mount->end_stage();
  building_.structure->end_stage();
  to.power = powers(to, stage);
}

bool ImplicitRun::stage(const reduced::ImplicitStage &s) {
  auto &b = building_;
  const State &from = at_[0];
  State &to = at_[s.last ? 2 : 1];
  to.t = s.t;
  const Vector3d ground = b.ground.acceleration(to.t);
  const auto start = tr_bdf2::start<VectorXd>(s, from, at_[1]);
  to.velocity = start.velocity;
  const Stage stage{s, ground};
  for (const auto &mount : b.mounts) mount->begin_stage(stage);
  b.structure->begin_stage(stage);
  const VectorXd f = load(ground), inertia = b.model.mass / s.own;
  const auto follow = [&] {
    to.q = from.q + start.moved + s.own * to.velocity, to.acceleration = (to.velocity - start.base) / s.own;
  };
  Eigen::PartialPivLU<MatrixXd> factor;
  bool renew = true;
  double largest = 0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    follow();
    VectorXd residual = f;
    MatrixXd tangent = inertia.asDiagonal();
    linearise(to, renew, residual, tangent);
    if (renew) factor.compute(tangent);
    const VectorXd correction = factor.solve(residual);
    ++n_newton;
    if (!correction.allFinite()) return false;
    to.velocity += correction;
    const double before = largest;
    largest = correct(correction);
    renew = !(largest < kept_below) || (!renew && largest > 0.1 * before);
    if (!(largest * s.own < converged || largest < 10 * converged)) continue;
    follow();
    end_stage(to, s.last ? 2 : 1);
    return true;
  }
  return false;
}

bool ImplicitRun::step(double h) {
  h_ = h;
  if (!stage(tr_bdf2::middle(at_[0].t, h)) || !stage(tr_bdf2::end(at_[0].t, h))) return false;
  at_[2].works = tr_bdf2::total(h, at_[0].works, at_[0].power, at_[1].power, at_[2].power);
  return true;
}

double ImplicitRun::error() const {
  const VectorXd x = tr_bdf2::error(h_, at_[0].velocity, at_[1].velocity, at_[2].velocity),
                 v = tr_bdf2::error(h_, at_[0].acceleration, at_[1].acceleration, at_[2].acceleration);
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

void ImplicitRun::accept() {
  std::swap(at_[0], at_[2]);
  building_.structure->accept();
  for (int b = 0; b < building_.n_bearings(); ++b) try {
      building_.mounts[b]->accept();
    } catch (const SolverStopped &stop) {
      throw SolverStopped(fmt::format("bearing {}: {}", b + 1, stop.what()));
    }
}

double ImplicitRun::wall(int stage) const {
  double least = 1e300;
  for (const auto &mount : building_.mounts) least = std::min(least, mount->wall(stage));
  return least;
}

double ImplicitRun::largest_step() const {
  const bool at_wall =
      std::any_of(building_.mounts.begin(), building_.mounts.end(), [](const auto &mount) { return mount->at_wall(); });
  return at_wall ? contact_step_ : longest;
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
  for (int b = 0; b < building_.n_bearings(); ++b)
    building_.mounts[b]->begin_step(at_[0].t, building_.over_q[b] * at_[0].acceleration);
  for (;;) {
    h = std::min(h, largest_step());
    const bool clipped = at_[0].t + h * 1.001 >= limit;
    const double length = clipped ? limit - at_[0].t : h;
    if (!(length > 1e-13))
      throw SolverStopped(fmt::format("the time step of the building became too small at t = {:.6g} s", at_[0].t));
    if (!step(length)) {
      h = length / 4;
      continue;
    }
    const double e = error(), factor = std::clamp(0.9 / std::cbrt(std::max(e, 1e-9)), 0.2, 2.0);
    if (e > 1 && length > 1e-6 * longest) {
      h = length * std::min(factor, 0.5);
      continue;
    }
    const bool passed = wall(2) < -wall_width && length > shortest_step;
    if (passed) locate_wall(length);
    const bool at_wall = passed || wall(2) <= 0;
    h = clipped || passed ? std::max(h, length * factor) : length * factor;
    accept();
    if (clipped && !passed) at_[0].t = limit;
    return at_wall;
  }
}

VectorXd ImplicitRun::state() const {
  const auto &b = building_;
  VectorXd y = VectorXd::Zero(b.n_state());
  y.head(b.n) = at_[0].q, y.segment(b.n, b.n) = at_[0].velocity, y.tail(BuildingBasis::n_works) = at_[0].works;
  y[b.work(BuildingBasis::strain)] = b.structure->stored(at_[0].q);
  for (const auto &mount : b.mounts) {
    y[b.work(BuildingBasis::sliders_kinetic)] += mount->kinetic_energy();
    y[b.work(BuildingBasis::sliders_potential)] += mount->potential_energy();
  }
  return y;
}

BuildingResponse ImplicitRun::response() const {
  BuildingResponse r;
  r.acceleration = at_[0].acceleration, r.ground = building_.ground.acceleration(at_[0].t);
  r.ground_power = at_[0].power[BuildingBasis::external];
  for (const auto &mount : building_.mounts) r.bearings.push_back(mount->response());
  r.members = building_.structure->members(at_[0].q);
  return r;
}

void ImplicitRun::run(double t_end, BuildingRecorder &recorder) {
  double h = 1e-2 * longest;
  recorder.begin(state(), response());
  while (at_[0].t < t_end - 1e-12) {
    const bool at_wall = advance(std::min(recorder.next_sample(), t_end), h);
    recorder.steps.add(at_[0].t);
    for (int b = 0; b < building_.n_bearings(); ++b)
      if (const char *why = building_.mounts[b]->lost())
        throw SolverStopped(fmt::format("bearing {}: {} at t = {:.6g} s", b + 1, why, at_[0].t));
    bool changed = false;
    for (const auto &mount : building_.mounts) changed = (at_wall && mount->change_walls()) || changed;
    if (changed) restart(), h = std::min(h, 1e-2 * longest);
    recorder.step(at_[0].t, state(), response());
  }
  recorder.end(at_[0].t, state(), response());
}

} // namespace rimpact::buildings
