/// TR-BDF2 for rigid bodies with contacts: both implicit stages by Newton with the analytic tangent, a
/// third-order error estimate. Source: Bank et al. (1985); coefficients as Hosea and Shampine (1996). Second
/// order, L-stable: the slider's contact modes (thousands of rad/s, next to no energy) need not be resolved.
#pragma once
#include "reduced_models/rigid_body/chain.h"
#include "reduced_models/rigid_body/storey_link.h"
#include <cmath>
#include <functional>

namespace rimpact::reduced::rigid {

/// Weights of TR-BDF2 over a step of 1: of a stage's own rates, and of start and middle stage in the last.
inline const double tr_bdf2_own = 1 - std::sqrt(0.5), tr_bdf2_outer = std::sqrt(2.0) / 4;

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
  struct StageData;
  template <int n> void linearise(const Poses &poses, double weight, const Matrix &tangent, Chain<n> &chain) const;
  template <int n>
  bool solve(const MotionState &from, double h, const Vector &moved, const Vector &base, double t, double slip_step,
             MotionState &to, int &iterations);
  bool stage(const MotionState &from, double h, double weight_from, double weight_middle, double reach, MotionState &at,
             int &iterations);
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
