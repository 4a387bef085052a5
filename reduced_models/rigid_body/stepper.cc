#include "reduced_models/rigid_body/stepper.h"
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

namespace rimpact::reduced::rigid {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {
/// A correction this small leaves the tangent as it is [m/s, rad/s]: the next one is measured with the same.
constexpr double kept_below = 1e-6;
constexpr int most_iterations = 14;
} // namespace

Pose moved_by(const Pose &pose, const Vector &motion, int body) {
  const Vector3d turn = motion.segment<3>(6 * body + 3);
  const double angle = turn.norm();
  Pose result = pose;
  result.position += motion.segment<3>(6 * body);
  if (angle > 0) result.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * pose.rotation;
  return result;
}

Stepper::Stepper(const System &system, const Loads &loads) : system_(system), loads_(loads) {
  for (int i = 0; i < system.n_dofs(); ++i)
    if (system.free[i]) dofs_.push_back(i);
  const int n = system.planar ? 3 : 6; // of a body's entries
  for (int b = 0; b < static_cast<int>(system.bodies.size()); ++b)
    for (int i = 0; i < n; ++i)
      if (!system.free[6 * b + i * (6 / n)]) held_.push_back({b, i});
}

Vector Stepper::applied(double t) const {
  Vector f = Vector::Zero(system_.n_dofs());
  const Vector3d a = loads_.ground_acceleration(t);
  for (std::size_t i = 0; i < system_.bodies.size(); ++i) f.segment<3>(6 * i) = -system_.bodies[i].mass * a;
  return f;
}

void Stepper::drive(double t, MotionState &s) const {
  if (!loads_.path) return;
  const double dt = 1e-6 * loads_.duration, from = std::max(0.0, t - dt), to = std::min(loads_.duration, t + dt);
  s.poses[loads_.driven].position.head<2>() = loads_.path(t);
  s.velocity.segment<2>(6 * loads_.driven) = (loads_.path(to) - loads_.path(from)) / (to - from);
}

Works Stepper::powers(const MotionState &s) const {
  Works p;
  for (std::size_t i = 0; i < s.contact.size(); ++i) {
    (is_wall(system_.contacts[i].surface) ? p.wall : p.normal) += s.contact[i].normal_power;
    p.slip += s.contact[i].slip_power;
  }
  for (const auto &link : s.link) p.damping += link.damping_power, p.hysteretic += link.hysteretic_power;
  p.external = applied(s.t).dot(s.velocity);
  if (loads_.path) { // the drive balances what the contacts do to the driven body
    Vector3d force = Vector3d::Zero();
    for (std::size_t i = 0; i < s.contact.size(); ++i) {
      const auto &c = system_.contacts[i];
      const Vector3d f = s.contact[i].normal + s.contact[i].friction;
      if (c.body == loads_.driven) force += f;
      if (c.master == loads_.driven) force -= f;
    }
    p.external -= force.head<2>().dot(s.velocity.segment<2>(6 * loads_.driven));
  }
  return p;
}

void Stepper::start(MotionState &s) {
  drive(s.t, s);
  const auto n = system_.contacts.size();
  if (s.slip.size() != n) s.slip.assign(n, Vector3d::Zero());
  s.slip_rate.assign(n, Vector3d::Zero());
  if (s.z.size() != system_.links.size()) s.z.assign(system_.links.size(), Vector2d::Zero());
  Vector f = system_.forces(s.poses, s.velocity, {0, 0, s.slip}, s.contact, nullptr) + applied(s.t);
  add_links(system_, s.poses, s.velocity, {0, 0, s.z}, s.link, f, nullptr);
  s.z_rate.assign(s.z.size(), Vector2d::Zero());
  for (std::size_t i = 0; i < s.z.size(); ++i) {
    const auto &[storey, below, above] = system_.links[i];
    if (storey.hysteresis)
      s.z_rate[i] =
          storey.hysteresis->rate(s.z[i], (s.velocity.segment<2>(6 * above) - s.velocity.segment<2>(6 * below)));
  }
  const Matrix M = system_.mass_matrix(s.poses);
  s.acceleration = Vector::Zero(system_.n_dofs());
  s.acceleration(dofs_) = M(dofs_, dofs_).partialPivLu().solve(f(dofs_)).eval();
  s.power = powers(s);
}

void Stepper::restart(MotionState &s) {
  const auto slip_rate = s.slip_rate;
  start(s);
  s.slip_rate = slip_rate;
}

/// The stage's equations by the velocities: inertia over the stage's weight less the tangent of the forces; what is
/// not free stays.
template <int n>
void Stepper::linearise(const Poses &poses, double weight, const Matrix &tangent, Chain<n> &chain) const {
  const int last = static_cast<int>(system_.bodies.size()) - 1;
  for (int b = 0; b <= last; ++b) {
    const auto own = entries<n>(b);
    chain.diagonal(b) = system_.inertia<n>(b, poses) / weight - tangent(own, own);
    if (b > 0) chain.below(b) = -tangent(own, entries<n>(b - 1));
    if (b < last) chain.above(b) = -tangent(own, entries<n>(b + 1));
  }
  for (const auto &[b, i] : held_) {
    chain.diagonal(b).row(i).setZero(), chain.diagonal(b).col(i).setZero(), chain.diagonal(b)(i, i) = 1;
    if (b > 0) chain.below(b).row(i).setZero(), chain.above(b - 1).col(i).setZero();
    if (b < last) chain.above(b).row(i).setZero(), chain.below(b + 1).col(i).setZero();
  }
  chain.eliminate(last + 1);
}

template <int n>
bool Stepper::solve(const MotionState &from, const ImplicitStage &stage, const StageStart<Vector> &start,
                    MotionState &to, int &iterations) {
  const int n_bodies = static_cast<int>(system_.bodies.size());
  const double weight = stage.own, t = stage.t;
  const Vector load = applied(t);
  Chain<n> chain;
  std::array<typename Chain<n>::Part, max_bodies> x;
  double size = std::numeric_limits<double>::infinity(), least = size;
  to.t = t;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    drive(t, to);
    const Vector motion = start.moved + weight * to.velocity;
    for (int b = 0; b < n_bodies; ++b) to.poses[b] = moved_by(from.poses[b], motion, b);
    drive(t, to);
    const bool kept = size < kept_below;
    Matrix *tangent = kept ? nullptr : &tangent_;
    Vector f = system_.forces(to.poses, to.velocity, {weight, slip_step(stage), to.slip}, to.contact, tangent) + load;
    add_links(system_, to.poses, to.velocity, {weight, weight, to.z}, to.link, f, tangent);
    to.acceleration = (to.velocity - start.base) / weight;
    if (!kept) linearise(to.poses, weight, tangent_, chain);
    for (int b = 0; b < n_bodies; ++b)
      x[b] = f(entries<n>(b)) - system_.inertia<n>(b, to.poses) * to.acceleration(entries<n>(b)).eval();
    for (const auto &[b, i] : held_) x[b][i] = 0;
    chain.solve(n_bodies, x);
    ++iterations;
    const double before = size;
    size = 0;
    for (int b = 0; b < n_bodies; ++b) {
      if (!x[b].allFinite()) return false;
      size = std::max(size, x[b].template lpNorm<Eigen::Infinity>());
      to.velocity(entries<n>(b)) += x[b];
    }
    if (size * weight < 1e-12 || size < 1e-11) {
      to.acceleration = (to.velocity - start.base) / weight;
      return true;
    }
    if (iteration >= 3 && size > least / 2) return false; // it goes to and fro over a kink
    least = std::min(least, size);
    if (kept && size > 0.1 * before) size = std::numeric_limits<double>::infinity();
  }
  return false;
}

