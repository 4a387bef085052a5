/// The event-driven stepper: Dormand-Prince steps with error control on each smooth branch; an event is
/// located by repeating the step with other lengths, so its accuracy is the integrator's own and not that of
/// an interpolant.
#pragma once
#include "reduced_models/dormand_prince.h"
#include "reduced_models/recorder.h"

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

private:
  struct Crossing {
    bool found = false, by_stop = false;
    Event event{};
  };
  void set_scales(const BearingState &start);
  double largest_step(const Mode &mode) const;
  void try_step(double h);
  double event_value(const Crossing &c, double t, const State &y) const;
  double value_at_end(const Crossing &c) const;
  bool crosses(const Crossing &c);
  void locate(const Crossing &c);
  Crossing first_crossing(const StopFunction &stop);
  bool stops_accurately();
  void rest(double t_end, Recorder &recorder);
  double next_break(double t, double t_end);
  void attempt_until_accepted(double t_limit);

  const Dynamics &dynamics_;
  double tolerance_, pulse_scale_, contact_limit_;
  State inverse_scale_;
  const StopFunction *stop_ = nullptr;
  bool quiet_ = false; ///< no ground motion
  double stop_start_ = 0;
  DormandPrinceStep step_;
  Footing footing_;
  Evaluation end_; ///< at the end of the step last tried
  Mode mode_;
  double h_ = 1e-3;
  std::size_t break_index_ = 0;
};

/// Instant in (t, t_end] at which a mass at rest starts to slide (or lift), or t_end; shared with the CVODE
/// driver.
double end_of_rest(const Dynamics &dynamics, const Mode &mode, const State &y, double t, double t_end, double scan);

} // namespace rimpact::reduced
