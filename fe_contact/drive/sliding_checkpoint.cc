// What rung rigid-dish's dynamic run must remember to go on where it stopped.
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/sliding_run.h"
#include "fe_contact/drive/system_checkpoint.h"

namespace rimpact::fe {

void SlidingRun::save() const {
  if (!options_.keeps_files()) return;
  Checkpoint file;
  put(file, record_);
  put(file, state_);
  const auto &e = report_.ledger;
  file.numbers["stack"] = {t_,
                           next_step_,
                           double(near_rim_),
                           double(touched_),
                           double(peak_written_),
                           rest_height_,
                           rest_elastic_,
                           external_before_,
                           height_before_,
                           held_.energies.elastic,
                           held_.energies.plastic,
                           rest_plastic_};
  file.numbers["model_ledger"] = {e.initial,  e.external, e.kinetic,    e.elastic, e.plastic,
                                  e.friction, e.contact,  e.integrator, e.largest};
  if (held_.displacement.size()) file.numbers["held_rim"] = list(held_.displacement);
  file.numbers["impact"] = list(impact_);
  file.numbers["sectors"] = plan_.sectors;
  write_checkpoint(file, checkpoint_of(options_));
}

void SlidingRun::restore(const Checkpoint &file) {
  get(file, record_);
  const auto &s = file.field("stack", 12);
  if (s[0] < 0 || s[0] > end_time() + 1e-9 || s[1] < 0 || !flag.contains(s[2]) || !flag.contains(s[3]) ||
      !flag.contains(s[4]))
    file.damaged("field stack holds a number it cannot");
  t_ = s[0], next_step_ = s[1], near_rim_ = s[2] != 0, touched_ = s[3] != 0, peak_written_ = s[4] != 0;
  rest_height_ = s[5], rest_elastic_ = s[6], external_before_ = s[7], height_before_ = s[8];
  held_.energies = {s[9], s[10]};
  rest_plastic_ = s[11];
  const auto &e = file.field("model_ledger", 9);
  report_.ledger = {e[0], e[1], e[2], e[3], e[4], e[5], e[6], e[7], e[8]};
  impact_ = impact_from(file, "impact");
  state_ = active().at_rest();
  get(file, state_);
  if (file.has("held_rim")) held_.displacement = vector(file.field("held_rim", active().expand(state_).size()));
  active().start_afresh_at(state_);
  steps_kept_ = record_.n_steps;
}

} // namespace rimpact::fe
