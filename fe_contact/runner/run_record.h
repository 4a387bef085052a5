/// What a finite-element run gathers on its way, whatever its rung.
#pragma once
#include "fe_contact/runner/run.h"
#include "scene/response.h"
#include <map>

namespace rimpact::fe {

/// What a run accumulates, whatever drives it.
struct RunRecord {
  scene::Response response;
  scene::EnergyLedger ledger;
  std::vector<scene::Impact> impacts;
  long n_steps = 0, n_newton = 0, n_cuts = 0, augmentation_caps = 0;
  double smallest_normal = 0;
  long n_dofs = 0;
  std::map<std::string, double> time_split; ///< [s]
  std::vector<std::pair<double, std::string>> fields; ///< (time, VTU file) for the PVD
  std::vector<std::string> warnings;
};

/// Runs, and keeps where the time went whatever ends it: `times()` gives the split.
template <class Run, class Times> void run_timed(RunRecord &record, const Run &run, const Times &times) {
  try {
    run();
  } catch (...) {
    record.time_split = times();
    throw;
  }
  record.time_split = times();
}

/// On any rank.
bool is_interrupted(const RunOptions &options);

void write_pvd(const RunOptions &options, const RunRecord &record);

} // namespace rimpact::fe
