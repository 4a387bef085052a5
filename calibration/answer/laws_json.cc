#include "calibration/answer/laws_json.h"
#include "laws/impact/catalogue.h"
#include <cmath>

namespace rimpact::calibration {

using nlohmann::json;

json number(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}
json number(const std::optional<double> &value) {
  return value ? number(*value) : json(nullptr);
}

json element_json(const scene::Scene &scene) {
  json element = {{"lateral_capacity_m", scene.bearing.lateral_capacity() + scene.reduced.capacity_offset}};
  const laws::ImpactLaw &law = *scene.reduced.impact_law;
  for (const auto *names : {&law.parameters, &law.exponents})
    for (const auto &name : *names) {
      const auto &p = parameter(name);
      element[name] = {{"value", p.get(scene) / p.si}, {"unit", p.unit}};
    }
  if (element.contains("exponent") || element.contains("yield_force"))
    element["reference_speed_m_per_s"] = scene.reduced.reference_speed;
  return element;
}

json parameters_json(const FitResult &result) {
  json all = json::object();
  for (const auto &[name, e] : result.parameters)
    all[name] = {{"value", number(e.value)},
                 {"unit", parameter(name).unit},
                 {"standard_error", number(e.standard_error)},
                 {"interval_95", {number(e.interval_low), number(e.interval_high)}},
                 {"identifiable", e.identifiable},
                 {"verdict", word(e.verdict)},
                 {"stated_error", number(e.stated_error)},
                 {"at_bound", e.at_bound},
                 {"reason", e.reason.empty() ? json(nullptr) : json(e.reason)}};
  return all;
}

json gain_json(const std::optional<ChannelGain> &gain) {
  if (!gain) return nullptr;
  return {{"factor", number(gain->factor)},
          {"standard_error", number(gain->standard_error)},
          {"stated_error", number(gain->stated)}};
}

namespace {

json errors_json(const std::vector<LawError> &errors) {
  json all = json::object();
  for (const auto &e : errors)
    all[e.folder] = {{"approach_speed_m_s", e.speed},
                     {"peak_force_error", number(e.peak_force)},
                     {"penetration_error", number(e.depth)},
                     {"rebound_error", number(e.rebound)},
                     {"force_unexplained", number(e.unexplained)},
                     {"nrmse_displacement", number(e.nrmse_displacement)},
                     {"grazing", e.grazing}};
  return all;
}

} // namespace

json laws_json(const LawRanking &ranking) {
  json rows = json::array();
  for (const auto &row : ranking.rows) {
    json left_out = json::array();
    for (const auto &left : row.left_out)
      left_out.push_back({{"left_out", left.what}, {"converged", left.converged}, {"runs", errors_json(left.errors)}});
    rows.push_back({{"law", row.result.law},
                    {"parameters", parameters_json(row.result)},
                    {"converged", row.result.converged},
                    {"force_unexplained", number(row.unexplained)},
                    {"largest_peak_force_error", number(row.largest_peak_error)},
                    {"largest_rebound_error", number(row.largest_rebound_error)},
                    {"left_out_peak_force_error", number(row.left_out_peak_error)},
                    {"left_out_rebound_error", number(row.left_out_rebound_error)},
                    {"valid_from_m_s", number(row.valid_from)},
                    {"valid_to_m_s", number(row.valid_to)},
                    {"sentence", row.sentence},
                    {"held", row.held.empty() ? json(nullptr) : json(row.held)},
                    {"gain", gain_json(row.result.gain)},
                    {"runs", errors_json(row.fitted)},
                    {"leave_one_out", left_out}});
  }
  return {{"tolerance", ranking.tolerance}, {"sentence", ranking.sentence}, {"rows", rows}};
}

json pair_range_json(const PairRange &range) {
  return {{"law", range.law},
          {"tolerance", range.tolerance},
          {"parameters", parameters_json(range.result)},
          {"valid_from_m_s", range.from},
          {"valid_to_m_s", range.to},
          {"fitted", errors_json(range.inside)},
          {"left_out", errors_json(range.left_out)},
          {"outside", errors_json(range.outside)},
          {"sentence", range.sentence}};
}

json speed_laws_json(const std::vector<SpeedLaw> &laws) {
  json all = json::object();
  for (const auto &law : laws)
    all[law.name] = {{"formula", "value = coefficient (v / 1 m/s)^exponent"},
                     {"coefficient", law.coefficient},
                     {"unit", law.unit},
                     {"exponent", law.exponent},
                     {"largest_error", law.largest_error},
                     {"from_m_s", law.from},
                     {"to_m_s", law.to}};
  return all;
}

json profiles_json(const std::map<std::string, Profile> &profiles) {
  json all = json::object();
  for (const auto &[name, p] : profiles) {
    json costs = json::array();
    for (const double cost : p.costs) costs.push_back(number(cost));
    all[name] = {{"unit", parameter(name).unit},
                 {"values", p.values},
                 {"cost_above_best", costs},
                 {"interval_95", {number(p.low), number(p.high)}}};
  }
  return all;
}

} // namespace rimpact::calibration
