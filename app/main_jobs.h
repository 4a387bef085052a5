/// The finite-element runs of the main job.
#pragma once
#include "scene/scene.h"

namespace rimpact::app {

struct Job {
  std::string name, role; ///< role: fit | predict | window | geometry | study
  scene::Scene scene;
  std::string folder; ///< DIR/runs/NAME
  bool done = false, reused = false;
  std::string failure; ///< the run's own sentence
};

/// Both Ricker pulses at scale 1.0 (predicted), 1.05 and 1.10 (fitted), windows over speed, longest first.
std::vector<Job> main_jobs(const scene::Bearing &bearing, const std::string &folder);

} // namespace rimpact::app
