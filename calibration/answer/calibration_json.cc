#include "calibration/answer/calibration_json.h"
#include "calibration/answer/answer.h"
#include "calibration/answer/answer_json.h"
#include "calibration/answer/answer_text.h"
#include "calibration/answer/calibration_text.h"
#include "calibration/answer/laws_json.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/simulate.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include "scene/toml_writer.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::calibration {

using nlohmann::json;

namespace {

json derived_json(const scene::Scene &scene) {
  const auto &r = scene.reduced;
  const bool dashpot = r.impact_law->reads("e");
  return {
      {"c_i",
       {{"value", dashpot ? json(damping_coefficient(scene) / 1e3) : json(nullptr)},
        {"unit", "kN s/m"},
        {"formula", "2 xi sqrt(k_i m1), (2-20), m2 infinite"}}},
      {"xi", dashpot ? json(laws::damping_ratio(r.restitution)) : json(nullptr)},
      {"masses", {{"m1_kg", scene.load.mass}, {"m2_kg", nullptr}, {"note", "m1: supported mass; m2: the rim, fixed"}}},
      {"law", r.impact_law->name},
      {"element", element_json(scene)},
      {"friction", word(r.friction)},
      {"elastic_slip_mm", r.friction == scene::Friction::park_wen ? json(1e3 * r.elastic_slip) : json(nullptr)},
      {"normal_force", word(r.normal_force)},
      {"mu_fast", r.mu_fast},
      {"vertical_kN", scene.load.vertical / 1e3},
      {"gravity_m_per_s2", scene.load.gravity},
      {"model", word(r.model)},
      {"bearing", scene.bearing.name}};
}

json checks_json(const std::map<std::string, RunCheck> &checks) {
  json all = json::object();
  for (const auto &[folder, check] : checks) {
    json entry = to_json(check.history);
    entry["published_values"] = check.published ? to_json(*check.published) : json(nullptr);
    entry["impacts"] = json::array();
    for (const auto &i : check.impacts)
      entry["impacts"].push_back({{"touch_time_s", i.touch_time},
                                  {"approach_speed_m_s", i.approach_speed},
                                  {"peak_force_error", number(i.peak_force_error)},
                                  {"rebound_error_over_approach", number(i.rebound_error)},
                                  {"normalised_force", number(i.normalised_force)},
                                  {"fitted", i.fitted},
                                  {"grazing", i.grazing},
                                  {"dented", i.dented}});
    for (const auto &note : check.notes) entry["notes"].push_back(note);
    all[folder] = entry;
  }
  return all;
}

json windows_json(const WindowsTable &table) {
  json rows = json::array();
  for (const auto &row : table.rows)
    rows.push_back({{"folder", row.folder},
                    {"speed_m_s", row.speed},
                    {"peak_force_N", row.peak_force},
                    {"contact_time_s", row.contact_time},
                    {"peak_penetration_m", row.peak_penetration},
                    {"rebound_speed_m_s", row.rebound_speed},
                    {"restitution", row.restitution},
                    {"normalised_force", number(row.normalised_force)},
                    {"parameters", parameters_json(row.own)},
                    {"k_from_peak_kN_per_m", row.k_from_peak ? number(*row.k_from_peak / 1e3) : json(nullptr)},
                    {"k_from_contact_time_kN_per_m",
                     row.k_from_contact_time ? number(*row.k_from_contact_time / 1e3) : json(nullptr)},
                    {"pair_force_error", number(row.pair_force_error)},
                    {"pair_rebound_error", number(row.pair_rebound_error)},
                    {"pair_holds", row.pair_holds}});
  return {{"rows", rows},
          {"tolerance", table.tolerance},
          {"valid_from_m_s", number(table.valid_from)},
          {"valid_to_m_s", number(table.valid_to)},
          {"sentence", table.sentence}};
}

json grazing_json(const std::vector<GrazingReport> &reports) {
  const auto band = [](const Band &b) { return json{{"nominal", b.nominal}, {"low", b.low}, {"high", b.high}}; };
  json all = json::array();
  for (const auto &r : reports)
    all.push_back({{"scene", r.scene},
                   {"scale", r.scale},
                   {"critical_scale", number(r.critical_scale)},
                   {"critical_amplitude_g", number(r.critical_amplitude_g)},
                   {"approach_speed_m_s", band(r.approach_speed)},
                   {"peak_impact_force_N", band(r.peak_force)},
                   {"varied", r.varied}});
  return all;
}

/// Bearing, load and [reduced] of the fitted runs, without their motion: what `export` needs of them, wherever the
/// folder and the runs have gone.
scene::Scene exported_scene(const Calibration &c) {
  scene::Scene scene = c.scene;
  scene.name = "calibrated";
  scene.excitation = {}, scene.model = {};
  if (scene.reduced.impact_law->pushed) scene.reduced.impact_law = scene::ReducedSettings{}.impact_law;
  return scene;
}

} // namespace

json to_json(const Calibration &c) {
  json out;
  out["parameters"] = parameters_json(c.result);
  out["correlation"] = c.result.correlation;
  out["condition"] = number(c.result.condition);
  out["derived"] = derived_json(c.scene);
  out["fit"] = checks_json(c.fit);
  out["prediction"] = checks_json(c.prediction);
  out["published"] = json(nullptr); // the thesis's, for its own bearing and mass
  if (scene::published_pair_applies(c.scene))
    out["published"] = {{"k_i", {{"value", published_k_i / 1e3}, {"unit", "kN/m"}}},
                        {"e", {{"value", published_e}, {"unit", "-"}}},
                        {"source", "thesis 2.5.3, for shfps-225"}};
  out["answer"] = to_json(*c.answer);
  out["fitted_on"] = word(c.fitted_on);
  out["windows"] = c.windows ? windows_json(*c.windows) : json(nullptr);
  out["laws"] = laws_json(c.laws);
  out["constant_pair"] = c.pair_range ? pair_range_json(*c.pair_range) : json(nullptr);
  out["speed_laws"] = speed_laws_json(c.speed_laws);
  out["profiles"] = profiles_json(c.profiles);
  out["critical_amplitudes"] = grazing_json(c.grazing);
  out["converged"] = c.result.converged;
  out["search"] = {{"message", c.result.message},          {"cost", number(c.result.cost)},
                   {"impacts", c.result.n_impacts},        {"residuals", c.result.n_residuals},
                   {"starts", c.result.n_starts},          {"starts_agreeing", c.result.n_starts_agreeing},
                   {"evaluations", c.result.n_evaluations}};
  out["notes"] = c.notes;
  return out;
}

void write_calibration(const Calibration &calibration, const std::string &folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw IoError(fmt::format("{}: {}", folder, failure.message()));
  const auto path = std::filesystem::path(folder);
  write_atomically(json_text(to_json(calibration)), (path / "calibration.json").string());
  write_atomically(to_toml_fragment(*calibration.answer), (path / "calibration.toml").string());
  write_atomically(scene::to_toml(exported_scene(calibration)), (path / "fitted-scene.toml").string());
  write_curves(calibration.curves, folder);
}

} // namespace rimpact::calibration
