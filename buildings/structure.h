/// What stands on the bearings, in the basis of floors and nodes (assembly.h), as an implicit step sees it. SI units.
#pragma once
#include "buildings/bearing_element.h"

namespace rimpact::buildings {

class Structure {
public:
  virtual ~Structure() = default;

  struct Rest {
    Eigen::VectorXd q;         ///< under its weight, sliders at height 0
    Eigen::VectorXd reactions; ///< of the bearings [N]
  };
  virtual Rest at_rest() const = 0;
  /// Internal and damping force on the dofs at the start of a step, its own unknowns as they were left.
  virtual Eigen::VectorXd start(const Eigen::VectorXd &q, const Eigen::VectorXd &v) = 0;
  virtual void begin_stage(const Stage &stage) = 0;
  /// Adds its force to `force`, and takes its derivative by the velocity from `tangent`; own imbalance to first order.
  virtual void linearise(const Eigen::VectorXd &q, const Eigen::VectorXd &v, Eigen::VectorXd &force,
                         Eigen::MatrixXd &tangent) = 0;
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
