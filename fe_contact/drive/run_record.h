/// What a finite-element run gathers on its way, whatever its rung.
#pragma once
#include "fe_contact/drive/run.h"
#include "fe_contact/solver/solver_work.h"
#include "responses/response.h"
#include "responses/steel_report.h"
#include "responses/summary.h"
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>

namespace rimpact::fe {

/// What a run accumulates, whatever drives it.
struct RunRecord {
  Response response;
  EnergyLedger ledger;
  std::vector<Impact> impacts;
  long n_steps = 0, n_cuts = 0, augmentation_caps = 0;
  long n_dofs = 0;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double earlier_wall = 0;                              ///< of the processes before a restart [s]
  double processor_at_start = processor_seconds();      ///< of this rank [s]
  double earlier_processor = 0;                         ///< this rank's share of the processes before a restart [s]
  std::map<std::string, double> time_split;             ///< [s] of those and, once it ended, of this one
  std::function<std::map<std::string, double>()> times; ///< [s] time split of this one while it runs
  SolverWork earlier_work;          ///< of the processes before a restart and, once it ended, of this one
  std::function<SolverWork()> work; ///< of this one while it runs
  SolverWork rows_work;             ///< what the rows stored so far have taken
  std::vector<std::pair<double, std::string>> fields; ///< (time, VTU file) for the PVD
  SteelReport steel;                                  ///< when the run ended, however it did
  std::vector<std::string> warnings;
  nlohmann::json identity; ///< what the run is of: to_json of its identity when it began
  bool ended = false;      ///< it has come to its end: nothing is left to resume

  double wall_so_far() const { ///< [s]
    return earlier_wall + std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  double processor_so_far() const { ///< of this rank [s]
    return earlier_processor + processor_seconds() - processor_at_start;
  }
  std::map<std::string, double> split_so_far() const { ///< [s]
    auto result = time_split;
    if (times)
      for (const auto &[name, seconds] : times()) result[name] += seconds;
    return result;
  }
  SolverWork work_so_far() const {
    SolverWork result = earlier_work;
    if (work) result += work();
    return result;
  }
};

/// Runs, and keeps where the time went, what was solved and how the steel is, whatever ends it: `times()`, `work()` and
/// `steel()` give them.
template <class Run, class Times, class Work, class Steel>
void run_counted(RunRecord &record, const Run &run, const Times &times, const Work &work, const Steel &steel) {
  const auto keep = [&] {
    record.steel = steel();
    record.time_split = record.split_so_far();
    record.earlier_work = record.work_so_far();
    record.times = nullptr;
    record.work = nullptr;
  };
  record.times = times;
  record.work = work;
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

} // namespace rimpact::fe
