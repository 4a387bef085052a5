#include "app/comparison.h"

#include "app/job_runner.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

using nlohmann::json;

json peak_force_kN(const json &summary) {
  const auto found = summary.find("peak_impact_force_N");
  return found != summary.end() && found->is_number() ? json(1e-3 * found->get<double>()) : json();
}

/// A value of the impact with the largest force; null without impacts.
json of_hardest_impact(const json &summary, const char *key) {
  double largest = -1;
  json value;
  for (const auto &impact : summary.value("impacts", json::array()))
    if (impact["peak_force_N"].get<double>() > largest) {
      largest = impact["peak_force_N"];
      value = impact[key];
    }
  return value;
}

/// candidate / reference - 1; null where either is missing or the reference is zero.
json relative(const json &candidate, const json &reference) {
  if (!candidate.is_number() || !reference.is_number() || reference.get<double>() == 0) return {};
  return candidate.get<double>() / reference.get<double>() - 1;
}

std::string cell(const json &value, const char *pattern) {
  return value.is_number() ? fmt::format(fmt::runtime(pattern), value.get<double>()) : "-";
}

std::string percent(const json &value) {
  if (!value.is_number()) return "-";
  const double tenths = std::round(1e3 * value.get<double>());
  return fmt::format("{:+.1f} %", tenths == 0 ? 0.0 : 0.1 * tenths); // never "-0.0 %"
}

} // namespace

json comparison_rows(const std::vector<Job> &jobs, const std::string &folder) {
  json rows = json::array();
  for (const auto &job : jobs) {
    if (!job.done) continue;
    const json fe = summary_of(job.folder), fitted = summary_of(folder + "/reduced/" + job.name),
               published = summary_of(folder + "/published/" + job.name);
    const json rebound = of_hardest_impact(fe, "restitution");
    rows.push_back({{"name", job.name},
                    {"role", job.role},
                    {"fe_kN", peak_force_kN(fe)},
                    {"fitted_kN", peak_force_kN(fitted)},
                    {"published_kN", peak_force_kN(published)},
                    {"approach_speed_m_s", of_hardest_impact(fe, "approach_speed_m_s")},
                    {"rebound_over_approach", rebound},
                    {"fitted_error", relative(peak_force_kN(fitted), peak_force_kN(fe))},
                    {"published_error", relative(peak_force_kN(published), peak_force_kN(fe))},
                    {"fitted_rebound_error", relative(of_hardest_impact(fitted, "restitution"), rebound)}});
  }
  return rows;
}

std::string comparison_text(const json &rows) {
  std::string text = fmt::format("{:26s} {:>12s} {:>9s} {:>9s}   {:>11s} {:>9s} {:>9s}   {:>11s} {:>9s}\n",
                                 "peak impact force", "FE [kN]", "in [m/s]", "out/in", "fitted [kN]", "error",
                                 "rebound", "4.5e5, 0.65", "error");
  for (const auto &row : rows)
    text += fmt::format("{:26s} {:>12s} {:>9s} {:>9s}   {:>11s} {:>9s} {:>9s}   {:>11s} {:>9s}\n",
                        row["name"].get<std::string>(), cell(row["fe_kN"], "{:.1f}"),
                        cell(row["approach_speed_m_s"], "{:.3f}"),
                        cell(row["rebound_over_approach"], "{:.3f}"), cell(row["fitted_kN"], "{:.1f}"),
                        percent(row["fitted_error"]), percent(row["fitted_rebound_error"]),
                        cell(row["published_kN"], "{:.1f}"), percent(row["published_error"]));
  return text;
}

} // namespace rimpact::app
