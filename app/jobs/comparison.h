/// Peak impact force and rebound of each finite-element run beside the reduced model: with the answer's law, with the
/// constant pair where there is one, and with the published pair where it applies.
#pragma once
#include "app/jobs/main_jobs.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

/// Which reduced runs stand beside the finite elements, and what their columns are called; empty: no such column.
struct Columns {
  std::string law = {}, pair = {}, published = {};
};

/// From the summaries of DIR/runs, DIR/law (fitted_*), DIR/reduced (pair_*) and DIR/published; null where a run or
/// column is missing. `doubts` of a row: what its finite-element run warns of.
nlohmann::json comparison_rows(const std::vector<Job> &jobs, const std::string &folder, const Columns &columns);
/// A doubted row is marked with !; its doubts stand below the table, those of one kind once, but for what `said` holds.
std::string comparison_text(const nlohmann::json &rows, const Columns &columns,
                            const std::vector<std::string> &said = {});

} // namespace rimpact::app
