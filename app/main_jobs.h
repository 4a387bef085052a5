/// The finite-element runs of the main job: what they are, and running them side by side.
#pragma once
#include "app/console.h"
#include "scene/scene.h"

namespace rimpact::app {

struct Job {
  std::string name, role; ///< role: fit | predict | window | push
  scene::Scene scene;
  std::string folder; ///< DIR/runs/NAME
  bool done = false, reused = false;
  std::string failure; ///< the run's own sentence
};

/// Both Ricker pulses at scale 1.0 (predicted), 1.05 and 1.10 (fitted), windows over speed, longest first.
std::vector<Job> main_jobs(const scene::Bearing &bearing, const std::string &folder);
/// Runs them as processes, as many at a time as there are cores (one thread each); those already done with
/// the same scene are kept. A failing run does not lose the others. Throws Interrupted after stopping the
/// children.
void run_jobs(std::vector<Job> &jobs, Console &console);

} // namespace rimpact::app
