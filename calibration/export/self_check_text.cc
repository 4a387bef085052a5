// What an export says of its self-check, in its files, on screen and in JSON.
#include "calibration/export/self_check_text.h"

#include <algorithm>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

std::string first_hit(const CheckRow &row) {
  return fmt::format("  {:.3g} m/s: peak {:.1f} kN (law {:.1f}), penetration {:.3f} mm (law {:.3f}), rebound {:.3f} of "
                     "the approach (law {:.3f}), contact {:.2f} ms.",
                     row.speed, row.spring.peak_force / 1e3, row.law.peak_force / 1e3, 1e3 * row.spring.penetration,
                     1e3 * row.law.penetration, row.spring.rebound, row.law.rebound, 1e3 * row.spring.duration);
}

std::string second_hit(const SelfCheck &check, const CheckRow &row) {
  const std::string renewed =
      check.new_form.empty() ? "" : fmt::format("; {} {:.1f} kN", check.new_form, row.spring.peak_force / 1e3);
  return fmt::format("  {:.3g} m/s: {} {:.1f} kN{} (law {:.1f}), rebound {:.3f} (law {:.3f}).", row.speed,
                     check.dented_form.empty() ? "peak" : check.dented_form, row.spring_again.peak_force / 1e3, renewed,
                     row.law_again.peak_force / 1e3, row.spring_again.rebound, row.law_again.rebound);
}

/// Of the row of a second hit that is furthest off; `peak` is what the exported spring has there.
template <class Peak> std::string doubt_of_second(const SelfCheck &check, const std::string &form, Peak peak) {
  const auto off = [&](const CheckRow &row) { return std::abs(peak(row) / row.law_again.peak_force - 1); };
  const auto worst = std::max_element(check.rows.begin(), check.rows.end(),
                                      [&](const auto &a, const auto &b) { return off(a) < off(b); });
  return fmt::format(
      "DOUBT: a second hit on the same dent, {}: {:.0f} kN at {:.3g} m/s for the law's {:.0f} kN, {:+.0f} "
      "%.",
      form, peak(*worst) / 1e3, worst->speed, worst->law_again.peak_force / 1e3,
      100 * (peak(*worst) / worst->law_again.peak_force - 1));
}

nlohmann::json side(const Bounce &i) {
  return {{"peak_force_kN", i.peak_force / 1e3},
          {"penetration_mm", 1e3 * i.penetration},
          {"rebound", i.rebound},
          {"contact_time_ms", 1e3 * i.duration}};
}

} // namespace

std::string sentence_of(const SelfCheck &check) {
  return fmt::format("{}Self-check of the {}, flown by rimpact at {:.3g} to {:.3g} m/s against the law: peak force "
                     "within {:.1f} %, penetration within {:.1f} %, "
                     "rebound within {:.3f} of the approach speed.",
                     check.serves() ? "" : "DOUBT: ", check.form, check.rows.front().speed, check.rows.back().speed,
                     100 * check.peak_force, 100 * check.penetration, check.rebound);
}

std::vector<std::string> doubts_of(const SelfCheck &check) {
  std::vector<std::string> all;
  if (check.again() > check.tolerance)
    all.push_back(doubt_of_second(check, check.dented_form.empty() ? check.form : check.dented_form,
                                  [](const CheckRow &row) { return row.spring_again.peak_force; }));
  if (check.again_new() > check.tolerance)
    all.push_back(doubt_of_second(check, check.new_form, [](const CheckRow &row) { return row.spring.peak_force; }));
  if (check.pulses)
    for (const auto &doubt : check.pulses->doubts()) all.push_back(doubt);
  return all;
}

std::vector<std::string> lines_of(const SelfCheck &check) {
  std::vector<std::string> all{sentence_of(check)};
  for (const auto &row : check.rows) all.push_back(first_hit(row));
  if (check.dents) {
    all.push_back(
        fmt::format("Self-check of second hits, at the same speed on the dent of the first: peak force within "
                    "{:.1f} %.",
                    100 * std::max(check.again(), check.again_new())));
    for (const auto &row : check.rows) all.push_back(second_hit(check, row));
  }
  const auto flown = check.pulses ? check.pulses->lines()
                                  : std::vector<std::string>{"Self-check under pulses: not flown, for the "
                                                             "file has no dish."};
  all.insert(all.end(), flown.begin(), flown.end());
  for (const auto &doubt : doubts_of(check)) all.push_back(doubt);
  return all;
}

nlohmann::json to_json(const SelfCheck &check) {
  nlohmann::json all = nlohmann::json::array(), second = nlohmann::json::array();
  for (const auto &row : check.rows) {
    all.push_back({{"speed_m_s", row.speed}, {"law", side(row.law)}, {"spring", side(row.spring)}});
    if (check.dents)
      second.push_back({{"speed_m_s", row.speed}, {"law", side(row.law_again)}, {"spring", side(row.spring_again)}});
  }
  return {{"form", check.form},
          {"peak_force_difference", check.peak_force},
          {"penetration_difference", check.penetration},
          {"rebound_difference", check.rebound},
          {"second_hit_difference", check.dents ? nlohmann::json(check.again()) : nlohmann::json()},
          {"new_rim_difference", check.new_form.empty() ? nlohmann::json() : nlohmann::json(check.again_new())},
          {"serves", check.serves()},
          {"sentence", sentence_of(check)},
          {"doubts", doubts_of(check)},
          {"rows", all},
          {"second_hits", second},
          {"pulses", check.pulses ? check.pulses->json() : nlohmann::json()},
          {"flown_there", check.flown_there}};
}

} // namespace rimpact::calibration
