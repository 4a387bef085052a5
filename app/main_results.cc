#include "app/main_results.h"

#include "app/comparison.h"
#include "app/job_runner.h"
#include "calibration/calibration_json.h"
#include "reduced_models/pad_on_dish.h"
#include "reduced_models/physical_model.h"
#include <filesystem>
#include <fstream>
#include <optional>
#include <sys/utsname.h>
#include <thread>

namespace rimpact::app {
namespace {

using nlohmann::json;

void run_reduced(const scene::Scene &scene, const std::string &folder) {
  const auto run = reduced::simulate(scene);
  scene::write_run_folder(folder, scene, run.response, run.summary);
}

scene::Scene with_pair(scene::Scene scene, double k_i, double e) {
  scene.reduced.k_i = k_i;
  scene.reduced.restitution = e;
  return scene;
}

/// The fit of the law that leaves least unexplained, where it is another than the pair's.
const calibration::FitResult *best_law(const calibration::Calibration &fitted) {
  if (fitted.laws.rows.empty()) return nullptr;
  const auto &best = fitted.laws.rows.front().result;
  return best.law == fitted.result.law ? nullptr : &best;
}

json critical_amplitudes(const std::vector<Job> &jobs) {
  json result = json::array();
  for (const auto &job : jobs) {
    if (job.role != "predict") continue;
    json row{{"scene", job.name}, {"printed_g", job.scene.excitation.amplitude_g}};
    scene::Scene stack = job.scene;
    reduced::add_stack_terms(stack);
    for (const auto &[key, scene] :
         {std::pair{"reduced_g", &job.scene}, {"reduced_with_pad_and_socket_g", &stack}}) {
      const auto scale = reduced::critical_scale(*scene);
      row[key] = scale ? json(*scale * job.scene.excitation.amplitude_g) : json();
    }
    result.push_back(row);
  }
  return result;
}

json machine() {
  std::string processor = "unknown processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) {
      processor = line.substr(line.find(':') + 2);
      break;
    }
  utsname system{};
  uname(&system);
  return {{"processor", processor},
          {"cores", std::thread::hardware_concurrency()},
          {"system", std::string(system.sysname) + " " + system.release}};
}

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
    else if (job.role == "predict")
      s.options.predict.push_back(job.folder);
    else if (summary_of(job.folder).value("n_impacts", 0) == 0)
      s.warnings.push_back(job.name + ": the rim is never touched, so nothing is fitted to this run");
    else
      s.fit.push_back(job.folder);
  return s;
}

/// Reduced runs beside the finite-element ones: with the fitted pair and the best law when there are, and with the published pair.
json reduced_runs(const std::vector<Job> &jobs, const std::string &folder,
                  const std::optional<calibration::Calibration> &fitted) {
  json runs = json::array();
  for (const char *earlier : {"/reduced", "/law"}) std::filesystem::remove_all(folder + earlier); // another calibration's
  const calibration::FitResult *law = fitted ? best_law(*fitted) : nullptr;
  for (const auto &job : jobs) {
    if (job.done && fitted)
      run_reduced(with_pair(job.scene, fitted->scene.reduced.k_i, fitted->scene.reduced.restitution), folder + "/reduced/" + job.name);
    if (job.done && law) run_reduced(calibration::with_fitted(job.scene, *law), folder + "/law/" + job.name);
    if (job.done)
      run_reduced(with_pair(job.scene, calibration::published_k_i, calibration::published_e), folder + "/published/" + job.name);
    runs.push_back({{"name", job.name},
                    {"role", job.role},
                    {"fe", "runs/" + job.name},
                    {"reduced", "reduced/" + job.name},
                    {"law", law ? json("law/" + job.name) : json()},
                    {"published", "published/" + job.name},
                    {"reused", job.reused}});
  }
  return runs;
}

} // namespace

MainResults make_results(const std::vector<Job> &jobs, const std::string &folder, const json &versions,
                         double seconds, const std::vector<std::string> &laws, Console &console) {
  Selection selection = select(jobs);
  selection.options.laws = laws;
  for (const auto &job : jobs)
    if (job.done && summary_of(job.folder).value("n_impacts", 0) == 0)
      console.warn(job.name + ": the rim is never touched");
  if (selection.fit.empty() && selection.options.predict.empty())
    throw SolverStopped("no run of the main job ended well; see " + folder + "/runs/*.log");

  MainResults results;
  std::optional<calibration::Calibration> fitted;
  try {
    if (selection.fit.empty()) throw DataError("no run that touches the rim is left to fit");
    fitted = calibration::calibrate(selection.fit, selection.options);
    calibration::write_calibration(*fitted, folder + "/calibration");
    results.text = calibration::describe(*fitted);
    calibration::check_gate(*fitted);
  } catch (const Error &error) { // the runs are still worth a table and a report
    results.failure = std::current_exception();
    console.warn(std::string("calibration: ") + error.what());
  }
  if (!fitted)
    std::filesystem::remove_all(folder + "/calibration"); // an earlier one would belong to other runs
  const json runs = reduced_runs(jobs, folder, fitted), rows = comparison_rows(jobs, folder);
  results.text += comparison_text(rows);
  long memory = 0;
  for (const auto &job : jobs)
    memory = std::max(memory, summary_of(job.folder).value("peak_memory_bytes", 0L));
  results.main = {{"runs", runs},
                  {"comparison", rows},
                  {"critical_amplitudes", critical_amplitudes(jobs)},
                  {"totals", {{"wall_time_s", seconds}, {"peak_memory_bytes", memory}}},
                  {"versions", versions},
                  {"machine", machine()},
                  {"warnings", selection.warnings}};
  if (fitted) results.main["parameters"] = calibration::to_json(*fitted)["parameters"];
  scene::write_text(results.main.dump(2) + "\n", folder + "/main.json");
  return results;
}

} // namespace rimpact::app
