#include "calibration/export/exported_rim.h"
#include "calibration/answer/answer.h"
#include "calibration/export/statement.h"
#include "calibration/fit/parameter.h"
#include "io/files/error.h"
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

using scene::StoredAnswer;
using scene::StoredCalibration;
using scene::StoredElement;
using scene::StoredLaw;

namespace {

/// Where the chosen law's numbers, range and errors stand, and under which path of which file.
struct Source {
  StoredLaw law;
  std::string file, path;
  std::optional<double> mass = {}; ///< [kg]; none: the answer's

  [[noreturn]] void fail(const std::string &what) const { throw DataError(fmt::format("{}: {}", file, what)); }
  double needed(const std::optional<double> &value, const std::string &key) const {
    if (!value) fail(key + " is missing: run rimpact calibrate again");
    return *value;
  }
  double positive(const std::optional<double> &value, const std::string &key) const {
    if (!(needed(value, key) > 0)) fail(fmt::format("{}, {:g}, must be > 0", key, *value));
    return *value;
  }
};

std::optional<double> number_of(const StoredElement &element, const std::string &name) {
  const auto found = element.numbers.find(name);
  return found == element.numbers.end() ? std::nullopt : std::optional(found->second);
}

/// Every number the law reads.
scene::ReducedSettings settings_of(const Source &source) {
  const StoredElement &element = source.law.element;
  const std::string where = source.path + ".element";
  scene::Scene scene;
  const laws::ImpactLaw *known = nullptr;
  for (const auto *candidate : laws::impact_laws())
    if (candidate->name == source.law.name) known = candidate;
  if (!known) source.fail(fmt::format("the law {} is not known", plain_text(source.law.name)));
  scene.reduced.impact_law = known;
  for (const auto *names : {&known->parameters, &known->exponents})
    for (const auto &name : *names) {
      const Parameter &p = parameter(name);
      const double value = source.needed(number_of(element, name), where + "." + name);
      if (!(value >= 0)) source.fail(fmt::format("{}.{}, {:g}, must be >= 0", where, name, value));
      p.set(scene, value * p.si);
    }
  source.positive(number_of(element, "k_i"), where + ".k_i"); // zero is no rim
  if (element.reference_speed)
    scene.reduced.reference_speed = source.positive(element.reference_speed, where + ".reference_speed_m_per_s");
  try {
    scene.validate();
  } catch (const InputError &error) {
    source.fail(fmt::format("{}: {}", where, error.what()));
  }
  return scene.reduced;
}

Source pair_of(const StoredAnswer &answer, const std::string &file) {
  if (!answer.pair)
    throw InputError(fmt::format("--law pair: no constant pair serves this bearing; {}",
                                 answer.no_pair.empty() ? "calibration.json names none" : plain_text(answer.no_pair)));
  const scene::StoredPair &pair = *answer.pair;
  StoredLaw law{
      .name = pair.law.empty() ? "no-tension" : pair.law,
      .chosen_by = word(ChosenBy::user),
      .remark =
          "A constant pair is a convenience for one mass and the speeds named; the calibration's answer is the law.",
      .sentence = pair.sentence,
      .belongs_to = scene::BelongsTo::mass,
      .parameters = pair.parameters,
      .element = {.numbers = {{"k_i", pair.k_i}, {"e", pair.e}}},
      .fitted_from = pair.from,
      .fitted_to = pair.to,
      .valid_from = pair.from,
      .valid_to = pair.to,
      .tolerance = pair.tolerance,
      .worst_left_out = scene::StoredWorst{
          .peak_force = pair.worst_peak_force, .rebound = pair.worst_rebound, .inside_valid_range = true}};
  return {.law = law, .file = file, .path = "answer.pair", .mass = pair.mass};
}

/// What was fitted, and beside it what the law reads as rimpact's defaults. Throws DataError for another unit.
StoredElement element_of(const scene::StoredRankedLaw &row, const std::string &file) {
  const laws::ImpactLaw &law = laws::impact_law(row.law);
  const scene::Scene defaults;
  StoredElement element;
  for (const auto *names : {&law.parameters, &law.exponents})
    for (const auto &name : *names) {
      const auto fitted = row.parameters.find(name);
      const Parameter &p = parameter(name);
      const std::string unit = fitted == row.parameters.end() ? "" : fitted->second.unit;
      if (!unit.empty() && unit != p.unit)
        throw DataError(fmt::format("{}: laws.rows, {}: parameters.{}.unit is \"{}\", not \"{}\"", file,
                                    plain_text(row.law), name, plain_text(unit), p.unit));
      if (fitted == row.parameters.end())
        element.numbers[name] = p.get(defaults) / p.si;
      else if (fitted->second.value)
        element.numbers[name] = *fitted->second.value;
    }
  return element;
}

/// A ranked law that is not the answer.
Source ranked(const StoredCalibration &calibration, const std::string &name) {
  std::vector<std::string> known;
  const StoredLaw &answered = calibration.answer->law;
  for (const auto &row : calibration.laws.rows) {
    known.push_back(plain_text(row.law));
    if (row.law != name) continue;
    StoredLaw law{
        .name = name,
        .chosen_by = word(ChosenBy::user),
        .remark =
            fmt::format("The law {} was asked for; the calibration's answer is {}.", name, plain_text(answered.name)),
        .sentence = row.sentence,
        .belongs_to = laws::impact_law(name).of_mass ? scene::BelongsTo::mass : scene::BelongsTo::rim,
        .parameters = row.parameters,
        .element = element_of(row, calibration.file),
        .fitted_from = answered.fitted_from,
        .fitted_to = answered.fitted_to,
        .valid_from = row.valid_from,
        .valid_to = row.valid_to,
        .tolerance = calibration.laws.tolerance,
        .worst_left_out = scene::StoredWorst{.peak_force = row.left_out_peak_force, .rebound = row.left_out_rebound}};
    return {.law = law, .file = calibration.file, .path = "laws.rows"};
  }
  throw InputError(fmt::format(
      "--law {}: not among the laws of this calibration ({}); rank it with `rimpact calibrate RUN... --laws {}`",
      plain_text(name), fmt::join(known, ", "), plain_text(name)));
}

Source source_of(const StoredCalibration &calibration, const std::string &law) {
  if (!calibration.answer) throw DataError(calibration.file + ": has no answer: run rimpact calibrate again");
  if (law.empty() || law == calibration.answer->law.name)
    return {.law = calibration.answer->law, .file = calibration.file, .path = "answer.law"};
  return law == "pair" ? pair_of(*calibration.answer, calibration.file) : ranked(calibration, law);
}

void require_within(const char *option, double value, double least, double most, const char *unit) {
  if (!(value >= least && value <= most))
    throw InputError(fmt::format("{} {:g} must be >= {:g} and <= {:g} {}", option, value, least, most, unit));
}

/// One of mass and dead load makes the other: W = m g.
void set_load(ExportedRim &rim, const StoredAnswer &answer, const Source &source, const ExportChoice &choice) {
  if (choice.mass) require_within("--mass", *choice.mass, 1, 1e9, "kg");
  if (choice.vertical) require_within("--load", *choice.vertical / 1e3, 0.01, 1e7, "kN");
  rim.gravity = source.positive(answer.gravity, "answer.gravity_m_per_s2");
  rim.mass = choice.mass ? *choice.mass : choice.vertical ? *choice.vertical / rim.gravity : rim.fitted_mass;
  rim.vertical = choice.vertical ? *choice.vertical
                 : choice.mass   ? *choice.mass * rim.gravity
                                 : source.positive(answer.vertical, "answer.vertical_kN");
}

/// Where the joint at the rim's foot goes, a law's speeds end at the fastest run that it bears.
void end_at_foot(ExportedRim &rim, const scene::StoredFoot &foot, double from, double &to) {
  const std::string joint = plain_text(foot.in_words);
  if (foot.goes_at_force)
    rim.foot =
        fmt::format("ENDS at {:.4g} kN of the rim's force: there the joint at its foot, {}, goes and the wall breaks "
                    "off. Stop an analysis that passes it; nothing beyond is a result.",
                    *foot.goes_at_force / 1e3, joint);
  if (!foot.goes_at) return;
  if (foot.borne_to) to = std::min(to, *foot.borne_to);
  if (foot.borne_to && *foot.borne_to >= from) return;
  throw InputError(
      fmt::format("the joint at the rim's foot, {}, goes at {:.3g} m/s or below, and the slowest speed of this "
                  "law is {:.3g} m/s: there is no law to export; run slower impacts, or give "
                  "bearing.rim.connection a stronger joint",
                  joint, *foot.goes_at, from));
}

/// Speeds the law is exported for. At another mass a law that knows no rate reaches the same penetrations at other
/// speeds: v sqrt(m).
void set_range(ExportedRim &rim, const Source &source, const std::optional<scene::StoredFoot> &foot) {
  auto from = source.law.valid_from, to = source.law.valid_to;
  if (!from || !to ||
      *to < ExportedRim::least_span * *from) // one speed alone would be met exactly, and say nothing of the others
    from = source.needed(source.law.fitted_from, source.path + ".fitted_from_m_s"),
    to = source.needed(source.law.fitted_to, source.path + ".fitted_to_m_s");
  if (!(*from > 0 && *to >= *from))
    source.fail(fmt::format("{}: speeds {:g} to {:g} m/s must be > 0 and rise", source.path, *from, *to));
  if (foot) end_at_foot(rim, *foot, *from, *to);
  const double scale = rim.element().law->yields ? std::sqrt(rim.fitted_mass / rim.mass) : 1;
  rim.from = scale * *from, rim.to = rim.tuned_to = scale * *to;
}

} // namespace

