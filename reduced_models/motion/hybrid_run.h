/// A bearing's run by events (motion/event_stepper.h): the branches of its dynamics one after another, rests between.
#pragma once
#include "reduced_models/motion/event_stepper.h"
#include "reduced_models/record/recorder.h"
#include <optional>

namespace rimpact::reduced {

using StopFunction = std::function<double(const Eigen::Vector3d &u)>;

class HybridRun {
public:
  HybridRun(const Dynamics &dynamics, const scene::Scene &scene);

  struct Result {
    BearingState state;
    Mode mode;
    bool stopped = false;   ///< by the stop function
    bool collapsed = false; ///< the building has: the run ends there
  };
  /// Runs to t_end, or until stop(u) (may be empty) falls to zero. Throws SolverStopped when the slider
  /// leaves the dish or the steps become too small.
  Result run(const BearingState &start, double t_end, const StopFunction &stop, Recorder &recorder);

  // What the stepper moves.
  using Vector = State;
  using Watch = Event;
  void rhs(double t, const State &y, State &dy) { end_ = dynamics_.rhs(mode_, t, y, dy, &footing_); }
  double value(Event event, double t, const State &y) const;
  double value_at_end(Event event, const DormandPrinceStep &step) const;
  bool begins_at_zero(Event event) const { return event != Event::turning; }
  double largest_step() const;
  [[noreturn]] void give_up(double t, const State &y) const;

private:
  State scales(const BearingState &start) const;
  bool stops_accurately();
  void rest(double t_end, Recorder &recorder);
  std::optional<Event> step(double t_end, Recorder &recorder);
  void follow(std::optional<Event> event, Recorder &recorder);

  const Dynamics &dynamics_;
  double tolerance_, pulse_scale_, contact_limit_;
  const StopFunction *stop_ = nullptr;
  bool quiet_ = false; ///< no ground motion
  Footing footing_;
  Evaluation end_; ///< at the end of the step last tried
  Mode mode_;
  EventStepper<HybridRun> stepper_{*this};
};

} // namespace rimpact::reduced
