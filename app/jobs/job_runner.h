/// Runs the jobs of `main`, `geometry` and `study` as processes, side by side.
#pragma once
#include "app/console/console.h"
#include "app/console/progress.h"
#include "app/jobs/main_jobs.h"
#include "app/jobs/time_to_go.h"
#include <functional>
#include <nlohmann/json.hpp>

namespace rimpact::app {

class JobRunner {
public:
  /// `at_once`: runs side by side; 0: as many as the process may use cores, at most eight. Throws InputError when the
  /// finite-element program is missing.
  JobRunner(std::vector<Job> &jobs, Console &console, std::size_t at_once = 0);

  /// One thread each where several run at once. Each run's scene and log go to DIR/logs, DIR/runs holds run folders
  /// only. Jobs done with the same scene are kept, interrupted and killed ones go on from their checkpoint. A failing
  /// one does not lose the others; its sentence is in Job::failure. On Ctrl-C the children are told, write their
  /// checkpoints, and an Error of exit code 130 is thrown.
  /// After runs have ended `on_end` is called, if there is one: it may leave out jobs that are not begun.
  void run(const std::function<void(std::vector<Job> &)> &on_end = {});

  double expected_seconds() const { return time_to_go(times_, at_once_); } ///< of what is left

private:
  using Clock = std::chrono::steady_clock;
  struct Child {
    pid_t process;
    Job *job;
    bool picked_up = false; ///< a run that was killed: its checkpoint may be refused
    Clock::time_point begin = Clock::now();
  };
  void start_next();
  void start_anew(Job &job, const std::string &why);
  void launch(Job &job, const std::vector<std::string> &words, bool picked_up = false);
  void collect();
  void finish(Job &job, int code);
  RunTime &time_of(const Job &job) { return times_[&job - jobs_.data()]; }
  void show_progress();
  void stop_all();

  std::vector<Job> &jobs_;
  Console &console_;
  std::size_t at_once_, next_ = 0, finished_ = 0;
  bool ended_ = false; ///< a run, since on_end was called
  std::vector<Child> children_;
  std::vector<RunTime> times_; ///< by job
  ProgressLine line_;
  Clock::time_point begin_ = Clock::now();
};

/// The folders of a study's runs and of their logs; throws IoError when they cannot be made.
void make_runs_folder(const std::string &folder);

/// Throws SolverStopped naming the first job that did not end well and is not left out.
void require_done(const std::vector<Job> &jobs);

/// Versions of the libraries the finite-element program uses (`version --json`), kept in `folder`. Warns when
/// its BLAS is slow; throws IoError with its last words when it does not start.
nlohmann::json fe_versions(const std::string &folder, Console &console);

/// Whether the job's folder holds a run of this very scene that ended well.
bool is_done(const Job &job);

/// A job's summary.json; an empty object when there is none. Throws DataError where it is damaged.
nlohmann::json summary_of(const std::string &folder);

/// What a run says of itself that is to be doubted: the warnings of its summary, sentences.
std::vector<std::string> doubts_of(const nlohmann::json &summary);

} // namespace rimpact::app
