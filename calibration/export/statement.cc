#include "calibration/export/statement.h"
#include "calibration/answer/said_once.h"
#include "calibration/fit/parameter.h"
#include "scene/material.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

using scene::StoredAnswer;
using scene::StoredLaw;

namespace {

std::string percent(const std::optional<double> &value) {
  return value ? fmt::format("{:.1f} %", 100 * *value) : "an unknown amount";
}

std::string parameter_line(const std::string &name, const scene::StoredParameter &fitted) {
  std::string line =
      fmt::format("Fitted: {} = {}{}", name, fitted.value ? fmt::format("{:.4g}", *fitted.value) : "no finite number,",
                  unit_behind(fitted.unit));
  if (const auto &[low, high] = fitted.interval_95; low && high)
    line += fmt::format(", 95 % interval {:.4g} to {:.4g}", *low, *high);
  return line + (fitted.identifiable ? "." : "; not identifiable from these runs.");
}

/// Whether speeds of the calibration are not those of the exported mass.
bool is_other_mass(const ExportedRim &rim) {
  return rim.element().law->yields && std::abs(rim.mass / rim.fitted_mass - 1) > 0.01;
}

void add_range(std::vector<std::string> &lines, const ExportedRim &rim, const StoredLaw &law) {
  const auto from = law.valid_from, to = law.valid_to;
  if (law.fitted_from && law.fitted_to)
    lines.push_back(fmt::format("Fitted to impacts at {:g} to {:g} m/s.", *law.fitted_from, *law.fitted_to));
  if (from && to)
    lines.push_back(fmt::format("Holds from {:g} to {:g} m/s: there runs left out of the fit are met within {}.", *from,
                                *to, percent(law.tolerance)));
  else
    lines.push_back("DOUBT: no range of speeds is known in which runs left out of the fit are met; the speeds fitted "
                    "stand below instead.");
  if (from && to && *to < ExportedRim::least_span * *from)
    lines.push_back("DOUBT: that range is narrow; springs and self-check are made for the speeds fitted instead.");
  if (is_other_mass(rim))
    lines.push_back(fmt::format(
        "Exported for {:.6g} kg: the speeds above are of {:.6g} kg, as severe here are {:.3g} to {:.3g} m/s.", rim.mass,
        rim.fitted_mass, rim.from, rim.to));
  if (!law.worst_left_out) {
    lines.push_back("Errors on runs left out: not known, none was left out.");
    return;
  }
  lines.push_back(fmt::format("Largest errors on runs left out{}: peak force {}, rebound {}.",
                              law.worst_left_out->inside_valid_range ? " in that range" : ", all of them",
                              percent(law.worst_left_out->peak_force), percent(law.worst_left_out->rebound)));
}

/// How far the numbers may be from the bearing's, as the answer sums it.
void add_errors(std::vector<std::string> &lines, const StoredAnswer &answer) {
  for (const auto &sentence : answer.error_sentences) lines.push_back("Error of the answer: " + sentence);
  lines.insert(lines.end(), answer.finding_sentences.begin(), answer.finding_sentences.end());
  if (answer.error_sentences.empty() && answer.finding_sentences.empty())
    lines.push_back(
        "DOUBT: how far these numbers may be from the bearing's is not known; the calibration holds no errors.");
}

/// Of which steel the law is, and what the other would do.
void add_steel(std::vector<std::string> &lines, const StoredAnswer &answer) {
  if (answer.steel_rate.empty()) return; // measured, or of an earlier version
  lines.push_back(parse<scene::RateModel>(answer.steel_rate) == scene::RateModel::none
                      ? "Steel: static, without its strain rate."
                      : "Steel: at speed, " + answer.steel_rate + ".");
  if (answer.steel_band)
    lines.insert(lines.end(), answer.steel_band->sentences.begin(), answer.steel_band->sentences.end());
}

void add_doubts(std::vector<std::string> &lines, const ExportedRim &rim, const StoredAnswer &answer) {
  if (!answer.mesh_error.sentence.empty()) lines.push_back("Mesh: " + answer.mesh_error.sentence);
  const std::string speeds =
      is_other_mass(rim)
          ? fmt::format("the speeds of this sentence are of {:.6g} kg, for {:.6g} kg they are {:.3g} times as high. ",
                        rim.fitted_mass, rim.mass, std::sqrt(rim.fitted_mass / rim.mass))
          : "";
  if (answer.strain && !answer.strain->sentence.empty()) lines.push_back("Steel: " + speeds + answer.strain->sentence);
  if (!answer.assumptions.empty()) {
    std::vector<std::string> keys;
    for (const auto &one : answer.assumptions) keys.push_back(one.key + " = " + one.value);
    lines.push_back(fmt::format("Assumed, not given ({}): {}.", keys.size(), fmt::join(keys, ", ")));
  }
  for (const auto &doubt : said_once(answer.doubts)) lines.push_back("DOUBT: " + doubt);
}

} // namespace

std::vector<std::string> statement_of(const ExportedRim &rim, const StoredAnswer &answer, const StoredLaw &law) {
  std::vector<std::string> lines;
  lines.push_back(fmt::format("Bearing {}. Load {:.6g} kN, mass {:.6g} kg, g = {:g} m/s2.", rim.bearing,
                              rim.vertical / 1e3, rim.mass, rim.gravity));
  lines.push_back(fmt::format("Fitted to: {}, rung {}, mesh {}.", answer.source, fmt::join(answer.rungs, ", "),
                              fmt::join(answer.meshes, ", ")));
  lines.push_back(fmt::format("Impact law: {} (chosen by: {}), {}.", rim.law().name, law.chosen_by,
                              rim.of_mass ? fmt::format("holds for {:.6g} kg only", rim.fitted_mass)
                                          : "belongs to the rim, whatever the mass"));
  if (!law.remark.empty()) lines.push_back("Remark: " + law.remark);
  for (const auto &[name, fitted] : law.parameters) lines.push_back(parameter_line(name, fitted));
  add_range(lines, rim, law);
  if (!rim.foot.empty()) lines.push_back(rim.foot);
  add_errors(lines, answer);
  add_steel(lines, answer);
  add_doubts(lines, rim, answer);
  if (!law.sentence.empty()) lines.push_back(law.sentence);
  lines.push_back("Validity: " + (answer.validity.empty() ? std::string("not known.") : answer.validity));
  for (auto &line : lines) line = plain_text(line);
  return lines;
}

} // namespace rimpact::calibration
