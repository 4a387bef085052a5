#include "calibration/answer/solid_errors.h"
#include "calibration/answer/finding.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

constexpr Erring of_impacts[] = {Erring::peak_force, Erring::depth, Erring::rebound};

const StoredRun *hardest_of(const Calibration &c, const SolidErrors::Runs &runs) {
  const StoredRun *hardest = nullptr;
  for (const StoredRun *run : runs)
    if (c.facts.at(run->folder).rung && !run->impacts.empty() &&
        (!hardest || run->approach_speed() > hardest->approach_speed()))
      hardest = run;
  return hardest;
}

} // namespace

SolidErrors::SolidErrors(const Calibration &c, const Answer &answer, const Runs &runs,
                         const std::vector<StoredStudy> &studies)
    : c_(c), answer_(answer), runs_(runs), studies_(studies), hardest_(hardest_of(c, runs)) {}

void SolidErrors::add_to(ErrorParts &parts) const {
  of_mesh(parts), of_step(parts), of_rung(parts), of_energy(parts), of_steel(parts), of_geometry(parts);
}

template <class Find> std::optional<Finding> SolidErrors::found_by(Find find) const {
  if (!hardest_) return {};
  return find(*hardest_, c_.facts.at(hardest_->folder));
}

bool SolidErrors::all_by(scene::Rung rung) const {
  return answer_.rungs == std::vector<std::string>{word(solved_by(rung))};
}

void SolidErrors::of_mesh(ErrorParts &parts) const {
  const AnswerMeshError &mesh = answer_.mesh_error;
  const auto part = [&](const std::optional<double> &value, const std::vector<ErrorAt> &by) {
    return ErrorPart{.value = value, .how = Known::measured, .from = mesh.sentence, .by = by, .find = mesh.find};
  };
  parts.add(Erring::peak_force, ErrorSource::mesh, part(mesh.peak_force, mesh.by_peak_force));
  parts.add(Erring::rebound, ErrorSource::mesh, part(mesh.rebound, mesh.by_rebound));
  if (!answer_.strain) return;
  const int coarsest = answer_.meshes.empty() ? 0 : answer_.meshes.front(); // by growing number
  parts.add(Erring::strain, ErrorSource::mesh,
            {.value = coarsest == 0 ? averaged_strain_mesh_0 : averaged_strain_mesh_1,
             .how = Known::transferred,
             .from = "the rim's steel of shfps-225 on meshes 0 to 2 (docs/results/refinement.md)"});
}

void SolidErrors::add_kept(ErrorParts &parts, ErrorSource source, const std::vector<KeptError> &kept,
                           const std::optional<Finding> &find, const std::string &none) const {
  ErrorPart force{.value = {}, .from = none, .find = find}, rebound = force, depth = force;
  const auto take = [&](ErrorPart &part, const KeptError &at, double value) {
    part.by.push_back({at.load, at.speed, at.deep, value});
    if (part.value.value_or(-1) >= value) return;
    part.value = value, part.from = at.from, part.how = at.same_rim ? Known::measured : Known::transferred;
  };
  for (const KeptError &at : kept) {
    take(force, at, at.peak_force), take(rebound, at, at.rebound);
    take(depth, at, at.depth.value_or(at.peak_force)); // by the energy stored, where it was not kept
  }
  parts.add(Erring::peak_force, source, force), parts.add(Erring::rebound, source, rebound);
  parts.add(Erring::depth, source, depth);
}

void SolidErrors::of_step(ErrorParts &parts) const {
  if (!hardest_) return add_kept(parts, ErrorSource::step, {}, {}, "no run hits the rim");
  const auto kept = step_errors(studies_, hardest_->scene, answer_.rim_identity);
  const auto &model = hardest_->scene.model;
  const bool as_halved =
      all_by(scene::Rung::rim) && model.mesh >= 1 && (model.step > 0 ? model.step : planned_step) <= planned_step;
  if (!kept.empty() || !as_halved)
    return add_kept(parts, ErrorSource::step, kept, found_by(find_step), "no study halves the step");
  const auto part = [](double value) {
    return ErrorPart{.value = value,
                     .how = Known::transferred,
                     .from = "the step halved in windows of shfps-225 at 0.1 and 0.5 m/s (docs/results/refinement.md)"};
  };
  parts.add(Erring::peak_force, ErrorSource::step, part(step_halved_force));
  parts.add(Erring::rebound, ErrorSource::step, part(step_halved_rebound));
}

