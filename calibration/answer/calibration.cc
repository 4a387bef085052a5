#include "calibration/answer/answer.h"
#include "calibration/answer/calibration_check.h"
#include "calibration/data/measured_name.h"
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <tuple>

namespace rimpact::calibration {

namespace {

std::vector<StoredRun> read_runs(const std::vector<std::string> &folders, const WindowOptions &options) {
  std::vector<StoredRun> runs;
  runs.reserve(folders.size());
  for (const auto &folder : folders) runs.push_back(read_run(folder, options));
  return runs;
}

std::vector<const StoredRun *> pointers(const std::vector<StoredRun> &runs) {
  std::vector<const StoredRun *> all;
  for (const auto &run : runs) all.push_back(&run);
  return all;
}

/// What the runs say of themselves; their doubts travel.
void collect_facts(const std::vector<StoredRun> &runs, Calibration &c) {
  for (const auto &run : runs) {
    const RunFacts &facts = c.facts[run.folder] = run_facts(run.folder);
    for (const auto &warning : facts.warnings) c.doubts.push_back(facts.name + ": " + warning);
    for (const auto &doubt : run.doubts) c.doubts.push_back(facts.name + ": " + doubt);
    for (const auto &sentence : run.noise) c.notes.push_back(facts.name + ": " + sentence);
  }
}

/// Every run to fit must have something to fit: an impact, unless the flight informs on every parameter.
void require_impacts(const std::vector<StoredRun> &runs, const FitOptions &options) {
  if (std::all_of(options.parameters.begin(), options.parameters.end(),
                  [](const std::string &name) { return parameter(name).seen_in_flight; }))
    return;
  for (const auto &run : runs) {
    if (!run.impacts.empty()) continue;
    if (!run.notes.empty())
      throw DataError(fmt::format("{}: no impact can be fitted: {}", run.folder, run.notes.front()));
    throw DataError(
        fmt::format("{}: the rim is never touched (travel {:.4g} m of L_c {:.4g} m), so there is nothing to fit",
                    run.folder, run.summary.peak_displacement, run.scene.bearing.lateral_capacity()));
  }
}

std::vector<const StoredRun *> select(const std::vector<StoredRun> &runs, bool windows) {
  std::vector<const StoredRun *> selected;
  for (const auto &run : runs)
    if (run.is_window() == windows) selected.push_back(&run);
  return selected;
}

/// One report for each pulse among the runs, at its printed amplitude (scale 1).
std::vector<GrazingReport> grazing_reports(const std::vector<const std::vector<StoredRun> *> &sets,
                                           const FitResult &result) {
  std::vector<GrazingReport> reports;
  std::set<std::tuple<double, double, double>> seen;
  for (const auto *runs : sets)
    for (const auto &run : *runs) {
      const auto &x = run.scene.excitation;
      if (x.kind != scene::ExcitationKind::ricker || !seen.insert({x.amplitude_g, x.period, x.direction_deg}).second)
        continue;
      auto scene = with_fitted(run.scene, result);
      scene.name = fmt::format("ricker-{:g}g-{:.1f}s", x.amplitude_g, x.period);
      scene.excitation.scale = 1.0;
      reports.push_back(grazing_report(scene));
    }
  return reports;
}

/// The laws on every run to fit; what is fitted beside a law's own parameters stays at its fitted value.
void rank(const std::vector<StoredRun> &runs, const CalibrationOptions &options, Calibration &c) {
  if (options.laws.empty()) return;
  const auto every = pointers(runs);
  FitOptions own = options.fit;
  for (const auto &[name, estimate] : c.result.parameters)
    if (!of_a_law(name)) own.fixed[name] = estimate.value;
  c.laws = rank_laws(every, options.laws, own, c.notes);
  c.pair_range = pair_range(every, own);
}

/// Each note names the law that was fitted by itself: it need not be the answer's.
void note_outcome(Calibration &c) {
  const auto note = [&](const std::string &said) {
    c.notes.push_back(fmt::format("law {} fitted by itself: {}", c.result.law, said));
  };
  for (const auto &[name, estimate] : c.result.parameters)
    if (!estimate.identifiable) note(fmt::format("{} is not identifiable: {}", name, estimate.reason));
  if (!c.result.converged) note("it did not converge: " + c.result.message);
  if (c.result.n_starts_agreeing < c.result.n_starts)
    note(fmt::format("{} of {} starts ended at the best minimum", c.result.n_starts_agreeing, c.result.n_starts));
  for (const auto &said : c.result.notes) note(said);
}

/// Fits what the law reads, less what is held. A law of a push has no parameters: the default law is fitted instead.
FitOptions of_the_law(FitOptions fit, const scene::Scene &scene) {
  if (fit.law.empty() && scene.reduced.impact_law->parameters.empty()) fit.law = laws::default_law().name;
  fit.parameters = fit.law.empty() ? scene.reduced.impact_law->parameters : laws::impact_law(fit.law).parameters;
  for (const auto &[name, value] : fit.fixed) std::erase(fit.parameters, name);
  return fit;
}

} // namespace

Calibration calibrate(const std::vector<std::string> &run_folders, const CalibrationOptions &given) {
  CalibrationOptions options = given;
  options.window.validate();
  options.fit.validate_words();
  if (run_folders.empty()) throw InputError("no run folder to calibrate on is named");
  const auto names = each_test(run_folders);
  require_distinct(names);
  Calibration c;
  auto runs = read_runs(names, options.window);
  if (options.fit.parameters.empty()) options.fit = of_the_law(options.fit, runs.front().scene);
  options.fit.validate();
  auto predicted = read_runs(each_test(options.predict), options.window);
  collect_facts(runs, c), collect_facts(predicted, c);
  const auto screened = screen(runs, c.facts, options.fit.uncertainty, options.keep_stopped);
  c.doubts.insert(c.doubts.end(), screened.begin(), screened.end());
  c.notes.insert(c.notes.end(), screened.begin(), screened.end());
  auto all = runs;
  all.insert(all.end(), predicted.begin(), predicted.end());
  require_same_device(all);
  require_distinct(runs);
  require_impacts(runs, options.fit);

  const auto windows = select(runs, true), histories = select(runs, false);
  c.fitted_on = histories.empty() ? FittedOn::windows : FittedOn::histories;
  const auto &fitted = histories.empty() ? windows : histories;
  c.result = fit(fitted, options.fit);
  c.scene = with_fitted(fitted.front()->scene, c.result);
  for (const StoredRun *run : fitted) c.fit[run->folder] = check_run(*run, c.result, options.fit, true);
  for (const auto &run : predicted) c.prediction[run.folder] = check_run(run, c.result, options.fit, false);
  if (!windows.empty()) c.windows = windows_table(windows, c.result, options.fit, options.validity_tolerance);
  if (!windows.empty() && !histories.empty())
    c.notes.push_back(fmt::format("{} window(s) are not in the fit, which is on whole histories; each is fitted by "
                                  "itself for k_i and e over speed, and the laws are ranked on all",
                                  windows.size()));
  if (c.windows) c.speed_laws = speed_laws(*c.windows);
  if (options.profiles && options.fit.parameters.size() > 1)
    for (const auto &name : options.fit.parameters) c.profiles[name] = profile_of(fitted, options.fit, c.result, name);
  rank(runs, options, c);
  if (options.grazing_reports) c.grazing = grazing_reports({&runs, &predicted}, c.result);
  note_outcome(c);
  c.answer = std::make_shared<Answer>(make_answer(c, options, pointers(runs)));
  c.curves = impact_curves(runs, predicted, c.answer->law.result);
  return c;
}

void check_gate(const Calibration &calibration) {
  if (!calibration.result.converged) throw GateError("the calibration did not converge: " + calibration.result.message);
}

} // namespace rimpact::calibration
