#include "calibration/export/pulse_check.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

std::string line_of(const PulseRow &row) {
  return fmt::format("{}: {} (model {})", row.name(), words_of(row.exported), words_of(row.model));
}

nlohmann::json json_of(const Arrival &arrival) {
  const auto or_null = [&](double value) { return arrival.touch_speed > 0 ? nlohmann::json(value) : nlohmann::json(); };
  return {{"touch_speed_m_s", or_null(arrival.touch_speed)},
          {"peak_force_kN", or_null(arrival.peak_force / 1e3)},
          {"largest_travel_mm", 1e3 * arrival.largest_travel}};
}

void add_row(PulseCheck &check, PulseRow row, const scene::Scene &flown, const FlownBearing &bearing) {
  const auto run = fly_model(flown);
  row.exported = fly_bearing(bearing, {flown.excitation, flown.load.gravity}, flown.excitation.duration);
  if (run && !row.exported.leaves) {
    row.model = *run;
    check.rows.push_back(row);
  } else {
    check.left_out.push_back(fmt::format("Pulse {}: the {} goes over its rim, so it is not compared.", row.name(),
                                         run ? "exported bearing" : "model"));
  }
}

} // namespace

std::string PulseRow::name() const {
  const std::string varies =
      load_varies ? fmt::format(" with {:g} g at {:g} Hz up and down", check_vertical_g, check_vertical_hz) : "";
  return fmt::format("{} x {:.4g}{}", pulse, scale, varies);
}

double PulseRow::difference(double least_force) const {
  return std::abs(exported.peak_force - model.peak_force) / std::max(model.peak_force, least_force);
}

double PulseCheck::worst() const {
  double most = 0;
  for (const auto &row : rows) most = std::max(most, row.difference(least_force));
  return most;
}

double PulseCheck::worst_judged() const {
  double most = 0;
  for (const auto &row : rows)
    if (row.model.touch_speed >= slowest || row.exported.touch_speed >= 2 * slowest)
      most = std::max(most, row.difference(least_force));
  return most;
}

std::vector<std::string> PulseCheck::lines() const {
  std::vector<std::string> all;
  if (!rows.empty())
    all.push_back(fmt::format("Self-check under pulses: {}, flown by rimpact, against the reduced model; peak force "
                              "within {:.1f} % of the model's, or of the law's at its lowest speed.",
                              written ? "the exported bearing" : "the bearing that is refused", 100 * worst()));
  for (const auto &row : rows) all.push_back("  " + line_of(row) + ".");
  all.insert(all.end(), left_out.begin(), left_out.end());
  return all;
}

std::vector<std::string> PulseCheck::doubts() const {
  std::vector<std::string> all;
  if (!written) return all;
  for (const auto &row : rows)
    if (const double off = row.difference(least_force); off > tolerance)
      all.push_back(fmt::format("DOUBT: the exported bearing differs by {:.0f} % in peak force under {}.", 100 * off,
                                line_of(row)));
  return all;
}

nlohmann::json PulseCheck::json() const {
  nlohmann::json all = nlohmann::json::array();
  for (const auto &row : rows)
    all.push_back({{"name", row.name()},
                   {"pulse", row.pulse},
                   {"scale", row.scale},
                   {"vertical_g", row.load_varies ? check_vertical_g : 0},
                   {"model", json_of(row.model)},
                   {"exported", json_of(row.exported)},
                   {"peak_force_difference", row.difference(least_force)}});
  return {{"rows", all}, {"left_out", left_out}, {"written", written}, {"peak_force_difference", worst()}};
}

PulseCheck pulse_check(const scene::Scene &scene, const ExportedRim &rim, const FlownBearing &bearing) {
  LawContact law(rim.element());
  PulseCheck check{.rows = {}, .left_out = {}, .least_force = 0, .slowest = rim.from};
  check.least_force = fly(law, rim.mass, rim.from, rim.settings.k_i).peak_force;
  const scene::Scene model = model_of(scene, rim);
  for (const char *pulse : check_pulses) {
    scene::Scene flown = under_pulse(model, pulse);
    const auto unit = unit_scale(flown);
    if (!unit) {
      check.left_out.push_back(fmt::format("Pulse {}: at no scale does it bring the model to its rim.", pulse));
      continue;
    }
    for (const double scale : check_scales) {
      flown.excitation.scale = scale * *unit;
      add_row(check, {.pulse = pulse, .scale = flown.excitation.scale, .model = {}, .exported = {}}, flown, bearing);
    }
    flown.excitation.scale = check_scales[1] * *unit;
    add_row(check, {.pulse = pulse, .scale = flown.excitation.scale, .model = {}, .exported = {}, .load_varies = true},
            with_varying_load(flown), bearing);
  }
  return check;
}

} // namespace rimpact::calibration
