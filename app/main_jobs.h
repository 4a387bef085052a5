/// The finite-element runs of the main job.
#pragma once
#include "app/main_target.h"
#include "app/pulse_scales.h"

namespace rimpact::app {

/// What a run is for.
enum class JobRole { fit, predict, window, geometry, study };
constexpr auto choices(JobRole) {
  using enum JobRole;
  return choices_of<JobRole>(
      {{fit, "fit"}, {predict, "predict"}, {window, "window"}, {geometry, "geometry"}, {study, "study"}});
}

struct Job {
  std::string name;
  JobRole role;
  scene::Scene scene;
  std::string folder; ///< DIR/runs/NAME
  bool done = false, reused = false;
  std::string failure = {}; ///< the run's own sentence
  bool reduced = false;     ///< by the reduced model, else by finite elements
};

struct MainChoices {
  std::vector<double> speeds{1.0, 0.6, 0.35, 0.2, 0.1, 0.05}; ///< of the windows [m/s]
  bool windows_only = false;
  bool bidirectional = false;             ///< also pulse-bidirectional, to predict
  std::optional<SpeedRange> pulse_speeds; ///< wished of the pulses
};

struct MainJobs {
  std::vector<Job> jobs;             ///< pulses, then windows, longest first
  std::vector<std::string> left_out; ///< pulses that cannot be run, a sentence each
};

/// Windows over speed and both Ricker pulses, at the target's load and with its settings. shfps-225 as the thesis has
/// it keeps the thesis's scales, 1.0 (predicted), 1.05 and 1.10 (fitted), unless `pulse_speeds` are given; of any other
/// bearing or load they are chosen by pulse_scales(). Throws InputError for a speed out of its range or given twice.
MainJobs main_jobs(const MainTarget &target, const MainChoices &choices, const std::string &folder);

} // namespace rimpact::app
