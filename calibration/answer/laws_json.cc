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

scene::StoredElement stored_element(const scene::Scene &scene) {
  scene::StoredElement element{.lateral_capacity = scene.bearing.lateral_capacity() + scene.reduced.capacity_offset};
  const laws::ImpactLaw &law = *scene.reduced.impact_law;
  for (const auto *names : {&law.parameters, &law.exponents})
    for (const auto &name : *names) {
      const auto &p = parameter(name);
      element.numbers[name] = p.get(scene) / p.si;
    }
  if (element.numbers.contains("exponent") || element.numbers.contains("yield_force"))
    element.reference_speed = scene.reduced.reference_speed;
  return element;
}

scene::StoredParameters stored_parameters(const FitResult &result) {
  scene::StoredParameters all;
  for (const auto &[name, e] : result.parameters)
    all[name] = {.value = e.value,
                 .unit = parameter(name).unit,
                 .standard_error = e.standard_error,
                 .stated_error = e.stated_error,
                 .interval_95 = {e.interval_low, e.interval_high},
                 .identifiable = e.identifiable,
                 .at_bound = e.at_bound,
                 .verdict = word(e.verdict),
                 .reason = e.reason};
  return all;
}

std::optional<scene::StoredGain> stored_gain(const std::optional<ChannelGain> &gain) {
  if (!gain) return {};
  return scene::StoredGain{
      .factor = gain->factor, .standard_error = gain->standard_error, .stated_error = gain->stated};
}

json parameters_json(const FitResult &result) {
  return scene::to_json(stored_parameters(result));
}

json element_json(const scene::Scene &scene) {
  return scene::to_json(stored_element(scene));
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
    json said = scene::to_json(scene::StoredRankedLaw{.law = row.result.law,
                                                      .parameters = stored_parameters(row.result),
                                                      .valid_from = row.valid_from,
                                                      .valid_to = row.valid_to,
                                                      .left_out_peak_force = row.left_out_peak_error,
                                                      .left_out_rebound = row.left_out_rebound_error,
                                                      .sentence = row.sentence});
    const auto gain = stored_gain(row.result.gain);
    said.update({{"converged", row.result.converged},
                 {"force_unexplained", number(row.unexplained)},
                 {"largest_peak_force_error", number(row.largest_peak_error)},
                 {"largest_rebound_error", number(row.largest_rebound_error)},
                 {"held", row.held.empty() ? json(nullptr) : json(row.held)},
                 {"gain", gain ? scene::to_json(*gain) : json(nullptr)},
                 {"runs", errors_json(row.fitted)},
                 {"leave_one_out", left_out}});
    rows.push_back(said);
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
