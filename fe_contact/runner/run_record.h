/// What a finite-element run gathers on its way, whatever its rung.
#pragma once
#include "fe_contact/runner/run.h"
#include "scene/response.h"
#include <chrono>
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
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::map<std::string, double> earlier;    ///< [s] time split and "wall" of the processes before a restart
  std::function<std::map<std::string, double>()> times; ///< [s] time split of this process so far; empty once it ended
  std::map<std::string, double> time_split; ///< [s] of all of them, at the end
  std::vector<std::pair<double, std::string>> fields; ///< (time, VTU file) for the PVD
  std::vector<std::string> warnings;

  /// What was spent so far, with "wall" [s].
  std::map<std::string, double> spent() const {
    auto result = times ? times() : time_split;
    result["wall"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const auto &[name, seconds] : earlier)
      if (times || name == "wall") result[name] += seconds;
    return result;
  }
};

/// Runs, and keeps where the time went whatever ends it: `times()` gives the split.
template <class Run, class Times> void run_timed(RunRecord &record, const Run &run, const Times &times) {
  const auto keep = [&] {
    record.time_split = record.spent();
    record.time_split.erase("wall");
    record.times = nullptr;
  };
  record.times = times;
  try {
    run();
  } catch (...) {
    keep();
    throw;
  }
  keep();
}

/// On any rank.
bool is_interrupted(const RunOptions &options);

void write_pvd(const RunOptions &options, const RunRecord &record);

} // namespace rimpact::fe
