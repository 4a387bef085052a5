/// Watches a run: stores samples, keeps peaks, impacts and the energy ledger. Knows nothing of integrators:
/// it is handed smooth segments with an interpolant, and the events between them.
#pragma once
#include "reduced_models/motion/step_budget.h"
#include "reduced_models/record/building_recorder.h"
#include "reduced_models/record/run_peaks.h"

namespace rimpact::reduced {

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
  double smallest_gap() const { return peaks_.smallest_gap(); }

  StepCount steps; ///< taken so far

private:
  static constexpr double beside = 1e-6; ///< samples beside a jump of a force stand this far from it [s]
  /// None sooner than `apart` after the last [s].
  void store(const Mode &mode, double t, const State &y, double apart = beside / 2);
  BuildingSnapshot building_at(const State &y) const; ///< of a state that is on the surface where the dish carries it
  void store_before(const Mode &mode, const Segment &segment);
  void refine_drifts(const Segment &segment, const State &middle);
  void watch(const Mode &mode, const State &y, const Evaluation &e);
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
  double final_time_ = 0, warmest_ = -1e300;
  BuildingRecorder building_;
  bool turned_ = false; ///< the latest segment ended at rest on the pressed rim
  RunPeaks peaks_;
};

} // namespace rimpact::reduced
