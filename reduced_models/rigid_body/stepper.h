/// TR-BDF2 (motion/tr_bdf2.h) for rigid bodies with contacts: both implicit stages by Newton with the analytic tangent.
/// It is L-stable: the slider's contact modes (thousands of rad/s, next to no energy) need not be resolved.
#pragma once
#include "reduced_models/motion/tr_bdf2.h"
#include "reduced_models/rigid_body/chain.h"
#include "reduced_models/rigid_body/storey_link.h"
#include <functional>

namespace rimpact::reduced::rigid {

/// A body's pose after the motion (shift, turn) of its six entries in `motion`.
Pose moved_by(const Pose &pose, const Vector &motion, int body);

struct Works {
  double external = 0, normal = 0, slip = 0, wall = 0, damping = 0, hysteretic = 0; ///< [J]; as rates [W]
};

struct MotionState {
  double t = 0;
  Poses poses;
  Vector velocity, acceleration;
  std::vector<Eigen::Vector3d> slip, slip_rate;
  std::vector<ContactForce> contact;
  std::vector<Eigen::Vector2d> z, z_rate; ///< of the links
  std::vector<LinkForce> link;
  Works works, power;
};

/// What acts beside the contacts.
struct Loads {
  std::function<Eigen::Vector3d(double t)> ground_acceleration; ///< [m/s^2]
  /// Planar path of a driven body; empty: none is driven. Its two dofs must not be free.
  std::function<Eigen::Vector2d(double t)> path;
  int driven = 0;
  double duration = 1; ///< of `path`, from 0 [s]
};

struct StepReport {
  bool converged = false;
  int iterations = 0;
  Vector position_error, velocity_error; ///< of each dof
};

class Stepper {
public:
  Stepper(const System &system, const Loads &loads);
  /// Fills accelerations, contact forces and powers of a state at its instant.
  void start(MotionState &state);
  /// As `start`, for a state a step has led to, where a force jumps: the friction states keep their rates.
  void restart(MotionState &state);
  /// One step from `from`; `to` is meaningful when converged.
  StepReport step(const MotionState &from, double h, MotionState &to);

private:
  template <int n> void linearise(const Poses &poses, double weight, const Matrix &tangent, Chain<n> &chain) const;
  template <int n>
  bool solve(const MotionState &from, const ImplicitStage &stage, const StageStart<Vector> &start, MotionState &to,
             int &iterations);
  bool stage(const MotionState &from, const ImplicitStage &stage, MotionState &at, int &iterations);
  double slip_step(const ImplicitStage &stage) const { return system_.park_wen ? stage.own : stage.reach; }
  Vector applied(double t) const;
  void drive(double t, MotionState &state) const;
  Works powers(const MotionState &state) const;

  const System &system_;
  const Loads &loads_;
  std::vector<int> dofs_;
  std::vector<std::pair<int, int>> held_; ///< body, and which of its entries is not free
  Matrix tangent_;
  MotionState middle_;
};

} // namespace rimpact::reduced::rigid
