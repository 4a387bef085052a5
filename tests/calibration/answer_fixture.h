/// A calibration.json as `rimpact calibrate` writes it, in what exports read: the elastoplastic law of the reference
/// curves.
#pragma once
#include "scene/rim_identity.h"
#include "scene/stored_calibration.h"

namespace rimpact::calibration::testing {

inline nlohmann::json elastoplastic_element() {
  const auto of = [](double value, const char *unit) { return nlohmann::json{{"value", value}, {"unit", unit}}; };
  return {{"lateral_capacity_m", 0.4},         {"reference_speed_m_per_s", 0.5},
          {"k_i", of(1085500, "kN/m")},        {"yield_force", of(455.24, "kN")},
          {"hardening", of(0.38454, "-")},     {"hardening_exponent", of(0.39266, "-")},
          {"unloading_gain", of(0.2928, "-")}, {"unloading_exponent", of(0.54265, "-")}};
}

inline nlohmann::json answer_fixture() {
  const nlohmann::json k_i = {{"value", 1085500},      {"unit", "kN/m"},
                              {"standard_error", 1e4}, {"interval_95", {1065000, 1105000}},
                              {"identifiable", true},  {"verdict", "determined"}};
  nlohmann::json law = {{"name", "elastoplastic"},
                        {"chosen_by", "ranking"},
                        {"remark", nullptr},
                        {"belongs_to", "rim"},
                        {"parameters", {{"k_i", k_i}}},
                        {"element", elastoplastic_element()},
                        {"fitted_from_m_s", 0.1},
                        {"fitted_to_m_s", 0.7},
                        {"valid_from_m_s", 0.1},
                        {"valid_to_m_s", 0.7},
                        {"tolerance", 0.05},
                        {"worst_left_out", {{"peak_force", 0.021}, {"rebound", 0.043}, {"inside_valid_range", true}}},
                        {"force_unexplained", 0.05},
                        {"n_runs", 6},
                        {"sentence", "The law holds."}};
  nlohmann::json answer = {
      {"bearing", "shfps-225"},
      {"rim_identity", scene::rim_identity(scene::Bearing{})},
      {"rung", "rigid-dish"},
      {"mesh", 1},
      {"mass_kg", 86952.0},
      {"vertical_kN", 853.0},
      {"gravity_m_per_s2", 9.81},
      {"source", "finite elements"},
      {"law", law},
      {"table", nlohmann::json::array()},
      {"pair_law", "no-tension"},
      {"pair", nullptr},
      {"no_pair", "No constant pair meets three neighbouring speeds."},
      {"published_applies", false},
      {"strain",
       {{"limit", 0.2},
        {"largest", 0.475},
        {"exceeded", true},
        {"sentence", "The steel strains by 0.475, above the limit of 0.20."}}},
      {"mesh_error", {{"peak_force", 0.015}, {"sentence", "Peak forces are within 1.5 % of the finest mesh."}}},
      {"assumptions", {{{"key", "rim.height_mm"}, {"value", "60"}}}},
      {"doubts", {"Run w-0.70 leaves 0.48 % of its energy unaccounted for."}},
      {"validity", "Holds for this rim from 0.1 to 0.7 m/s."}};
  const auto fitted = [](double value, const char *unit) {
    return nlohmann::json{{"value", value}, {"unit", unit}, {"identifiable", true}};
  };
  nlohmann::json row = {{"law", "no-tension"},
                        {"parameters", {{"k_i", fitted(450000, "kN/m")}, {"e", fitted(0.35, "-")}}},
                        {"valid_from_m_s", nullptr},
                        {"valid_to_m_s", nullptr},
                        {"left_out_peak_force_error", 0.45},
                        {"left_out_rebound_error", 0.6},
                        {"sentence", "no-tension holds nowhere."}};
  return {{"answer", answer}, {"laws", {{"tolerance", 0.05}, {"rows", {row}}}}, {"fit", nlohmann::json::object()}};
}

inline scene::StoredCalibration stored(const nlohmann::json &calibration) {
  return scene::read_calibration(calibration, "calibration.json");
}

} // namespace rimpact::calibration::testing
