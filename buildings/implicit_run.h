/// A building on bearings of any kind, rigid bodies with contact points among them: TR-BDF2 (motion/tr_bdf2.h) of the
/// whole, Newton with analytic tangents, every bearing's own unknowns condensed. Touch and opening of a wall end a
/// step. The node's turn about x and y is the one the condensed frame has without the bearing's moment, whose work on
/// it counts; the turn it adds itself is left out.
#pragma once
#include "buildings/mounted_building.h"
#include "buildings/recorder.h"

namespace rimpact::buildings {

class ImplicitRun {
public:
  ImplicitRun(MountedBuilding &building, const scene::Scene &scene);
  /// From rest (or as `free` says) to t_end. Throws SolverStopped; what came before is in the recorder.
  void run(double t_end, BuildingRecorder &recorder);
  long n_newton = 0;

private:
  struct State {
    double t = 0;
    Eigen::VectorXd q, velocity, acceleration;
    Eigen::VectorXd works, power;
  };
  void start(const scene::Scene &scene);
  void restart();
  bool stage(const reduced::ImplicitStage &stage);
  /// At the motion of this iterate, what is out of balance and its derivative by the velocity; `renew` as a mount's.
  void linearise(const State &to, bool renew, Eigen::VectorXd &residual, Eigen::MatrixXd &tangent);
  /// The bearings' and the structure's unknowns follow; the largest correction [m/s].
  double correct(const Eigen::VectorXd &correction);
  void end_stage(State &to, int stage);
  /// What the bearings do, by their number where it fails.
  void accept();
  bool step(double h);
  double error() const;
  double wall(int stage) const;
  double largest_step() const;
  void locate_wall(double h);
  /// An accepted step; h becomes the next one's length. Whether a wall ended it.
  bool advance(double limit, double &h);
  Eigen::VectorXd load(const Eigen::Vector3d &ground) const;
  Eigen::VectorXd powers(const State &s, int stage) const;
  Eigen::VectorXd state() const;
  BuildingResponse response() const;

  MountedBuilding &building_;
  scene::Excitation excitation_;
  State at_[3]; ///< start, middle, end of a step
  double h_ = 0, position_tolerance_, velocity_tolerance_, contact_step_;
};

} // namespace rimpact::buildings
