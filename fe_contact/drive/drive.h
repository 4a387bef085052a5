/// What every drive of a run does at each step of the loop, whatever it drives: hear of interrupts, count, keep
/// checkpoints.
#pragma once
#include "fe_contact/drive/run_record.h"
#include "fe_contact/drive/state_visitor.h"
#include "fe_contact/drive/stepper.h"
#include <optional>
#include <string>

namespace rimpact::fe {

/// Between two checkpoints; of a flight, in contact.
constexpr int usual_steps_a_checkpoint = 25;

class Drive : public Stepper {
protected:
  Drive(const RunOptions &options, RunRecord &record, int steps_a_checkpoint = usual_steps_a_checkpoint)
      : options_(options), record_(record), steps_a_checkpoint_(steps_a_checkpoint) {}

  /// The fields of the checkpoint besides the record.
  virtual void visit(StateVisitor &v) = 0;
  /// Of a step that is taken: the ledger, the impact, the response.
  virtual void follow(const SolvedStep &step) = 0;
  /// Forgets what the checkpoint does not hold.
  virtual void start_afresh() { system().start_afresh_at(state()); }
  /// Writes the checkpoint. The run goes on from it as one does that reads it, to the last bit.
  void save();
  void restore(const Checkpoint &file); ///< throws DataError
  /// Where there is a sentence: the checkpoint is written and SolverStopped thrown.
  void stop_for(const std::optional<std::string> &sentence);
  /// The stretch's cuts are the record's.
  MarchReport stretch_to(double start, double end, const StepLimits &limits);

  const RunOptions &options_;
  RunRecord &record_;
  double next_step_ = 0;     ///< length that the next step is to have; 0: the stretch's first
  long steps_at_saving_ = 0; ///< made when the last checkpoint was written

private:
  void prepare(double t, double dt) final; ///< throws Interrupted, the checkpoint written
  void accept(const SolvedStep &step) final;
  void keep(double next) final;

  const int steps_a_checkpoint_;
};

} // namespace rimpact::fe