ExportedRim exported_rim(const StoredCalibration &calibration, const ExportChoice &choice) {
  const Source source = source_of(calibration, choice.law);
  const StoredAnswer &answer = *calibration.answer;
  ExportedRim rim;
  rim.settings = settings_of(source);
  rim.of_mass = source.law.belongs_to == scene::BelongsTo::mass;
  rim.fitted_mass = source.mass ? source.positive(source.mass, "answer.pair.mass_kg")
                                : source.positive(answer.mass, "answer.mass_kg");
  set_load(rim, answer, source, choice);
  if (rim.of_mass && std::abs(rim.mass / rim.fitted_mass - 1) > 0.01)
    throw InputError(fmt::format("--mass {:.6g}: the law {} holds for {:.6g} kg only, for its dashpot is scaled by the "
                                 "mass; calibrate at that mass, or export a law "
                                 "of the rim (elastoplastic)",
                                 rim.mass, rim.law().name, rim.fitted_mass));
  rim.lateral_capacity = source.positive(answer.law.element.lateral_capacity, "answer.law.element.lateral_capacity_m");
  set_range(rim, source, answer.foot);
  rim.bearing = plain_text(answer.bearing), rim.rim_identity = plain_text(answer.rim_identity);
  rim.statement = statement_of(rim, answer, source.law);
  return rim;
}

} // namespace rimpact::calibration
