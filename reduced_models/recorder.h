/// Watches a run: stores samples, keeps peaks, impacts and the energy ledger. Knows nothing of integrators:
/// it is handed smooth segments with an interpolant, and the events between them.
#pragma once
#include "reduced_models/building_recorder.h"
#include "reduced_models/dynamics.h"
#include <functional>

namespace rimpact::reduced {

/// A piece of the solution on one branch; `at` interpolates to the integrator's own order.
struct Segment {
  double t0, t1;
  const State &y0, &y1;
  std::function<State(double)> at;
  const Evaluation *end = nullptr; ///< of (t1, y1) on this branch, where it is known
};

class Recorder {
public:
  /// `response` may be null: peaks and impacts only.
  Recorder(const Dynamics &dynamics, Response *response, double output_step, const EnergyLedger &before = {});

  void begin(const Mode &mode, double t, const State &y);
  /// A segment that ends at rest on the pressed rim has both sides of friction's jump stored.
  void segment(const Mode &mode, const Segment &segment, bool rim_changes_at_end);
  /// After an event: the branch may have changed, `loss` is energy lost in a landing.
  void branch(const Mode &before, const Mode &after, double t, const State &y, double loss);
  void end(const Mode &mode, double t, const State &y);

  EnergyLedger ledger(const Mode &mode, const State &y) const;
  EnergyLedger final_ledger() const { return ledger(final_mode_, final_); } ///< after `end`
  /// Peaks, impacts and energies. Call after `end`.
  void summarise(Summary &summary, bool collapsed = false) const;
  double smallest_gap() const { return smallest_gap_; }

private:
  static constexpr double beside = 1e-6; ///< samples beside a jump of a force stand this far from it [s]
  void store(const Mode &mode, double t, const State &y,
             double apart = beside / 2); ///< none sooner than `apart` after the last [s]
  void open_impact(double t, const State &y);
  void close_impact(double t, const State &y);
  BuildingSnapshot building_at(const State &y) const; ///< of a state that is on the surface where the dish carries it
  void store_before(const Mode &mode, const Segment &segment);
  void refine_drifts(const Segment &segment, const State &middle);
  void watch(const Mode &mode, const State &y, const Evaluation &e);
  void refine(const Mode &mode, const Segment &segment, const Evaluation &e0, const Evaluation &mid,
              const Evaluation &e1);
  double next_after(const Mode &mode, double t) const;

  const Dynamics &dynamics_;
  Response *response_;
  std::vector<std::vector<double> *> columns_;
  double output_step_, contact_step_;
  double next_sample_ = 0, last_sample_;
  EnergyLedger before_;
  double initial_potential_ = 0, landing_loss_ = 0, largest_input_ = 0;
  Evaluation last_; ///< at the latest watched instant
  State final_;
  Mode final_mode_; ///< its support only
  double final_time_ = 0;
  BuildingRecorder building_;
  bool in_impact_ = false;
  bool turned_ = false; ///< the latest segment ended at rest on the pressed rim
  std::vector<Impact> impacts_;
  double peak_displacement_ = 0, peak_height_ = -1e300, peak_lateral_ = 0, smallest_normal_ = 1e300;
  double smallest_gap_ = 1e300;
};

} // namespace rimpact::reduced
