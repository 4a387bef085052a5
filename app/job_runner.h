/// Runs the jobs of `main`, `geometry` and `study` as processes, side by side.
#pragma once
#include "app/console.h"
#include "app/main_jobs.h"
#include "app/progress.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

class JobRunner {
public:
  /// Throws InputError when the finite-element program is missing.
  JobRunner(std::vector<Job> &jobs, Console &console);

  /// As many at a time as there are cores, one thread each. Jobs done with the same scene are kept,
  /// interrupted ones go on from their checkpoint, a failing one does not lose the others (its sentence is in
  /// Job::failure). On Ctrl-C the children are told, write their checkpoints, and an Error of exit code 130
  /// is thrown.
  void run();

private:
  struct Child {
    pid_t process;
    Job *job;
  };
  void start_next();
  void collect();
  void finish(Job &job, int code);
  void show_progress();
  void stop_all();

  std::vector<Job> &jobs_;
  Console &console_;
  std::string program_;
  std::size_t at_once_, next_ = 0, finished_ = 0;
  std::vector<Child> children_;
  ProgressLine line_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// The folder of a study's runs; throws IoError when it cannot be made.
void make_runs_folder(const std::string &folder);

/// Every `n_parts`-th job from the `part`-th (from 1) on.
std::vector<Job> shard_of(const std::vector<Job> &jobs, int part, int n_parts);

/// Throws SolverStopped naming the first job that did not end well.
void require_done(const std::vector<Job> &jobs);

/// Versions of the libraries the finite-element program uses (`version --json`), kept in `folder`. Warns when
/// its BLAS is slow; throws IoError with its last words when it does not start.
nlohmann::json fe_versions(const std::string &folder, Console &console);

/// Whether the job's folder holds a run of this very scene that ended well.
bool is_done(const Job &job);

/// A job's summary.json; null when there is none to read.
nlohmann::json summary_of(const std::string &folder);

} // namespace rimpact::app
