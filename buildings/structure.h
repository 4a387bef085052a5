/// What stands on the bearings, in the basis of floors and nodes (assembly.h), as an implicit step sees it. SI units.
#pragma once
#include "buildings/bearing_element.h"

namespace rimpact::buildings {

/// Of a bearing's node about y, past its place at rest.
struct NodeTurn {
  double angle = 0, rate = 0; ///< [rad], [rad/s]
};

/// What a bearing's moment about y does to its node, with what hangs on the node's turn and its rate, positions
/// following with Stage::own. Derivatives by the velocities of the dofs and by the rate.
struct NodeMoment {
  double moment = 0; ///< on the node [N m]
  Eigen::VectorXd by_velocity;
  Eigen::VectorXd force_by_rate; ///< of the dofs' force
  double by_rate = 0;
};

class Structure {
public:
  virtual ~Structure() = default;
  /// Whether bearings' nodes turn about y by unknowns of its own. What stands on them then moves in the plane of x and
  /// z, and their moments come by `NodeMoment`; otherwise the dofs say how nodes turn.
  virtual bool turns_nodes() const { return false; }
  virtual NodeTurn turn(int /*bearing*/) const { return {}; }              ///< of this iterate
  virtual double turn_rate_correction(int /*bearing*/) const { return 0; } ///< of the last `correct` [rad/s]

  struct Rest {
    Eigen::VectorXd q;         ///< under its weight, sliders at height 0
    Eigen::VectorXd reactions; ///< of the bearings [N]
  };
  virtual Rest at_rest() const = 0;
  /// Internal and damping force on the dofs at the start of a step, its own unknowns as they were left.
  virtual Eigen::VectorXd start(const Eigen::VectorXd &q, const Eigen::VectorXd &v) = 0;
  virtual void begin_stage(const Stage &stage) = 0;
  /// Adds its force to `force`, and takes its derivative by the velocity from `tangent`; own imbalance to first order.
  /// `moments`: of the bearings, read by one that turns their nodes.
  virtual void linearise(const Eigen::VectorXd &q, const Eigen::VectorXd &v, const std::vector<NodeMoment> &moments,
                         Eigen::VectorXd &force, Eigen::MatrixXd &tangent) = 0;
  /// Own unknowns follow a correction of the velocity; their largest correction, as a velocity.
  virtual double correct(const Eigen::VectorXd &) { return 0; }
  virtual void end_stage() {}
  /// The step's end becomes the next one's start.
  virtual void accept() {}

  struct Power {
    double damping, hysteretic; ///< taken [W]
  };
  virtual Power power(int stage, const Eigen::VectorXd &v) const = 0; ///< stages as BearingElement::power
  virtual double stored(const Eigen::VectorXd &q) const = 0;          ///< elastic energy at the step's end [J]
  /// At the step's end, for the recorder; empty where the displacements say all.
  virtual MembersResponse members(const Eigen::VectorXd &) const { return {}; }
};

} // namespace rimpact::buildings
