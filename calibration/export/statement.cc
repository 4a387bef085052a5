#include "calibration/export/statement.h"
#include "calibration/answer/said_once.h"
#include "calibration/fit/parameter.h"
#include "scene/material.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

using nlohmann::json;

namespace {

std::string text(const json &object, const char *key) {
  if (!object.is_object() || !object.contains(key)) return {};
  const json &value = object[key];
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return std::to_string(value.get<long long>());
  if (!value.is_array()) return {};
  std::vector<std::string> parts;
  for (const auto &part : value)
    parts.push_back(part.is_string()   ? part.get<std::string>()
                    : part.is_number() ? fmt::format("{:g}", part.get<double>())
                                       : "?");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::optional<double> number(const json &object, const char *key) {
  if (!object.is_object() || !object.contains(key) || !object[key].is_number() ||
      !std::isfinite(object[key].get<double>()))
    return std::nullopt;
  return object[key].get<double>();
}

std::string percent(const std::optional<double> &value) {
  return value ? fmt::format("{:.1f} %", 100 * *value) : "an unknown amount";
}

std::string parameter_line(const std::string &name, const json &fitted) {
  const std::string unit = text(fitted, "unit");
  std::string line = fmt::format("Fitted: {} = {:.4g}{}", name, number_at(fitted, "value", plain_text(name).c_str()),
                                 unit_behind(unit));
  const json interval = fitted.value("interval_95", json());
  if (interval.is_array() && interval.size() == 2 && interval[0].is_number() && interval[1].is_number())
    line += fmt::format(", 95 % interval {:.4g} to {:.4g}", interval[0].get<double>(), interval[1].get<double>());
  const json known = fitted.value("identifiable", json(true));
  return line + (known.is_boolean() && !known.get<bool>() ? "; not identifiable from these runs." : ".");
}

/// Whether speeds of the calibration are not those of the exported mass.
bool is_other_mass(const ExportedRim &rim) {
  return rim.element().law->yields && std::abs(rim.mass / rim.fitted_mass - 1) > 0.01;
}

void add_range(std::vector<std::string> &lines, const ExportedRim &rim, const json &law) {
  const auto from = number(law, "valid_from_m_s"), to = number(law, "valid_to_m_s");
  const auto fitted_from = number(law, "fitted_from_m_s"), fitted_to = number(law, "fitted_to_m_s");
  if (fitted_from && fitted_to)
    lines.push_back(fmt::format("Fitted to impacts at {:g} to {:g} m/s.", *fitted_from, *fitted_to));
  if (from && to)
    lines.push_back(fmt::format("Holds from {:g} to {:g} m/s: there runs left out of the fit are met within {}.", *from,
                                *to, percent(number(law, "tolerance"))));
  else
    lines.push_back("DOUBT: no range of speeds is known in which runs left out of the fit are met; the speeds fitted "
                    "stand below instead.");
  if (from && to && *to < ExportedRim::least_span * *from)
    lines.push_back("DOUBT: that range is narrow; springs and self-check are made for the speeds fitted instead.");
  if (is_other_mass(rim))
    lines.push_back(fmt::format(
        "Exported for {:.6g} kg: the speeds above are of {:.6g} kg, as severe here are {:.3g} to {:.3g} m/s.", rim.mass,
        rim.fitted_mass, rim.from, rim.to));
  const json worst = law.value("worst_left_out", json());
  if (!worst.is_object()) {
    lines.push_back("Errors on runs left out: not known, none was left out.");
    return;
  }
  const json inside = worst.value("inside_valid_range", json());
  lines.push_back(fmt::format("Largest errors on runs left out{}: peak force {}, rebound {}.",
                              inside == json(true) ? " in that range" : ", all of them",
                              percent(number(worst, "peak_force")), percent(number(worst, "rebound"))));
}

/// How far the numbers may be from the bearing's, as the answer sums it.
void add_errors(std::vector<std::string> &lines, const json &answer) {
  const json sentences = answer.value("error_sentences", json());
  const std::size_t before = lines.size();
  if (sentences.is_array())
    for (const auto &sentence : sentences)
      if (sentence.is_string()) lines.push_back("Error of the answer: " + sentence.get<std::string>());
  for (const auto &sentence : answer.value("finding_sentences", json::array()))
    if (sentence.is_string()) lines.push_back(sentence.get<std::string>());
  if (lines.size() == before)
    lines.push_back(
        "DOUBT: how far these numbers may be from the bearing's is not known; the calibration holds no errors.");
}

/// Of which steel the law is, and what the other would do.
void add_steel(std::vector<std::string> &lines, const json &answer) {
  const json rate = answer.value("steel_rate", json()), band = answer.value("steel_band", json());
  if (!rate.is_string()) return; // measured, or of an earlier version
  lines.push_back(parse<scene::RateModel>(rate.get<std::string>()) == scene::RateModel::none
                      ? "Steel: static, without its strain rate."
                      : "Steel: at speed, " + rate.get<std::string>() + ".");
  if (band.is_object())
    for (const auto &sentence : band.value("sentences", json::array()))
      if (sentence.is_string()) lines.push_back(sentence.get<std::string>());
}

void add_doubts(std::vector<std::string> &lines, const ExportedRim &rim, const json &answer) {
  const json mesh = answer.value("mesh_error", json()), strain = answer.value("strain", json()),
             assumed = answer.value("assumptions", json());
  if (const auto sentence = text(mesh, "sentence"); !sentence.empty()) lines.push_back("Mesh: " + sentence);
  const std::string speeds =
      is_other_mass(rim)
          ? fmt::format("the speeds of this sentence are of {:.6g} kg, for {:.6g} kg they are {:.3g} times as high. ",
                        rim.fitted_mass, rim.mass, std::sqrt(rim.fitted_mass / rim.mass))
          : "";
  if (const auto sentence = text(strain, "sentence"); !sentence.empty()) lines.push_back("Steel: " + speeds + sentence);
  if (assumed.is_array() && !assumed.empty()) {
    std::vector<std::string> keys;
    for (const auto &one : assumed) keys.push_back(text(one, "key") + " = " + text(one, "value"));
    lines.push_back(fmt::format("Assumed, not given ({}): {}.", assumed.size(), fmt::join(keys, ", ")));
  }
  const json doubts = answer.value("doubts", json());
  std::vector<std::string> sentences;
  if (doubts.is_array())
    for (const auto &doubt : doubts)
      if (doubt.is_string()) sentences.push_back(doubt.get<std::string>());
  for (const auto &doubt : said_once(sentences)) lines.push_back("DOUBT: " + doubt);
}

} // namespace

std::vector<std::string> statement_of(const ExportedRim &rim, const json &answer, const json &law) {
  std::vector<std::string> lines;
  lines.push_back(fmt::format("Bearing {}. Load {:.6g} kN, mass {:.6g} kg, g = {:g} m/s2.", rim.bearing,
                              rim.vertical / 1e3, rim.mass, rim.gravity));
  lines.push_back(fmt::format("Fitted to: {}, rung {}, mesh {}.", text(answer, "source"), text(answer, "rung"),
                              text(answer, "mesh")));
  lines.push_back(fmt::format("Impact law: {} (chosen by: {}), {}.", rim.law().name, text(law, "chosen_by"),
                              rim.of_mass ? fmt::format("holds for {:.6g} kg only", rim.fitted_mass)
                                          : "belongs to the rim, whatever the mass"));
  if (const auto remark = text(law, "remark"); !remark.empty()) lines.push_back("Remark: " + remark);
  const json parameters = law.value("parameters", json::object());
  if (parameters.is_object())
    for (const auto &[name, fitted] : parameters.items())
      if (fitted.is_object()) lines.push_back(parameter_line(name, fitted));
  add_range(lines, rim, law);
  if (!rim.foot.empty()) lines.push_back(rim.foot);
  add_errors(lines, answer);
  add_steel(lines, answer);
  add_doubts(lines, rim, answer);
  const std::string sentence = text(law, "sentence"), validity = text(answer, "validity");
  if (!sentence.empty()) lines.push_back(sentence);
  lines.push_back("Validity: " + (validity.empty() ? std::string("not known.") : validity));
  for (auto &line : lines) line = plain_text(line);
  return lines;
}

} // namespace rimpact::calibration
