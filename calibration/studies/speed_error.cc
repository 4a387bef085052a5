#include "calibration/studies/speed_error.h"

#include "io/files/error.h"
#include "io/files/text.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace rimpact::calibration {
namespace {

constexpr double refinement = 1.5; // of h from mesh to mesh

/// Order of the most expensive; the plan's own step counts as the largest.
auto fineness(const StudyRun &run) {
  return std::tuple(run.rung, run.on_curve, run.mesh, run.step > 0 ? -run.step : -1e3);
}

void extrapolate(SpeedError &study, const StudyRun &finest) {
  std::array<std::optional<double>, 4> force;
  for (const auto &row : study.rows)
    if (row.run.rung == finest.rung && row.run.step == finest.step && row.run.mesh >= 1 && row.run.mesh <= 3)
      force[row.run.mesh] = row.run.peak_force;
  if (!force[1] || !force[2] || !force[3]) return;
  const double ratio = (*force[1] - *force[2]) / (*force[2] - *force[3]);
  if (!(ratio > 0)) return;
  const double order = std::log(ratio) / std::log(refinement);
  if (order < 0.5 || order > 5) return;
  study.order = order;
  study.extrapolated = *force[3] + (*force[3] - *force[2]) / (std::pow(refinement, order) - 1);
}

/// A run of rung rim ends with its impact, one with a dish goes on sliding: what they have dissipated is of other
/// spans.
bool ends_alike(const StudyRun &reference, const StudyRun &run) {
  constexpr double alike = 0.01;
  const double end = reference.response.series("time").back();
  return std::abs(run.response.series("time").back() - end) <= alike * std::abs(end);
}

void judge(SpeedError &study, const StudyRun &reference, double capacity) {
  study.touches = reference.peak_force && *reference.peak_force > 0;
  for (auto &row : study.rows) {
    row.errors = compare(reference.response, row.run.response, capacity);
    if (reference.dissipated > 0 && ends_alike(reference, row.run))
      row.dissipated_error = row.run.dissipated / reference.dissipated - 1;
    const double truth = study.extrapolated.value_or(reference.peak_force.value_or(0));
    row.error = study.touches ? std::abs(row.run.peak_force.value_or(0) / truth - 1)
                              : std::abs(row.errors.peak_displacement_error.value_or(0));
  }
}

} // namespace

StudyRun study_run(const std::string &name, const nlohmann::json &summary, Response response) {
  try {
    StudyRun run;
    run.name = name;
    const std::string rung = summary.at("rung");
    const auto solver = parse<SolvedBy>(rung);
    if (!solver) throw DataError("summary.json of " + name + ": rung " + unknown_word(rung, words<SolvedBy>()));
    run.rung = *solver;
    run.mesh = run.rung == SolvedBy::reduced ? 0 : summary.at("mesh").get<int>();
    run.seconds = summary.at("wall_time_s");
    if (const auto time = summary.find("processor_time_s"); time != summary.end() && time->is_number())
      run.processor = time->get<double>();
    run.memory = summary.at("peak_memory_bytes");
    run.n_dofs = summary.value("n_dofs", 0l);
    const auto &energy = summary.at("energy");
    run.imbalance = energy.at("imbalance_relative");
    run.dissipated = energy.at("friction_J").get<double>() + energy.at("plastic_J").get<double>() +
                     energy.at("impact_J").get<double>();
    if (const auto &force = summary.at("peak_impact_force_N"); force.is_number()) run.peak_force = force.get<double>();
    run.response = std::move(response);
    return run;
  } catch (const nlohmann::json::exception &error) {
    throw DataError("summary.json of " + name + " lacks what a study needs: " + error.what());
  }
}

SpeedError speed_against_error(std::vector<StudyRun> runs, double lateral_capacity, double wanted) {
  if (runs.size() < 2)
    throw InputError("a study needs two runs that ended well; there are " + std::to_string(runs.size()));
  if (!(wanted > 0)) throw InputError("the wanted error must be > 0, not " + std::to_string(wanted));
  SpeedError study;
  study.wanted = wanted;
  std::sort(runs.begin(), runs.end(), [](const auto &a, const auto &b) { return a.cost() < b.cost(); });
  for (auto &run : runs) study.rows.emplace_back().run = std::move(run);
  auto reference = std::max_element(study.rows.begin(), study.rows.end(),
                                    [](const auto &a, const auto &b) { return fineness(a.run) < fineness(b.run); });
  reference->reference = true;
  extrapolate(study, reference->run);
  judge(study, reference->run, lateral_capacity);
  double best = std::numeric_limits<double>::infinity();
  for (auto &row : study.rows) {
    if (row.reference && !study.extrapolated) continue; // its error is not known
    if (row.error < best) row.on_frontier = true;
    best = std::min(best, row.error);
    if (row.error <= wanted && study.recommended.empty()) study.recommended = row.run.name;
  }
  return study;
}

} // namespace rimpact::calibration
