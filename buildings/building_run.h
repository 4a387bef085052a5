/// A building's run by events (reduced_models/motion/event_stepper.h): one smooth branch of its bearings after another.
#pragma once
#include "buildings/recorder.h"
#include "reduced_models/motion/event_stepper.h"

namespace rimpact::buildings {

class BuildingRun {
public:
  BuildingRun(const BuildingDynamics &dynamics, const scene::Scene &scene);
  /// From rest (or as `free` says) to t_end. Throws SolverStopped when a slider leaves its dish or the steps become too
  /// small; what came before is in the recorder.
  void run(double t_end, BuildingRecorder &recorder);

  // What the stepper moves.
  using Vector = Eigen::VectorXd;
  struct Watch {
    int bearing;
    reduced::Event event;
  };
  void rhs(double t, const Vector &y, Vector &dy) { end_ = dynamics_.rhs(modes_, t, y, dy); }
  double value(const Watch &watch, double t, const Vector &y) const;
  double value_at_end(const Watch &watch, const reduced::DormandPrince<Vector> &step) const;
  bool begins_at_zero(const Watch &) const { return true; }
  double largest_step() const;
  [[noreturn]] void give_up(double t, const Vector &y) const;

private:
  std::vector<Watch> watched() const;
  Vector scales() const;
  void apply(const Watch &watch, double t, Vector &y, BuildingRecorder &recorder);
  void begin_step_on_rims(double t, const Vector &y, const Vector &dy);
  void arrive_on_rims(double t, const Vector &y);

  const BuildingDynamics &dynamics_;
  double tolerance_, pulse_step_, contact_step_;
  BearingModes modes_;
  BuildingResponse end_; ///< at the end of the step last tried
  reduced::EventStepper<BuildingRun> stepper_{*this};
};

} // namespace rimpact::buildings
