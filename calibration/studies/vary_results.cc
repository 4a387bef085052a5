#include "calibration/studies/vary_results.h"

#include "io/files/json_text.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

/// In percent of the limit; NaN where either is not known.
double utilisation(const VaryPoint &point, const VaryQuestion &question) {
  return question.strain_limit && point.strain ? *point.strain / *question.strain_limit : std::nan("");
}

/// NaN stands for what is not known.
nlohmann::json number_or_null(double value) {
  return std::isnan(value) ? nlohmann::json() : nlohmann::json(value);
}

std::string cell(double value, const char *pattern) {
  return std::isnan(value) ? "" : fmt::format(fmt::runtime(pattern), value);
}

/// In the units of a row's columns; rebound is the speed of rebound times the root of the mass.
nlohmann::json to_json(const SeverityTable &table) {
  const auto scaled = [](std::vector<double> values, double factor) {
    for (double &value : values) value *= factor;
    return values;
  };
  return {{"severity_m_per_s_sqrt_kg", table.severity},
          {"peak_kN", scaled(table.peak_force, 1e-3)},
          {"depth_mm", scaled(table.depth, 1e3)},
          {"rebound_m_per_s_sqrt_kg", table.rebound},
          {"strain", table.strain},
          {"rim_foot_use", table.foot_use}};
}

std::string speed_at_limit(const VaryPoint &point) {
  return point.speed_at_limit ? fmt::format("{:.3f}", *point.speed_at_limit) : fmt::format("> {:.3f}", point.fastest);
}

} // namespace

nlohmann::json to_json(const std::vector<VaryPoint> &points, const VaryQuestion &question) {
  auto rows = nlohmann::json::array(), keys = nlohmann::json::array();
  for (const auto &key : question.keys) keys.push_back({{"key", key.key}, {"values", key.values}});
  for (const auto &point : points) {
    nlohmann::json row{{"name", point.name}, {"at", point.at}};
    for (std::size_t k = 0; k < vary_outputs().size(); ++k) row[vary_outputs()[k]] = number_or_null(point.output(k));
    row["restitution"] = point.rebound / question.speed;
    row["utilisation"] = number_or_null(utilisation(point, question));
    row["speed_at_strain_limit_m_per_s"] = or_null(point.speed_at_limit);
    row["rim_foot_goes_at_m_per_s"] = or_null(point.foot_goes_at);
    row["pushed_for_m_per_s"] = point.fastest;
    row["over_severity"] = to_json(point.table);
    rows.push_back(row);
  }
  return {{"vary", keys},
          {"speed_m_per_s", question.speed},
          {"mass_kg", question.mass},
          {"strain_limit", or_null(question.strain_limit)},
          {"targets", question.targets},
          {"curve_error", {{"force", CurveAgainstWindows{}.force}, {"restitution", CurveAgainstWindows{}.restitution}}},
          {"points", rows}};
}

nlohmann::json between_json(const std::vector<VaryPoint> &points) {
  if (points.empty()) return nullptr;
  nlohmann::json columns;
  for (const auto &point : points) {
    columns["at"].push_back(point.at[0]);
    for (std::size_t k = 0; k < vary_outputs().size(); ++k)
      columns[vary_outputs()[k]].push_back(number_or_null(point.output(k)));
  }
  return columns;
}

std::string to_csv(const std::vector<VaryPoint> &points, const VaryQuestion &question) {
  std::string text = "name";
  for (const auto &key : question.keys) text += "," + key.key;
  for (const auto &name : vary_outputs()) text += "," + name;
  text += ",restitution,utilisation,speed_at_strain_limit_m_per_s,rim_foot_goes_at_m_per_s,pushed_for_m_per_s,speed_m_"
          "per_s,mass_kg,vertical_kN";
  for (const auto &point : points) {
    text += "\n" + point.name;
    for (const double value : point.at) text += fmt::format(",{:.8g}", value);
    for (std::size_t k = 0; k < vary_outputs().size(); ++k) text += fmt::format(",{}", cell(point.output(k), "{:.8g}"));
    text += fmt::format(",{:.8g},{},{},{},{:.8g},{:g},{:.8g},{:.8g}", point.rebound / question.speed,
                        cell(utilisation(point, question), "{:.8g}"),
                        cell(point.speed_at_limit.value_or(std::nan("")), "{:.8g}"),
                        cell(point.foot_goes_at.value_or(std::nan("")), "{:.8g}"), point.fastest, question.speed,
                        question.mass, question.weight / 1e3);
  }
  return text + "\n";
}

std::string describe(const std::vector<VaryPoint> &points, const VaryQuestion &question) {
  std::string text;
  for (const auto &key : question.keys) text += fmt::format("{:>22} ", key.key);
  text += fmt::format("{:>10} {:>9} {:>12} {:>8} {:>12} {:>16}\n", "peak kN", "depth mm", "rebound m/s", "strain",
                      "of its limit", "at limit m/s");
  const bool joint = !points.empty() && points.front().foot_use.has_value();
  if (joint) text.insert(text.size() - 1, fmt::format("{:>10} {:>14}", "foot use", "foot goes m/s"));
  for (const auto &point : points) {
    for (const double value : point.at) text += fmt::format("{:>22.5g} ", value);
    const double used = utilisation(point, question);
    text += fmt::format("{:>10.0f} {:>9.2f} {:>12.3f} {:>8} {:>12} {:>16}\n", point.output(0), point.output(1),
                        point.rebound, point.strain ? fmt::format("{:.3f}", *point.strain) : "-",
                        std::isnan(used) ? "-" : fmt::format("{:.0f} %", 100 * used),
                        point.strain && question.strain_limit ? speed_at_limit(point) : "-");
    if (joint && point.foot_use)
      text.insert(text.size() - 1, fmt::format("{:>10.2f} {:>14}", *point.foot_use,
                                               point.foot_goes_at ? fmt::format("{:.3f}", *point.foot_goes_at)
                                                                  : fmt::format("> {:.3f}", point.fastest)));
  }
  return text;
}

} // namespace rimpact::calibration
