#include "calibration/export/exported_rim.h"
#include "calibration/answer/answer.h"
#include "calibration/export/statement.h"
#include "calibration/fit/parameter.h"
#include "io/files/error.h"
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

using nlohmann::json;

double number_at(const json &object, const char *key, const char *where) {
  const json *entry = object.is_object() && object.contains(key) ? &object[key] : nullptr;
  if (entry && entry->is_object() && entry->contains("value")) entry = &(*entry)["value"];
  if (!entry || entry->is_null()) throw DataError(fmt::format("calibration.json: {} holds no {}", where, key));
  if (!entry->is_number() || !std::isfinite(entry->get<double>()))
    throw DataError(fmt::format("calibration.json: {} of {} is not a number", key, where));
  return entry->get<double>();
}

namespace {

double positive_at(const json &object, const char *key, const char *where) {
  const double value = number_at(object, key, where);
  if (!(value > 0)) throw DataError(fmt::format("calibration.json: {} of {}, {:g}, must be > 0", key, where, value));
  return value;
}

std::optional<double> number_or_none(const json &object, const char *key, const char *where) {
  if (!object.is_object() || !object.contains(key) || object[key].is_null()) return std::nullopt;
  return number_at(object, key, where);
}

/// Every number the law reads: from `element`, which holds them all, or from what was fitted where there is no element.
scene::ReducedSettings settings_of(const std::string &law, const json &element, const char *where) {
  scene::Scene scene;
  const laws::ImpactLaw *known = nullptr;
  for (const auto *candidate : laws::impact_laws())
    if (candidate->name == law) known = candidate;
  if (!known) throw DataError(fmt::format("calibration.json: the law {} is not known", plain_text(law)));
  scene.reduced.impact_law = known;
  for (const auto *names : {&known->parameters, &known->exponents})
    for (const auto &name : *names) {
      const Parameter &p = parameter(name);
      const double value = number_at(element, name.c_str(), where);
      if (!(value >= 0))
        throw DataError(fmt::format("calibration.json: {} of {}, {:g}, must be >= 0", name, where, value));
      p.set(scene, value * p.si);
    }
  positive_at(element, "k_i", where); // zero is no rim
  for (const char *key : {"reference_speed_m_per_s", "reference_speed"})
    if (element.contains(key)) scene.reduced.reference_speed = positive_at(element, key, where);
  try {
    scene.validate();
  } catch (const InputError &error) {
    throw DataError(fmt::format("calibration.json: {}: {}", where, error.what()));
  }
  return scene.reduced;
}

/// Where the chosen law's numbers, range and errors stand.
struct Source {
  json law;          ///< as answer.law is written
  std::string where; ///< for messages
};

Source pair_of(const json &answer) {
  const json pair = answer.value("pair", json());
  if (!pair.is_object()) {
    const json why = answer.value("no_pair", json());
    throw InputError(fmt::format("--law pair: no constant pair serves this bearing; {}",
                                 why.is_string() ? plain_text(why.get<std::string>()) : "calibration.json names none"));
  }
  json law = {
      {"name", pair.value("law", json("no-tension"))},
      {"chosen_by", word(ChosenBy::user)},
      {"belongs_to", "mass"},
      {"remark",
       "A constant pair is a convenience for one mass and the speeds named; the calibration's answer is the law."}};
  law["element"] = {{"k_i", number_at(pair, "k_i_kN_per_m", "answer.pair")},
                    {"e", number_at(pair, "e", "answer.pair")}};
  law["mass_kg"] = number_at(pair, "mass_kg", "answer.pair");
  for (const char *end : {"from", "to"}) {
    const double speed = number_at(pair, fmt::format("{}_m_s", end).c_str(), "answer.pair");
    for (const char *range : {"fitted", "valid"}) law[fmt::format("{}_{}_m_s", range, end)] = speed;
  }
  law["parameters"] = pair.value("parameters", json::object());
  law["tolerance"] = pair.value("tolerance", json());
  law["worst_left_out"] = {{"peak_force", pair.value("worst_peak_force_error", json())},
                           {"rebound", pair.value("worst_rebound_error", json())},
                           {"inside_valid_range", true}};
  law["sentence"] = pair.value("sentence", json());
  return {law, "answer.pair"};
}

/// A ranked law that is not the answer: fitted numbers, and what it read beside them from the answer or as rimpact's
/// defaults.
Source ranked(const json &calibration, const json &answer, const std::string &name) {
  const json rows = calibration.value("laws", json::object()).value("rows", json::array());
  std::vector<std::string> known;
  for (const auto &row : rows) {
    const json law_name = row.value("law", json());
    if (!law_name.is_string()) continue;
    known.push_back(plain_text(law_name.get<std::string>()));
    if (law_name != name) continue;
    const laws::ImpactLaw &own = laws::impact_law(name);
    json law = {{"name", name}, {"chosen_by", word(ChosenBy::user)}, {"belongs_to", own.of_mass ? "mass" : "rim"}};
    law["parameters"] = row.value("parameters", json::object());
    law["element"] = row.value("element", row.value("parameters", json::object()));
    scene::Scene defaults;
    for (const auto *names : {&own.parameters, &own.exponents})
      for (const auto &p : *names)
        if (!law["element"].contains(p)) law["element"][p] = parameter(p).get(defaults) / parameter(p).si;
    law["fitted_from_m_s"] = answer["law"].value("fitted_from_m_s", json());
    law["fitted_to_m_s"] = answer["law"].value("fitted_to_m_s", json());
    law["valid_from_m_s"] = row.value("valid_from_m_s", json());
    law["valid_to_m_s"] = row.value("valid_to_m_s", json());
    law["tolerance"] = calibration["laws"].value("tolerance", json());
    law["worst_left_out"] = {{"peak_force", row.value("left_out_peak_force_error", json())},
                             {"rebound", row.value("left_out_rebound_error", json())},
                             {"inside_valid_range", false}};
    law["sentence"] = row.value("sentence", json());
    law["remark"] = fmt::format("The law {} was asked for; the calibration's answer is {}.", name,
                                plain_text(answer["law"].value("name", "")));
    return {law, "laws.rows"};
  }
  throw InputError(fmt::format(
      "--law {}: not among the laws of this calibration ({}); rank it with `rimpact calibrate RUN... --laws {}`",
      plain_text(name), fmt::join(known, ", "), plain_text(name)));
}

const json &answer_of(const json &calibration) {
  if (!calibration.is_object() || !calibration.contains("answer") || !calibration["answer"].is_object())
    throw DataError("calibration.json has no answer: run rimpact calibrate again");
  const json &answer = calibration["answer"];
  if (!answer.contains("law") || !answer["law"].is_object()) throw DataError("calibration.json: answer holds no law");
  return answer;
}

void require_within(const char *option, double value, double least, double most, const char *unit) {
  if (!(value >= least && value <= most))
    throw InputError(fmt::format("{} {:g} must be >= {:g} and <= {:g} {}", option, value, least, most, unit));
}

/// One of mass and dead load makes the other: W = m g.
void set_load(ExportedRim &rim, const json &answer, const ExportChoice &choice) {
  if (choice.mass) require_within("--mass", *choice.mass, 1, 1e9, "kg");
  if (choice.vertical) require_within("--load", *choice.vertical / 1e3, 0.01, 1e7, "kN");
  rim.gravity = positive_at(answer, "gravity_m_per_s2", "answer");
  rim.mass = choice.mass ? *choice.mass : choice.vertical ? *choice.vertical / rim.gravity : rim.fitted_mass;
  rim.vertical = choice.vertical ? *choice.vertical
                 : choice.mass   ? *choice.mass * rim.gravity
                                 : 1e3 * positive_at(answer, "vertical_kN", "answer");
}

/// Where the joint at the rim's foot goes, a law's speeds end at the fastest run that it bears.
void end_at_foot(ExportedRim &rim, const json &foot, double from, double &to) {
  if (!foot.is_object()) return;
  const std::string where = "answer.rim_foot", joint = plain_text(foot.value("in_words", std::string()));
  if (const auto force = number_or_none(foot, "goes_at_force_kN", where.c_str()))
    rim.foot =
        fmt::format("ENDS at {:.4g} kN of the rim's force: there the joint at its foot, {}, goes and the wall breaks "
                    "off. Stop an analysis that passes it; nothing beyond is a result.",
                    *force, joint);
  const auto goes = number_or_none(foot, "goes_at_m_s", where.c_str()),
             borne = number_or_none(foot, "borne_to_m_s", where.c_str());
  if (!goes) return;
  if (borne) to = std::min(to, *borne);
  if (borne && *borne >= from) return;
  throw InputError(
      fmt::format("the joint at the rim's foot, {}, goes at {:.3g} m/s or below, and the slowest speed of this "
                  "law is {:.3g} m/s: there is no law to export; run slower impacts, or give "
                  "bearing.rim.connection a stronger joint",
                  joint, *goes, from));
}

/// Speeds the law is exported for. At another mass a law that knows no rate reaches the same penetrations at other
/// speeds: v sqrt(m).
void set_range(ExportedRim &rim, const json &law, const std::string &where, const json &foot) {
  auto from = number_or_none(law, "valid_from_m_s", where.c_str()),
       to = number_or_none(law, "valid_to_m_s", where.c_str());
  if (!from || !to ||
      *to < ExportedRim::least_span * *from) // one speed alone would be met exactly, and say nothing of the others
    from = number_at(law, "fitted_from_m_s", where.c_str()), to = number_at(law, "fitted_to_m_s", where.c_str());
  if (!(*from > 0 && *to >= *from))
    throw DataError(
        fmt::format("calibration.json: {}: speeds {:g} to {:g} m/s must be > 0 and rise", where, *from, *to));
  end_at_foot(rim, foot, *from, *to);
  const double scale = rim.element().law->yields ? std::sqrt(rim.fitted_mass / rim.mass) : 1;
  rim.from = scale * *from, rim.to = rim.tuned_to = scale * *to;
}

} // namespace

