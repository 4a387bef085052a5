#include "calibration/fit/run_facts.h"
#include "calibration/data/measured_name.h"
#include "io/files/error.h"
#include "responses/kept_run.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace rimpact::calibration {

namespace {
namespace fs = std::filesystem;
using nlohmann::json;

std::string last_part(const std::string &folder) {
  const auto path = fs::path(folder).lexically_normal();
  return path.has_filename() ? path.filename() : path.parent_path().filename();
}

double number_in(const json &object, const char *key) {
  return object.is_object() && object.contains(key) && object[key].is_number() ? object[key].get<double>() : 0.0;
}

} // namespace

RunFacts run_facts(const std::string &folder) {
  RunFacts facts;
  facts.name = last_part(folder);
  const auto file = fs::path(folder) / "summary.json";
  if (is_mapping(folder) || !fs::exists(file)) return facts;
  std::ifstream text(file);
  const json summary = json::parse(text, nullptr, false);
  if (!summary.is_object()) throw DataError(file.string() + " is not valid JSON");
  if (const auto solver = word_in<SolvedBy>(summary, "rung", folder)) {
    facts.rung = rung_of(*solver);
    facts.source = facts.rung ? RunSource::finite_elements : RunSource::reduced_model;
  }
  if (facts.rung && summary.contains("mesh") && summary["mesh"].is_number_integer())
    facts.mesh = summary["mesh"].get<int>();
  facts.status = word_in<RunStatus>(summary, "status", folder).value_or(RunStatus::done);
  if (summary.contains("warnings") && summary["warnings"].is_array())
    for (const auto &warning : summary["warnings"])
      if (warning.is_string()) facts.warnings.push_back(warning);
  if (summary.contains("energy")) facts.imbalance = number_in(summary["energy"], "imbalance_relative");
  facts.steel = steel_report_in(summary, file.string());
  facts.foot = foot_report_in(summary, file.string());
  const double of_any_body = number_in(summary, "max_plastic_strain");
  facts.strain = judged_strain(facts.steel, of_any_body > 0 ? std::optional(of_any_body) : std::nullopt);
  facts.beyond_rim = summary.value("beyond_rim", json()) == json(true);
  facts.seconds = number_in(summary, "wall_time_s");
  return facts;
}

std::vector<std::string> screen(std::vector<StoredRun> &runs, const std::map<std::string, RunFacts> &facts,
                                const Uncertainty &stated, bool keep_stopped) {
  std::vector<std::string> sentences;
  std::vector<StoredRun> kept;
  for (auto &run : runs) {
    const RunFacts &f = facts.at(run.folder);
    const double off = std::abs(f.imbalance);
    if (f.status != RunStatus::done && !keep_stopped) {
      sentences.push_back(fmt::format("{} is left out of the fit: it is {}; --keep-stopped takes what it holds", f.name,
                                      word(f.status)));
      continue;
    }
    if (f.status != RunStatus::done)
      sentences.push_back(fmt::format("{} is {}; what it holds is fitted all the same", f.name, word(f.status)));
    if (f.beyond_rim) {
      sentences.push_back(fmt::format(
          "{} is left out of the fit: it pressed deeper than its rim is thick, which it says itself is no result",
          f.name));
      continue;
    }
    if (off > largest_imbalance) {
      sentences.push_back(fmt::format("{} is left out of the fit: {:.2f} % of its energy is unaccounted for, where "
                                      "{:.0f} % is the most that is taken",
                                      f.name, 100 * f.imbalance, 100 * largest_imbalance));
      continue;
    }
    if (off > usual_imbalance) {
      run.uncertainty = run.uncertainty.value_or(stated);
      run.uncertainty->force += off;
      sentences.push_back(fmt::format(
          "{} counts less: {:.2f} % of its energy is unaccounted for, which is added to the uncertainty of its force",
          f.name, 100 * f.imbalance));
    }
    kept.push_back(std::move(run));
  }
  runs = std::move(kept);
  if (runs.empty())
    throw DataError("no run is left to fit: " + (sentences.empty() ? "none is named" : sentences.front()));
  return sentences;
}

} // namespace rimpact::calibration
