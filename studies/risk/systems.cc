#include "studies/risk/systems.h"
#include "io/files/error.h"
#include "io/files/key_list.h"
#include "studies/fleets/sweep_toml.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

using fleets::Axis;
using fleets::SweepParts;

bool holds(const std::vector<std::string> &names, const std::string &name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> keys_of_systems(const SweepParts &parts) {
  std::vector<std::string> keys;
  for (const auto *cases : {&parts.cases, &parts.devices})
    if (!cases->empty())
      for (const auto &axis : cases->front()) keys.push_back(axis.key);
  for (const auto &axis : parts.grid) keys.push_back(axis.key);
  return keys;
}

/// Linked to keys of systems only: it belongs to them.
bool is_of_systems(const fleets::LinkedKey &linked, const std::vector<std::string> &keys) {
  const auto known = [&](const std::string &key) { return holds(keys, key); };
  return std::all_of(linked.factors.begin(), linked.factors.end(), known) &&
         (linked.divisor.empty() || known(linked.divisor));
}

double number_of(const Systems &systems, std::size_t system, const std::string &key, const std::string &place) {
  const auto at = std::find(systems.keys.begin(), systems.keys.end(), key) - systems.keys.begin();
  if (const auto *number = std::get_if<double>(&systems.all[system].values[static_cast<std::size_t>(at)]))
    return *number;
  throw InputError(fmt::format("{}: {} is no number", place, key));
}

/// A linked key of the runs, what it takes of the system folded into its factor.
fleets::LinkedKey folded(const fleets::LinkedKey &linked, const Systems &systems, std::size_t system) {
  fleets::LinkedKey result = linked;
  result.factors.clear();
  for (const auto &key : linked.factors)
    if (holds(systems.keys, key))
      result.factor *= number_of(systems, system, key, linked.place);
    else
      result.factors.push_back(key);
  if (holds(systems.keys, linked.divisor)) {
    result.factor /= number_of(systems, system, linked.divisor, linked.place);
    result.divisor.clear();
  }
  return result;
}

fleets::Value text_value(const std::string &text) {
  return {toml_quoted(text), text};
}

std::vector<Axis> case_of(const Motion &motion, double level_g) {
  return {{"record", {text_value(motion.record)}},
          {"excitation.kind", {text_value("record")}},
          {"excitation.x", {text_value(motion.file)}},
          {"excitation.y", {text_value("")}},
          {"excitation.z", {text_value("")}},
          {"excitation.scale", {fleets::number_value(motion.scale)}},
          {"variable.level_g", {fleets::number_value(level_g)}}};
}

} // namespace

Systems systems_of(const Study &study) {
  SweepParts parts;
  parts.cases = study.parts.cases, parts.devices = study.parts.devices, parts.grid = study.parts.grid;
  const auto keys = keys_of_systems(parts);
  for (const auto &linked : study.parts.linked)
    if (is_of_systems(linked, keys)) parts.linked.push_back(linked);
  Systems systems;
  if (keys.empty()) {
    systems.all.push_back({{}, study.settings});
    return systems;
  }
  const fleets::Sweep sweep = fleets::combine(parts, study.origin);
  systems.keys = sweep.keys;
  for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
    System system{{}, study.settings};
    for (const auto &value : sweep.runs[i]) system.values.push_back(value.cell);
    for (auto &assignment : sweep.assignments(i)) system.overrides.push_back(std::move(assignment));
    systems.all.push_back(std::move(system));
  }
  return systems;
}

fleets::Sweep runs_of(const Study &study, const Systems &systems, std::size_t system, const Motions &motions) {
  SweepParts parts;
  for (const auto &level : motions.levels)
    for (const auto &motion : level.motions) parts.cases.push_back(case_of(motion, level.intensity_g));
  parts.sampled = study.parts.sampled, parts.samples = study.parts.samples, parts.seed = study.parts.seed;
  const auto keys = keys_of_systems(study.parts);
  for (const auto &linked : study.parts.linked)
    if (!is_of_systems(linked, keys)) parts.linked.push_back(folded(linked, systems, system));
  return fleets::combine(parts, study.origin);
}

} // namespace rimpact::risk
