#include "reduced_models/bearings/physical_model.h"
#include "io/files/error.h"
#include "reduced_models/motion/hybrid_run.h"
#include <cmath>
#include <numbers>

namespace rimpact::reduced {

using Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;

namespace {

/// What drives a solid rim stands on the dish itself: the pad's spring is of the runs without solids.
scene::Scene on_the_dish(scene::Scene scene) {
  if (scene.reduced.normal_force == NormalForce::pad) scene.reduced.normal_force = NormalForce::inertia;
  return scene;
}

} // namespace

struct PhysicalModel::Impl {
  scene::Scene scene;
  Dynamics dynamics;
  explicit Impl(const scene::Scene &s) : scene(on_the_dish(s)), dynamics(scene, false) {}
};

PhysicalModel::PhysicalModel(const scene::Scene &scene) : impl_(std::make_unique<Impl>(scene)) {
  if (scene.rigid_bodies())
    throw InputError("reduced.model \"" + word(scene.reduced.model) +
                     "\" is a bearing of rigid bodies: this is of bearings of one dish only; use `rimpact reduced`");
}
PhysicalModel::~PhysicalModel() = default;
PhysicalModel::PhysicalModel(PhysicalModel &&) noexcept = default;

BearingState PhysicalModel::initial_state() const {
  const auto &x = impl_->scene.excitation;
  BearingState s;
  Vector2d u = Vector2d::Zero(), v = Vector2d::Zero();
  if (x.kind == scene::ExcitationKind::free) {
    u = x.scale * x.initial_displacement, v = x.scale * x.initial_velocity;
  } else if (x.kind == scene::ExcitationKind::window) {
    const double angle = x.direction_deg * std::numbers::pi / 180;
    const Vector2d direction(std::cos(angle), std::sin(angle));
    u = impl_->dynamics.lateral_capacity * direction, v = x.scale * x.speed * direction;
    s.eta = direction; // it comes sliding
  }
  const auto p = height(u[0], u[1]);
  s.u = {u[0], u[1], p.z};
  s.v = {v[0], v[1], p.gradient.dot(v)};
  return s;
}

FlightEnd PhysicalModel::fly(const BearingState &start, double t_end, const StopFunction &stop, Response &response,
                             EnergyLedger &ledger) const {
  Recorder recorder(impl_->dynamics, &response, impl_->scene.reduced.output_step, ledger);
  HybridRun run(impl_->dynamics, impl_->scene);
  const auto result = run.run(start, t_end, stop, recorder);
  ledger = recorder.final_ledger();
  return {result.state, result.stopped};
}

scene::SurfacePoint PhysicalModel::height(double x, double y) const {
  return impl_->dynamics.height.at(x, y);
}

Vector3d PhysicalModel::ground_acceleration(double t) const {
  return impl_->dynamics.ground.acceleration(t);
}

FrictionForce PhysicalModel::smoothed_friction(const Vector3d &u, const Vector3d &v, double normal_force,
                                               double speed_scale) const {
  const auto &d = impl_->dynamics;
  const auto p = d.height.at(u[0], u[1]);
  const Vector3d n = Vector3d(-p.gradient[0], -p.gradient[1], 1).normalized();
  const Matrix3d tangent = Matrix3d::Identity() - n * n.transpose();
  FrictionForce f = friction::regularised(d.friction_law, tangent, v, normal_force, d.heat.at_start(), speed_scale);
  if (d.socket > 0) {
    const double r = std::hypot(u[0], u[1]);
    const Vector2d er = r > 0 ? Vector2d(u.head<2>() / r) : Vector2d::UnitX();
    const Vector3d meridian = Vector3d(er[0], er[1], p.gradient.dot(er)).normalized(), circle(-er[1], er[0], 0);
    const auto k = d.height.curvatures(r);
    const Matrix3d K = k.meridional * meridian * meridian.transpose() + k.circumferential * circle * circle.transpose();
    const Vector3d turn = K * v; // rate of the surface's normal
    const double q = std::sqrt(turn.squaredNorm() + std::pow(k.meridional * speed_scale, 2));
    f.force -= normal_force * d.socket / q * K * turn;
    f.d_normal -= d.socket / q * K * turn;
    f.d_velocity -= normal_force * d.socket / q * K * (Matrix3d::Identity() - turn * turn.transpose() / (q * q)) * K;
  }
  return f;
}

BearingForces PhysicalModel::forces(const BearingState &s) const {
  State y;
  const Mode mode = impl_->dynamics.starting_mode(s, y);
  const Evaluation e = impl_->dynamics.evaluate(mode, s.t, y);
  return {e.pendular, e.friction, Vector3d::Zero(), e.normal};
}

} // namespace rimpact::reduced
