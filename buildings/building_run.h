/// Dormand-Prince steps with error control on each smooth branch of a building on bearings; an event is located by
/// repeating the step with other lengths, as for a single bearing (reduced_models/hybrid_run.h).
#pragma once
#include "buildings/recorder.h"
#include "reduced_models/dormand_prince.h"
#include <functional>

namespace rimpact::buildings {

class BuildingRun {
public:
  BuildingRun(const BuildingDynamics &dynamics, const scene::Scene &scene);
  /// From rest (or as `free` says) to t_end. Throws SolverStopped when a slider leaves its dish or the steps become too
  /// small; what came before is in the recorder.
  void run(double t_end, BuildingRecorder &recorder);

private:
  struct Watch {
    int bearing;
    reduced::Event event;
  };
  std::vector<Watch> watched() const;
  /// Of each watched event: positive before it, through zero at it.
  std::vector<double> values(const std::vector<Watch> &events, double t, const Eigen::VectorXd &y) const;
  void set_scales();
  void try_step(double h);
  double largest_step() const;
  double next_break(double t, double t_end);
  void attempt_until_accepted(double t_limit);
  /// Shortens the step to the first event in it; its place in `events`, or -1.
  int first_event(const std::vector<Watch> &events);
  void locate(const std::vector<Watch> &events, int which, double before, double after);
  void apply(const Watch &watch, double t, Eigen::VectorXd &y, BuildingRecorder &recorder);
  void set_out_on_rims(double t, const Eigen::VectorXd &y, const Eigen::VectorXd &dy);
  void arrive_on_rims(double t, const Eigen::VectorXd &y);
  [[noreturn]] void give_up() const;

  const BuildingDynamics &dynamics_;
  double tolerance_, pulse_step_, contact_step_, h_ = 1e-3;
  Eigen::VectorXd inverse_scale_;
  reduced::DormandPrince<Eigen::VectorXd> step_;
  BearingModes modes_;
  std::vector<double> at_start_; ///< values of the watched events where the step begins
  std::size_t break_index_ = 0;
};

} // namespace rimpact::buildings
