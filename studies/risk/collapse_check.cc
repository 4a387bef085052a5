#include "studies/risk/collapse_check.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/files/toml_reader.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

/// The first intensity at which the fragility reaches a half; none: at no level.
std::optional<double> median_of(const LimitResult &limit, const std::vector<double> &levels_g) {
  for (std::size_t i = 0; i < levels_g.size(); ++i) {
    const double p = limit.fragility[i].value;
    if (p < 0.5) continue;
    if (i == 0) return p == 0.5 ? std::optional(levels_g[0]) : std::nullopt;
    const double before = limit.fragility[i - 1].value, share = (0.5 - before) / (p - before);
    return std::exp(std::lerp(std::log(levels_g[i - 1]), std::log(levels_g[i]), share));
  }
  return std::nullopt;
}

const LimitResult &limit_of(const Study &study, const std::vector<LimitResult> &limits) {
  return *std::find_if(limits.begin(), limits.end(), [&](const LimitResult &r) {
    return study.limits[r.quantity].quantity == study.collapse->quantity &&
           (study.collapse->limit == 0 || r.limit == study.collapse->limit);
  });
}

} // namespace

std::optional<CollapseStudy> read_collapse_study(const TomlFile &file, const std::vector<Limit> &limits) {
  if (!file.find("p695")) return std::nullopt;
  CollapseStudy study;
  TomlReader reader(file, "p695");
  reader.text({"quantity"}, study.quantity);
  reader.number({"limit"}, study.limit, si, {0, 1e12});
  reader.number({"mce_g"}, study.mce_g, si, {0, 100, true});
  reader.number({"ductility"}, study.ductility, si, {1, 1000});
  reader.choice({"category"}, study.category);
  reader.choice({"design_requirements"}, study.design);
  reader.choice({"test_data"}, study.tests);
  reader.choice({"model"}, study.model);
  reader.flag({"three_dimensional"}, study.is_three_dimensional);
  reader.finish();
  const auto fail = [&](const std::string &key, const std::string &what) {
    throw InputError(fmt::format("{}: {}", file.location(key), what));
  };
  if (study.mce_g == 0) fail("p695", "[p695] needs mce_g, the maximum considered S_a at intensity.period_s (S_MT)");
  std::vector<std::string> names;
  for (const auto &limit : limits) names.push_back(limit.quantity);
  const auto limit =
      std::find_if(limits.begin(), limits.end(), [&](const Limit &l) { return l.quantity == study.quantity; });
  if (limit == limits.end())
    fail("p695", "p695.quantity must be that of a [[limit]]: " + unknown_word(study.quantity, names));
  if (study.limit > 0 && std::find(limit->values.begin(), limit->values.end(), study.limit) == limit->values.end())
    fail("p695.limit", fmt::format("p695.limit {:g} is not among the values of its [[limit]]", study.limit));
  return study;
}

CollapseCheck collapse_check(const Study &study, const std::vector<LimitResult> &limits,
                             const std::vector<double> &levels_g) {
  const CollapseStudy &asked = *study.collapse;
  const LimitResult &limit = limit_of(study, limits);
  CollapseCheck check{.median_g = median_of(limit, levels_g)};
  const bool at_first = !check.median_g && limit.fragility.front().value >= 0.5; // below the first level: no margin
  check.is_least = !check.median_g && !at_first;
  check.margin = at_first ? 0 : check.median_g.value_or(levels_g.back()) / asked.mce_g;
  check.shape_factor = reliability::spectral_shape_factor(study.period_s, asked.ductility, asked.category);
  constexpr double three_dimensional = 1.2; // section 6.4.4
  check.adjusted = check.margin * check.shape_factor * (asked.is_three_dimensional ? three_dimensional : 1);
  check.beta = reliability::total_uncertainty(asked.ductility, asked.design, asked.tests, asked.model);
  check.acceptable_10 = reliability::acceptable_margin(check.beta, 0.10);
  check.acceptable_20 = reliability::acceptable_margin(check.beta, 0.20);
  return check;
}

nlohmann::ordered_json to_json(const std::vector<CollapseCheck> &checks) {
  auto systems = nlohmann::ordered_json::array();
  double sum = 0;
  bool all = true;
  for (const auto &c : checks) {
    sum += c.adjusted, all &= c.adjusted >= c.acceptable_20;
    systems.push_back(
        {{"median_collapse_g", c.median_g ? nlohmann::ordered_json(*c.median_g) : nlohmann::ordered_json()},
         {"collapse_margin", c.margin},
         {"spectral_shape_factor", c.shape_factor},
         {"adjusted_collapse_margin", c.adjusted},
         {"is_lower_bound", c.is_least},
         {"accepted", c.adjusted >= c.acceptable_20}});
  }
  const double mean = sum / static_cast<double>(checks.size());
  return {{"total_uncertainty", checks.front().beta},
          {"acceptable_10", checks.front().acceptable_10},
          {"acceptable_20", checks.front().acceptable_20},
          {"mean_adjusted_collapse_margin", mean},
          {"accepted_on_average", mean >= checks.front().acceptable_10},
          {"all_accepted", all},
          {"systems", systems}};
}

} // namespace rimpact::risk
