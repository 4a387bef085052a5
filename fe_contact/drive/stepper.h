/// The loop of everything that is stepped: clip at what lies ahead, solve, sharpen events, assess, accept or cut, take
/// events. Drives, tests and benchmarks say what their steps are and run the same loop.
#pragma once
#include "fe_contact/engine/contact_steps.h"
#include "fe_contact/solver/march.h"
#include <vector>

namespace rimpact::fe {

/// What happens within a step, or at its end.
enum class Event {
  lift_off, ///< the mass leaves a dish that is a law
  landing,  ///< the mass is back on it
  release,  ///< the walls have parted after an impact
  miss,     ///< the walls part again without having borne anything
  joining,  ///< the rim may be touched soon: its solids are to join
  parting,  ///< the slider has left the rim
  rest      ///< the slider comes to rest for good, or moves again
};

/// A step that is solved and not yet accepted, or that has just been.
struct SolvedStep {
  double t, dt;              ///< its start and its length [s], or of the load parameter
  const SystemState &before; ///< at its start
  const ContactStepReport &report;
  double end() const { return t + dt; }
};

class Stepper {
public:
  virtual ~Stepper() = default;

protected:
  /// From `start` to `end`, or to the end of the step whose event ends the stretch.
  MarchReport march_to(double start, double end, const StepLimits &limits);

  virtual ContactSystem &system() = 0;
  virtual SystemState &state() = 0;
  /// Before each attempt; may throw.
  virtual void prepare(double /*t*/, double /*dt*/) {}
  /// Length instead of a step that would go beyond what lies ahead; 0: the step may be tried.
  virtual double clipped(double /*t*/, double /*dt*/) const { return 0; }
  virtual ContactStepReport solve(double t, double dt) = 0;
  virtual std::vector<Event> events(const SolvedStep &) const { return {}; }
  /// Events are to fall into a step of this length at most; 0: into any.
  virtual double sharp_step(const std::vector<Event> &) const { return 0; }
  /// Whether the step is good enough, and how long the next one is to be.
  virtual Attempt assess(const SolvedStep &step) = 0;
  virtual void accept(const SolvedStep &step) = 0;
  /// After the step is accepted. True: the stretch ends here.
  virtual bool take(const std::vector<Event> &) { return false; }
  /// After a step whose stretch goes on with a next one of this length.
  virtual void keep(double /*next*/) {}

private:
  Attempt attempt(double t, double dt);
  Attempt refuse(const SystemState &before, Attempt cut);
};

} // namespace rimpact::fe
