/// A bearing between ground and a building's node in an implicit step: what it does to the node, its own unknowns
/// condensed. The node's motion past its place at rest: (u_x, u_y, u_z, r_x, r_y, r_z). SI units.
#pragma once
#include "buildings/basis.h"
#include "reduced_models/rigid_body/stepper.h"
#include <memory>

namespace rimpact::buildings {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct NodeMotion {
  Vector6 u = Vector6::Zero(), v = Vector6::Zero();
};

/// A stage (reduced_models/motion/tr_bdf2.h), and a_g there [m/s^2].
struct Stage : reduced::ImplicitStage {
  Eigen::Vector3d ground;
};

/// Force and moment on the node, and their derivative by its velocity, positions following with Stage::own.
struct ElementForce {
  Vector6 force;
  Matrix6 tangent;
};

/// Rates of work taken [W]; `external`: of the ground on the bearing's own bodies.
struct ElementPower {
  double external = 0, friction = 0, rim = 0, contact = 0;
};

class BearingElement {
public:
  virtual ~BearingElement() = default;
  /// Rates at the start of a run, and again where a wall's force has jumped.
  virtual void start(double t, const NodeMotion &node, const Eigen::Vector3d &ground) = 0;
  /// A step begins; the node has this acceleration there.
  virtual void begin_step(double, const Vector6 &) {}
  virtual void begin_stage(const Stage &stage) = 0;
  /// At the node's motion and the own unknowns of this iterate, own imbalance taken to first order. `renew` false: by
  /// the tangent of the iterate before, where own corrections have become small.
  virtual ElementForce linearise(const NodeMotion &node, bool renew) = 0;
  /// Own unknowns follow a correction of the node's velocity; their largest correction [m/s].
  virtual double correct(const Vector6 &node_velocity) = 0;
  virtual void end_stage() = 0;
  /// Local error of the own bodies' positions over a step [m].
  virtual double error(double h) const = 0;
  /// The step's end becomes the next one's start. Throws SolverStopped where what it stands on holds no longer.
  virtual void accept() = 0;
  /// Least distance [m] by which a wall is from its touch, or from opening again, at a stage as `power` numbers them;
  /// below zero: passed.
  virtual double wall(int stage) const = 0;
  /// Walls at or past zero change, met or left; whether one did.
  virtual bool change_walls() = 0;
  virtual bool at_wall() const = 0;                ///< whether one is met
  virtual ElementPower power(int stage) const = 0; ///< 0 the step's start, 1 its middle, 2 its end
  virtual Vector6 force() const = 0;               ///< on the node at the step's end, or after `start`
  virtual double kinetic_energy() const = 0;
  virtual double potential_energy() const = 0; ///< above that at rest
  virtual BearingResponse response() const = 0;
  virtual double height(const Eigen::Vector2d &u) const = 0; ///< of the node at u over that at rest [m]
  virtual const char *lost() const = 0;                      ///< why it cannot go on, or null

  double lateral_capacity = 0, rim_stiffness = 0;
};

} // namespace rimpact::buildings
