#include "app/jobs/main_results.h"

#include "app/jobs/answer_law.h"
#include "app/jobs/comparison.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/steel_twins.h"
#include "calibration/answer/answer.h"
#include "calibration/answer/answer_json.h"
#include "calibration/answer/answer_text.h"
#include "calibration/answer/calibration_json.h"
#include "calibration/answer/calibration_text.h"
#include "fe_contact/planning/machine_times.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "responses/limits.h"
#include "responses/run_folder.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <sys/utsname.h>
#include <thread>

namespace rimpact::app {
namespace {

using nlohmann::json;

void run_reduced(const scene::Scene &scene, const std::string &folder) {
  auto run = reduced::simulate(scene);
  judge(scene, run.summary);
  write_run_folder(folder, scene, run.response, run.summary);
}

json critical_amplitudes(const std::vector<Job> &jobs) {
  json result = json::array();
  for (const auto &job : jobs) {
    if (job.role != JobRole::predict || job.scene.excitation.kind != scene::ExcitationKind::ricker) continue;
    json row{{"scene", job.name}, {"printed_g", job.scene.excitation.amplitude_g}};
    scene::Scene stack = job.scene;
    reduced::add_stack_terms(stack);
    for (const auto &[key, scene] : {std::pair{"reduced_g", &job.scene}, {"reduced_with_pad_and_socket_g", &stack}}) {
      if (scene == &stack && !stack.bearing.has_pad()) continue;
      const auto scale = reduced::critical_scale(*scene);
      row[key] = scale ? json(*scale * job.scene.excitation.amplitude_g) : json();
    }
    result.push_back(row);
  }
  return result;
}

json machine() {
  utsname system{};
  uname(&system);
  return {{"processor", planning::processor_name()},
          {"cores", std::thread::hardware_concurrency()},
          {"system", std::string(system.sysname) + " " + system.release}};
}

using Answered = std::shared_ptr<const calibration::Answer>; ///< null: nothing was fitted

/// Which runs to fit and which to predict; what is left out is said in `warnings`.
struct Selection {
  std::vector<std::string> fit;
  calibration::CalibrationOptions options;
  json warnings = json::array();
};
Selection select(const std::vector<Job> &jobs) {
  Selection s;
  for (const auto &job : jobs)
    if (!job.done)
      s.warnings.push_back(job.name + ": " + job.failure);
    else if (job.role == JobRole::twin)
      continue; // beside the law
    else if (job.role == JobRole::predict)
      s.options.predict.push_back(job.folder);
    else if (summary_of(job.folder).value("n_impacts", 0) == 0)
      s.warnings.push_back(job.name + ": the rim is never touched, so nothing is fitted to this run");
    else
      s.fit.push_back(job.folder);
  return s;
}

/// Which reduced runs there are, by the answer: without a calibration none but the published pair's.
Columns columns_of(const MainTarget &target, const Answered &answer, const std::string &law) {
  Columns columns{.law = law};
  if (answer && answer->pair) {
    const auto &pair = answer->pair->result.parameters;
    columns.pair = fmt::format("{:.3g}, {:.3g}", pair.at("k_i").value, pair.at("e").value);
  }
  if (scene::published_pair_applies(target.scene))
    columns.published = fmt::format("{:.2g}, {:g}", calibration::published_k_i / 1e3, calibration::published_e);
  return columns;
}

scene::Scene with_published(scene::Scene scene) {
  scene.reduced.impact_law = scene::ReducedSettings{}.impact_law;
  scene.reduced.k_i = calibration::published_k_i;
  scene.reduced.restitution = calibration::published_e;
  return scene;
}

/// Reduced runs beside the finite-element ones: DIR/law with the answer's law, DIR/reduced with the pair, else the law,
/// and DIR/published where that pair belongs to this bearing and mass.
json reduced_runs(const std::vector<Job> &jobs, const std::string &folder, const Answered &answer,
                  const Columns &columns) {
  json runs = json::array();
  for (const char *earlier : {"/reduced", "/law", "/published"})
    std::filesystem::remove_all(folder + earlier); // of another calibration
  const auto under = [&](const std::string &column, const char *part, const std::string &name) {
    return column.empty() ? json() : json(part + name);
  };
  for (const auto &job : jobs) {
    if (job.done && !columns.law.empty()) {
      scene::Scene law = with_answer(job.scene, folder + "/calibration");
      if (!has_dish(job.scene.model.rung)) // the run it stands beside has no pad to bounce on
        law.reduced.normal_force = job.scene.reduced.normal_force;
      run_reduced(law, folder + "/law/" + job.name);
      run_reduced(columns.pair.empty() ? law : with_pair(job.scene, *answer->pair), folder + "/reduced/" + job.name);
    }
    if (job.done && !columns.published.empty())
      run_reduced(with_published(job.scene), folder + "/published/" + job.name);
    runs.push_back({{"name", job.name},
                    {"role", word(job.role)},
                    {"fe", "runs/" + job.name},
                    {"reduced", "reduced/" + job.name},
                    {"law", under(columns.law, "law/", job.name)},
                    {"published", under(columns.published, "published/", job.name)},
                    {"reused", job.reused}});
  }
  return runs;
}

json column_titles(const Columns &columns) {
  const auto title = [](const std::string &text) { return text.empty() ? json() : json(text); };
  return {{"fitted", title(columns.law)}, {"pair", title(columns.pair)}, {"published", title(columns.published)}};
}

/// The law of all runs, with the band of the steel's two laws, into DIR/calibration.
calibration::Calibration fit_law(const MainTarget &target, const std::vector<Job> &all, Selection selection,
                                 const std::string &folder, Console &console) {
  if (selection.fit.empty()) throw DataError("no run that touches the rim is left to fit");
  selection.options.steel_band = steel_band(target, all);
  calibration::Calibration fitted = calibration::calibrate(selection.fit, selection.options);
  std::filesystem::remove_all(folder + "/calibration"); // of other runs
  if (selection.options.steel_band) {
    calibration::Answer answer = *fitted.answer;
    fit_twins(all, answer.law.result.law, folder + "/calibration", *answer.steel_band, console);
    fitted.answer = std::make_shared<const calibration::Answer>(std::move(answer));
  }
  calibration::write_calibration(fitted, folder + "/calibration");
  return fitted;
}

} // namespace

MainResults make_results(const MainTarget &target, const std::vector<Job> &all, const MainContext &context,
                         Console &console) {
  const std::string &folder = context.folder;
  const std::vector<Job> jobs = without_twins(all);
  Selection selection = select(all);
  selection.options.laws = context.laws;
  for (const auto &job : jobs)
    if (job.done && summary_of(job.folder).value("n_impacts", 0) == 0)
      console.warn(job.name + ": the rim is never touched");
  if (selection.fit.empty() && selection.options.predict.empty())
    throw SolverStopped("no run of the main job ended well; see " + folder + "/logs/*.log");

  MainResults results;
  std::optional<calibration::Calibration> fitted;
  Answered answer;
  try {
    fitted = fit_law(target, all, selection, folder, console);
    answer = fitted->answer;
    console.detail(calibration::describe(*fitted));
    calibration::check_gate(*fitted);
  } catch (const Error &error) { // the runs are still worth a table and a report
    results.failure = std::current_exception();
    console.warn(std::string("calibration: ") + error.what());
  }
  if (!fitted) std::filesystem::remove_all(folder + "/calibration"); // an earlier one would belong to other runs
  const std::string law = fitted ? with_answer(target.scene, folder + "/calibration").reduced.impact_law->name : "";
  const Columns columns = columns_of(target, answer, law);
  const json runs = reduced_runs(jobs, folder, answer, columns), rows = comparison_rows(jobs, folder, columns);
  results.text = target.head() + (answer ? calibration::describe(*answer) : "") +
                 comparison_text(rows, columns, answer ? answer->doubts : std::vector<std::string>());
  json warnings = context.warnings;
  for (const auto &warning : selection.warnings) warnings.push_back(warning);
  for (const auto &row : rows)
    for (const auto &doubt : row["doubts"])
      warnings.push_back(row["name"].get<std::string>() + ": " + doubt.get<std::string>());
  long memory = 0;
  for (const auto &job : jobs) memory = std::max(memory, summary_of(job.folder).value("peak_memory_bytes", 0L));
  results.main = {{"bearing", target.bearing_json()},
                  {"load", target.load_json()},
                  {"document", context.document},
                  {"runs", runs},
                  {"comparison", rows},
                  {"columns", column_titles(columns)},
                  {"critical_amplitudes", critical_amplitudes(jobs)},
                  {"totals", {{"wall_time_s", context.seconds}, {"peak_memory_bytes", memory}}},
                  {"versions", context.versions},
                  {"machine", machine()},
                  {"warnings", warnings},
                  {"until", context.until}};
  if (fitted) results.main["parameters"] = calibration::to_json(*fitted)["parameters"];
  if (answer) results.main["answer"] = calibration::to_json(*answer);
  write_atomically(json_text(results.main), folder + "/main.json");
  return results;
}

} // namespace rimpact::app
