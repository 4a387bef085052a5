#include "app/jobs/comparison.h"

#include "app/jobs/job_runner.h"
#include "calibration/answer/said_once.h"
#include <algorithm>
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

/// One reduced run's column: keys of a row begin with `key`.
struct ReducedColumn {
  std::string title, key, folder;
};

std::vector<ReducedColumn> present(const Columns &columns) {
  std::vector<ReducedColumn> list;
  if (!columns.law.empty()) list.push_back({columns.law, "fitted", "/law/"});
  if (!columns.pair.empty()) list.push_back({columns.pair, "pair", "/reduced/"});
  if (!columns.published.empty()) list.push_back({columns.published, "published", "/published/"});
  return list;
}

void add_column(json &row, const std::string &key, const json &fe, const json &reduced) {
  const json peak = peak_force_kN(reduced);
  row[key + "_kN"] = peak;
  row[key + "_error"] = relative(peak, peak_force_kN(fe));
  for (const auto &[of, quantity] :
       {std::pair{"_rebound_error", "rebound_speed_m_s"}, {"_restitution_error", "restitution"}})
    row[key + of] = relative(of_hardest_impact(reduced, quantity), of_hardest_impact(fe, quantity));
}

} // namespace

json comparison_rows(const std::vector<Job> &jobs, const std::string &folder, const Columns &columns) {
  json rows = json::array();
  for (const auto &job : jobs) {
    if (!job.done) continue;
    const json fe = summary_of(job.folder);
    json row{{"name", job.name},
             {"role", word(job.role)},
             {"fe_kN", peak_force_kN(fe)},
             {"approach_speed_m_s", of_hardest_impact(fe, "approach_speed_m_s")},
             {"rebound_over_approach", of_hardest_impact(fe, "restitution")},
             {"doubts", doubts_of(fe)}};
    for (const char *key : {"fitted", "pair", "published"})
      add_column(row, key, fe, json::object()); // a column that is not there is null
    for (const auto &column : present(columns))
      add_column(row, column.key, fe, summary_of(folder + column.folder + job.name));
    rows.push_back(row);
  }
  return rows;
}

std::string comparison_text(const json &rows, const Columns &columns, const std::vector<std::string> &said) {
  std::vector<std::string> unsaid;
  std::string text = fmt::format("{:28s} {:>9s} {:>9s} {:>7s}", "peak impact force", "FE [kN]", "in [m/s]", "out/in");
  for (const auto &column : present(columns))
    text += fmt::format("   {:>19s} {:>9s} {:>9s}", column.title + " [kN]", "error", "out/in");
  text += "\n";
  for (const auto &row : rows) {
    const std::string name = row["name"];
    text += fmt::format("{:28s} {:>9s} {:>9s} {:>7s}", name + (row["doubts"].empty() ? "" : " !"),
                        cell(row["fe_kN"], "{:.1f}"), cell(row["approach_speed_m_s"], "{:.3f}"),
                        cell(row["rebound_over_approach"], "{:.3f}"));
    for (const auto &column : present(columns))
      text += fmt::format("   {:>19s} {:>9s} {:>9s}", cell(row[column.key + "_kN"], "{:.1f}"),
                          percent(row[column.key + "_error"]), percent(row[column.key + "_restitution_error"]));
    text += "\n";
    for (const auto &doubt : row["doubts"])
      if (const auto sentence = name + ": " + doubt.get<std::string>();
          std::find(said.begin(), said.end(), sentence) == said.end())
        unsaid.push_back(sentence);
  }
  for (const auto &doubt : calibration::said_once(unsaid)) text += "! " + doubt + "\n";
  return text;
}

} // namespace rimpact::app
