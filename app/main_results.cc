#include "app/main_results.h"

#include "calibration/calibration_json.h"
#include "reduced_models/physical_model.h"
#include "scene/summary.h"
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <sys/utsname.h>
#include <thread>

namespace rimpact::app {
namespace {

/// Runs a scene by the reduced model with a pair (k_i, e) into a folder.
scene::Summary run_reduced(const Job &job, double k_i, double e, const std::string &folder) {
  scene::Scene scene = job.scene;
  scene.reduced.k_i = k_i;
  scene.reduced.restitution = e;
  const auto run = reduced::simulate(scene);
  scene::write_run_folder(folder, scene, run.response, run.summary);
  return run.summary;
}

nlohmann::json critical_amplitudes(const std::vector<Job> &jobs) {
  nlohmann::json result = nlohmann::json::array();
  for (const auto &job : jobs) {
    if (job.role != "predict") continue;
    nlohmann::json row{{"scene", job.name}, {"printed_g", job.scene.excitation.amplitude_g}};
    scene::Scene stack = job.scene;
    stack.reduced.finite_pad = stack.reduced.socket_friction = true;
    for (const auto &[key, scene] :
         {std::pair{"reduced_g", &job.scene}, {"reduced_with_pad_and_socket_g", &stack}}) {
      const auto scale = reduced::critical_scale(*scene);
      row[key] = scale ? nlohmann::json(*scale * job.scene.excitation.amplitude_g) : nlohmann::json();
    }
    result.push_back(row);
  }
  return result;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

nlohmann::json machine() {
  utsname system{};
  uname(&system);
  return {{"processor", processor()},
          {"cores", std::thread::hardware_concurrency()},
          {"system", std::string(system.sysname) + " " + system.release}};
}

std::string percent(const nlohmann::json &value) {
  return value.is_number() ? fmt::format("{:+.1f} %", 100 * value.get<double>()) : "-";
}

/// Comparison of each history with the reduced model run from rest, fitted and published pair.
std::string comparison_table(const std::vector<Job> &jobs, const std::string &folder, nlohmann::json &rows) {
  std::string text = fmt::format("{:26s} {:>12s} {:>9s} {:>9s}   {:>11s} {:>9s} {:>9s}   {:>11s} {:>9s}\n",
                                 "peak impact force", "FE [kN]", "in [m/s]", "out/in", "fitted [kN]", "error",
                                 "rebound", "4.5e5, 0.65", "error");
  const auto summary_of = [](const std::string &path) {
    std::ifstream file(path + "/summary.json");
    return nlohmann::json::parse(file, nullptr, false);
  };
  for (const auto &job : jobs) {
    if (!job.done) continue;
    const auto fe = summary_of(job.folder), fitted = summary_of(folder + "/reduced/" + job.name),
               published = summary_of(folder + "/published/" + job.name);
    const auto force = [](const nlohmann::json &s) {
      return s["peak_impact_force_N"].is_number() ? 1e-3 * s["peak_impact_force_N"].get<double>() : 0.0;
    };
    const auto relative = [&](const nlohmann::json &s) {
      return force(fe) > 0 ? nlohmann::json(force(s) / force(fe) - 1) : nlohmann::json();
    };
    const auto hardest = [](const nlohmann::json &s, const char *key) {
      double best = -1;
      nlohmann::json value;
      for (const auto &impact : s["impacts"])
        if (impact["peak_force_N"].get<double>() > best) best = impact["peak_force_N"], value = impact[key];
      return value;
    };
    const auto speed = hardest(fe, "approach_speed_m_s"), out = hardest(fe, "restitution"),
               reduced_out = hardest(fitted, "restitution");
    const auto rebound = out.is_number() && reduced_out.is_number()
                             ? nlohmann::json(reduced_out.get<double>() / out.get<double>() - 1)
                             : nlohmann::json();
    rows.push_back({{"name", job.name},
                    {"role", job.role},
                    {"fe_kN", force(fe)},
                    {"fitted_kN", force(fitted)},
                    {"published_kN", force(published)},
                    {"approach_speed_m_s", speed},
                    {"rebound_over_approach", out},
                    {"fitted_error", relative(fitted)},
                    {"published_error", relative(published)},
                    {"fitted_rebound_error", rebound}});
    text += fmt::format(
        "{:26s} {:12.1f} {:>9s} {:>9s}   {:11.1f} {:>9s} {:>9s}   {:11.1f} {:>9s}\n", job.name, force(fe),
        speed.is_number() ? fmt::format("{:.3f}", speed.get<double>()) : "-",
        out.is_number() ? fmt::format("{:.3f}", out.get<double>()) : "-", force(fitted),
        percent(relative(fitted)), percent(rebound), force(published), percent(relative(published)));
  }
  return text;
}

} // namespace

std::string make_results(const std::vector<Job> &jobs, const std::string &folder, double seconds,
                         Console &console) {
  std::vector<std::string> fit;
  calibration::CalibrationOptions options;
  nlohmann::json warnings = nlohmann::json::array();
  for (const auto &job : jobs) {
    if (!job.done)
      warnings.push_back(job.name + ": " + job.failure);
    else if (job.role == "predict")
      options.predict.push_back(job.folder);
    else if (job.role != "push")
      fit.push_back(job.folder);
  }
  if (fit.empty()) throw SolverStopped("no run of the main job ended well; see " + folder + "/runs/*.log");
  const auto calibration = calibration::calibrate(fit, options);
  calibration::write_calibration(calibration, folder + "/calibration");
  const double k_i = calibration.scene.reduced.k_i, e = calibration.scene.reduced.restitution;

  nlohmann::json runs = nlohmann::json::array(), rows = nlohmann::json::array();
  long memory = 0;
  for (const auto &job : jobs) {
    if (job.done) {
      run_reduced(job, k_i, e, folder + "/reduced/" + job.name);
      run_reduced(job, calibration::published_k_i, calibration::published_e,
                  folder + "/published/" + job.name);
      std::ifstream file(job.folder + "/summary.json");
      const auto summary = nlohmann::json::parse(file, nullptr, false);
      memory = std::max(memory, summary.value("peak_memory_bytes", 0L));
    }
    runs.push_back({{"name", job.name},
                    {"role", job.role},
                    {"fe", "runs/" + job.name},
                    {"reduced", "reduced/" + job.name},
                    {"published", "published/" + job.name},
                    {"reused", job.reused}});
  }
  const std::string table = comparison_table(jobs, folder, rows);
  const nlohmann::json main{{"runs", runs},
                            {"comparison", rows},
                            {"critical_amplitudes", critical_amplitudes(jobs)},
                            {"totals", {{"wall_time_s", seconds}, {"peak_memory_bytes", memory}}},
                            {"versions", {{"rimpact", RIMPACT_VERSION}}},
                            {"machine", machine()},
                            {"warnings", warnings}};
  scene::write_text(main.dump(2) + "\n", folder + "/main.json");
  console.message(calibration::describe(calibration));
  calibration::check_gate(calibration);
  return table;
}

} // namespace rimpact::app