bool Stepper::stage(const MotionState &from, const ImplicitStage &stage, MotionState &at, int &iterations) {
  const std::size_t n = system_.contacts.size(), n_links = system_.links.size();
  at.slip_rate.resize(n), at.z.resize(n_links), at.z_rate.resize(n_links);
  at.slip = from.slip;
  if (system_.park_wen)
    for (std::size_t i = 0; i < n; ++i)
      at.slip[i] = tr_bdf2::base(stage, from.slip[i], from.slip_rate[i], middle_.slip_rate[i]);
  for (std::size_t i = 0; i < n_links; ++i)
    at.z[i] = tr_bdf2::base(stage, from.z[i], from.z_rate[i], middle_.z_rate[i]);
  const auto start = tr_bdf2::start<Vector>(stage, from, middle_);
  at.velocity = start.velocity;
  const auto solved = system_.planar ? &Stepper::solve<3> : &Stepper::solve<6>;
  if (!(this->*solved)(from, stage, start, at, iterations)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    at.slip_rate[i] = (at.contact[i].slip - at.slip[i]) / slip_step(stage);
    at.slip[i] = at.contact[i].slip;
  }
  for (std::size_t i = 0; i < n_links; ++i) {
    at.z_rate[i] = (at.link[i].z - at.z[i]) / stage.own;
    at.z[i] = at.link[i].z;
  }
  at.power = powers(at);
  return true;
}

StepReport Stepper::step(const MotionState &from, double h, MotionState &to) {
  StepReport report;
  middle_.poses = to.poses = from.poses;
  if (!stage(from, tr_bdf2::middle(from.t, h), middle_, report.iterations) ||
      !stage(from, tr_bdf2::end(from.t, h), to, report.iterations))
    return report;
  const auto summed = [&](double Works::*p) {
    return tr_bdf2::total(h, from.works.*p, from.power.*p, middle_.power.*p, to.power.*p);
  };
  to.works = {summed(&Works::external), summed(&Works::normal),  summed(&Works::slip),
              summed(&Works::wall),     summed(&Works::damping), summed(&Works::hysteretic)};
  report.position_error = tr_bdf2::error(h, from.velocity, middle_.velocity, to.velocity);
  report.velocity_error = tr_bdf2::error(h, from.acceleration, middle_.acceleration, to.acceleration);
  report.converged = true;
  return report;
}

} // namespace rimpact::reduced::rigid
