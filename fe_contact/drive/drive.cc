#include "fe_contact/drive/drive.h"

#include "fe_contact/drive/record_checkpoint.h"
#include "io/files/error.h"

namespace rimpact::fe {

void Drive::save() {
  if (options_.folder.empty()) return;
  start_afresh();
  steps_at_saving_ = record_.n_steps;
  if (!options_.keeps_files()) return;
  Checkpoint file;
  StateWriter writer(file);
  fe::visit(writer, record_);
  visit(writer);
  write_checkpoint(file, checkpoint_of(options_));
}

void Drive::restore(const Checkpoint &file) {
  StateReader reader(file);
  fe::visit(reader, record_);
  visit(reader);
  start_afresh();
  steps_at_saving_ = record_.n_steps;
}

void Drive::stop_for(const std::optional<std::string> &sentence) {
  if (!sentence) return;
  save();
  throw SolverStopped(*sentence);
}

MarchReport Drive::stretch_to(double start, double end, const StepLimits &limits) {
  MarchReport report = Stepper::march_to(start, end, limits);
  record_.n_cuts += report.cuts;
  return report;
}

void Drive::prepare(double, double dt) {
  if (!is_interrupted(options_)) return;
  next_step_ = dt;
  save();
  throw Interrupted();
}

void Drive::accept(const SolvedStep &step) {
  ++record_.n_steps;
  record_.augmentation_caps += step.report.capped;
  follow(step);
}

void Drive::keep(double next) {
  if (record_.n_steps - steps_at_saving_ < steps_a_checkpoint_) return;
  next_step_ = next;
  save();
}

} // namespace rimpact::fe
