/// The results of a study as tables in long form, and their summary.
#pragma once
#include "io/files/gathered_table.h"
#include "studies/risk/campaign.h"
#include <nlohmann/json.hpp>

namespace rimpact::risk {

/// Tables by their file's name without ending. Every row of a system's begins with `system` (from 1) and its keys.
///   ida          quantity, level_g: counts of records and runs, counted and fitted fractiles, mean_ln, sigma_ln, hits
///                and their probability by the fit over all levels
///   fragility    quantity, limit, level_g: probability with its band, share counted and its interval, the lognormal's,
///   and
///                which of the two the probability is (source)
///   reliability  quantity, limit: rate and probability in the study's years with bands, parts of the rate from beyond
///                the levels, probability if all above the last level failed; the range of what is open between and
///                beyond the levels (rate_range.h), and whether it is within a tenth of the rate (settled); the rate as
///                the thesis reads it (flat), the curve across levels and the probability of levels as far from it
///   difference   key, value, quantity, limit: reduction of the probability against the reference system with its band
///   levels       quantity, limit, level_g: share of the rate
///   records      quantity, limit, record: share of the rate, those of 0.5 % and more; "" is the fits' tails
///   sensitivity  quantity, limit, key: elasticity of the rate
///   hits         level_g: hits on the rim, and the shares of them beyond what the models are known for; empty: not
///   known motions      level_g, record, file, scale and what it is over the level
struct Results {
  std::map<std::string, Table> tables;
  GatheredTable runs; ///< of all systems, `system` and the systems' keys in front
  nlohmann::ordered_json summary;
};

/// Reads every system's table in FOLDER and evaluates it. `done` is told the number of systems done. Throws as collect.
Results evaluate_study(const Study &study, const Systems &systems, const Motions &motions, const std::string &folder,
                       const std::function<void(std::size_t)> &done);
/// FOLDER/NAME.csv and .h5 of every table, FOLDER/runs.h5 over systems/*/table.h5, FOLDER/reliability.json. Throws
/// IoError.
void write_results(const Results &results, const std::string &folder);

/// For each difference and system the system it is compared with; systems that have the reference are left out.
struct Comparison {
  std::size_t difference, system, reference;
};

} // namespace rimpact::risk
