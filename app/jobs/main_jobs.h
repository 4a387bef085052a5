/// The finite-element runs of the main job.
#pragma once
#include "app/jobs/main_target.h"
#include "app/jobs/pulse_scales.h"

namespace rimpact::app {

/// What a run is for.
enum class JobRole { fit, predict, window, twin, geometry, study };
constexpr auto choices(JobRole) {
  using enum JobRole;
  return choices_of<JobRole>({{fit, "fit"},
                              {predict, "predict"},
                              {window, "window"},
                              {twin, "twin", "a window with the other steel: without its strain rate, or with it"},
                              {geometry, "geometry"},
                              {study, "study"}});
}

struct Job {
  std::string name;
  JobRole role;
  scene::Scene scene;
  std::string folder; ///< DIR/runs/NAME; of a twin DIR/twins/NAME
  bool begun = false, done = false, reused = false;
  bool left_out = false;    ///< the runner does not begin it
  std::string failure = {}; ///< the run's own sentence
  bool reduced = false;     ///< by the reduced model, else by finite elements
};

struct MainChoices {
  std::vector<double> speeds{1.0, 0.6, 0.35, 0.2, 0.1, 0.05}; ///< of the windows [m/s]
  bool windows_only = false;
  bool bidirectional = false;             ///< also pulse-bidirectional, to predict
  std::optional<SpeedRange> pulse_speeds; ///< that the pulses are to reach
  std::optional<bool> twins;              ///< of the steel's rate; none: for every bearing but the built-in ones
};

struct MainJobs {
  std::vector<Job> jobs;             ///< in the order in which they are begun
  std::vector<std::string> left_out; ///< pulses that cannot be run, a sentence each
};

/// The rate of the fast side of a bearing's band: its own, else mild steel's, an assumption.
scene::StrainRate fast_rate(const scene::Material &steel);
/// Windows over speed and both Ricker pulses, at the target's load and with its settings. shfps-225 as the thesis has
/// it keeps the thesis's scales, 1.0 (predicted), 1.05 and 1.10 (fitted), unless `pulse_speeds` are given; of any other
/// bearing or load they are chosen by pulse_scales(). Windows come first, the fastest and then each the farthest (of
/// the speeds' logarithms) from those before it, so that few of them span the speeds; then the pulses, the hardest
/// first; last the twins of the fastest, the middle and the slowest window, with the other steel. Throws InputError for
/// a speed out of its range or given twice.
MainJobs main_jobs(const MainTarget &target, const MainChoices &choices, const std::string &folder);

/// As they stand in tables: pulses, windows with the fastest first, twins.
void sort_for_tables(std::vector<Job> &jobs);

} // namespace rimpact::app
