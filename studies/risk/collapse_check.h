/// FEMA P-695's acceptance of a study's systems: [p695] of a study file.
#pragma once
#include "io/files/toml_file.h"
#include "studies/reliability/collapse_margin.h"
#include "studies/risk/evaluate.h"
#include <nlohmann/json.hpp>
#include <optional>

namespace rimpact::risk {

/// None where the file has no [p695]. Throws InputError "file:line:column: ...": a quantity that no [[limit]] has.
std::optional<CollapseStudy> read_collapse_study(const TomlFile &file, const std::vector<Limit> &limits);

/// Margin and acceptance of one system.
struct CollapseCheck {
  std::optional<double> median_g; ///< intensity at which half of the runs collapse; none: not within the levels
  double margin = 0;              ///< CMR = median over the maximum considered intensity; none: of the last level
  double shape_factor = 1;        ///< SSF
  double adjusted = 0;            ///< ACMR = SSF CMR, 1.2 times that in three dimensions
  double beta = 0;                ///< total uncertainty
  double acceptable_10 = 0, acceptable_20 = 0;
  bool is_least = false; ///< half of the runs collapse at no level: the margins are lower bounds
};

/// `limits` as evaluate() gives them. Between levels the share is straight in ln(intensity).
CollapseCheck collapse_check(const Study &study, const std::vector<LimitResult> &limits,
                             const std::vector<double> &levels_g);
/// All systems: each must have ACMR >= ACMR20, their mean >= ACMR10 (section 7.4).
nlohmann::ordered_json to_json(const std::vector<CollapseCheck> &checks);

} // namespace rimpact::risk
