/// What a study will take, from a few of its runs.
#pragma once
#include "studies/risk/campaign.h"
#include <nlohmann/json.hpp>

namespace rimpact::risk {

struct StudyPlan {
  std::size_t n_systems = 0, n_motions = 0, n_listed = 0, samples = 1, runs = 0;
  std::size_t n_probed = 0; ///< runs made to time them
  double seconds_a_run = 0; ///< of one core
  double core_hours = 0;
  double memory_bytes = 0;           ///< of a process on `threads` threads
  double table_bytes = 0;            ///< of all systems' tables, CSV and HDF5
  std::size_t shards_of_an_hour = 1; ///< of two cores each
};

/// Runs `probes` of the study's runs, spread over systems, levels and samples, and keeps nothing. Throws what the runs
/// throw where none of them can be made.
StudyPlan plan_study(const Study &study, const Systems &systems, const Motions &motions, int probes = 6);
std::string describe(const StudyPlan &plan);
nlohmann::ordered_json to_json(const StudyPlan &plan);

} // namespace rimpact::risk
