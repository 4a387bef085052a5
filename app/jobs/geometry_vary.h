/// `rimpact geometry --vary`: rim curves over a dimension, the answer to the question, and a solid run that proves it.
#pragma once
#include "app/jobs/time_to_go.h"
#include "app/jobs/vary_question.h"
#include "calibration/studies/liner_answer.h"

namespace rimpact::app {

struct VaryOptions {
  VaryWords words;
  std::string where, folder, shard; ///< bearing, scene or case; results; I/N
  std::size_t jobs = 0;             ///< side by side; 0: as many as there are cores
  bool dry_run = false, no_proof = false;
  double crush_share = calibration::usual_crush_share; ///< of a liner (calibration/studies/liner.h)
};
void run_vary(const VaryOptions &options, Console &console);

} // namespace rimpact::app