ExportedRim exported_rim(const json &calibration, const ExportChoice &choice) try {
  const json &answer = answer_of(calibration);
  const json name = answer["law"].value("name", json());
  if (!name.is_string()) throw DataError("calibration.json: name of answer.law is not a word");
  const bool asked = !choice.law.empty() && choice.law != name.get<std::string>();
  const Source source = !asked                 ? Source{answer["law"], "answer.law"}
                        : choice.law == "pair" ? pair_of(answer)
                                               : ranked(calibration, answer, choice.law);
  if (!source.law["name"].is_string())
    throw DataError(fmt::format("calibration.json: name of {} is not a word", source.where));
  ExportedRim rim;
  const std::string where = source.where + ".element";
  const json element = source.law.value("element", json::object());
  rim.settings = settings_of(source.law["name"], element, where.c_str());
  rim.of_mass = source.law.value("belongs_to", json()) == json("mass");
  rim.fitted_mass = positive_at(source.law.contains("mass_kg") ? source.law : answer, "mass_kg", "answer");
  set_load(rim, answer, choice);
  if (rim.of_mass && std::abs(rim.mass / rim.fitted_mass - 1) > 0.01)
    throw InputError(fmt::format("--mass {:.6g}: the law {} holds for {:.6g} kg only, for its dashpot is scaled by the "
                                 "mass; calibrate at that mass, or export a law "
                                 "of the rim (elastoplastic)",
                                 rim.mass, rim.law().name, rim.fitted_mass));
  const json capacity =
      element.contains("lateral_capacity_m") ? element : answer["law"].value("element", json::object());
  rim.lateral_capacity = positive_at(capacity, "lateral_capacity_m", "answer.law.element");
  set_range(rim, source.law, source.where, answer.value("rim_foot", json()));
  const auto word = [&](const char *key) {
    const json v = answer.value(key, json());
    return v.is_string() ? plain_text(v.get<std::string>()) : std::string();
  };
  rim.bearing = word("bearing"), rim.rim_identity = word("rim_identity");
  rim.statement = statement_of(rim, answer, source.law);
  return rim;
} catch (const json::exception &error) { // a value of another kind than calibrations write
  throw DataError(fmt::format("calibration.json: {}; run rimpact calibrate again", plain_text(error.what())));
}

} // namespace rimpact::calibration