void SolidErrors::of_rung(ErrorParts &parts) const {
  if (all_by(scene::Rung::full)) {
    for (const Erring quantity : of_impacts)
      parts.add(quantity, ErrorSource::rung, no_error("rung full models the whole bearing"));
    return;
  }
  std::vector<KeptError> all;
  for (const std::string &rung : answer_.rungs)
    for (KeptError &each : rung_errors(studies_, rung, answer_.scene.bearing)) all.push_back(std::move(each));
  add_kept(parts, ErrorSource::rung, all, found_by(find_rung), "no study has rung full beside it");
}

void SolidErrors::of_energy(ErrorParts &parts) const {
  const auto part = [&](auto error) {
    ErrorPart worst{.value = {}, .how = Known::measured, .from = "energy of the runs that nothing accounts for"};
    for (const StoredRun *run : runs_) {
      if (run->impacts.empty()) continue;
      const double value = error(std::abs(c_.facts.at(run->folder).imbalance), run->impacts.front().impact);
      if (!std::isfinite(value)) continue;
      worst.by.push_back({load_of(runs_, run->folder), run->approach_speed(), depth_of(runs_, run->folder), value});
      worst.value = std::max(worst.value.value_or(0), value);
    }
    return worst;
  };
  parts.add(Erring::peak_force, ErrorSource::energy, part([](double share, const Impact &) { return share / 2; }));
  parts.add(Erring::depth, ErrorSource::energy, part([](double share, const Impact &) { return share; }));
  parts.add(Erring::rebound, ErrorSource::energy, part([](double share, const Impact &hit) {
              const double e = hit.restitution();
              return e > 0 ? share / (2 * e * e) : NAN;
            }));
}

void SolidErrors::of_steel(ErrorParts &parts) const {
  if (answer_.steel_band) return of_band(parts, *answer_.steel_band);
  const auto both = [&](std::optional<double> force, std::optional<double> rebound, const std::string &from) {
    parts.add(Erring::peak_force, ErrorSource::steel, {.value = force, .how = Known::transferred, .from = from});
    parts.add(Erring::rebound, ErrorSource::steel, {.value = rebound, .how = Known::transferred, .from = from});
  };
  if (const auto &steel = answer_.scene.bearing.rim_steel(); steel.knows_rate())
    both({}, {}, fmt::format("the constants of its rate, {}: no run varies them", in_words(steel.rate)));
  else
    both(rate_of_mild_steel_force, rate_of_mild_steel_rebound,
         "steel as fast as mild steel's (D 40 1/s, q 5) on shfps-225, by an explicit program");
}

void SolidErrors::of_band(ErrorParts &parts, const SteelBand &band) const {
  const std::string from = fmt::format("windows of this rim without and with {}{}", in_words(band.rate),
                                       band.assumed ? ", constants of mild steel" : "");
  const auto add = [&](Erring quantity, double (SteelTwin::*ratio)() const) {
    ErrorPart part{
        .value = band.largest(ratio), .how = band.assumed ? Known::transferred : Known::measured, .from = from};
    for (const SteelTwin &twin : band.twins)
      part.by.push_back({word(scene::ExcitationKind::window), twin.speed, twin.static_steel.peak_penetration,
                         std::abs((twin.*ratio)() - 1)});
    parts.add(quantity, ErrorSource::steel, part);
  };
  add(Erring::peak_force, &SteelTwin::force_ratio), add(Erring::depth, &SteelTwin::depth_ratio);
  add(Erring::rebound, &SteelTwin::rebound_ratio);
}

void SolidErrors::of_geometry(ErrorParts &parts) const {
  auto assumed = scene::assumptions(answer_.scene.bearing);
  std::erase_if(assumed, [&](const scene::Assumption &each) {
    return !takes_part(each.key, all_by(scene::Rung::rim) ? scene::Rung::rim : scene::Rung::full);
  });
  ErrorPart part = no_error("no number of the bearing that takes part is an assumption");
  if (!assumed.empty())
    part = {.value = {},
            .from = fmt::format("{} numbers of the bearing that take part are assumptions", assumed.size()),
            .find = found_by(
                [&](const StoredRun &run, const RunFacts &facts) { return find_geometry(run, facts, assumed); })};
  parts.add(Erring::peak_force, ErrorSource::geometry, part), parts.add(Erring::rebound, ErrorSource::geometry, part);
}

std::string load_of(const SolidErrors::Runs &runs, const std::string &folder) {
  for (const StoredRun *run : runs)
    if (run->folder == folder) return word(run->scene.excitation.kind);
  return "unknown";
}

std::optional<double> depth_of(const SolidErrors::Runs &runs, const std::string &folder) {
  std::optional<double> deepest;
  for (const StoredRun *run : runs)
    if (run->folder == folder)
      for (const auto &w : run->impacts) deepest = std::max(deepest.value_or(0), w.impact.peak_penetration);
  return deepest;
}

} // namespace rimpact::calibration
