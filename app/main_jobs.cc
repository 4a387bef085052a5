#include "app/main_jobs.h"

#include "app/progress.h"
#include "app/sibling.h"
#include "scene/response.h"
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace rimpact::app {
namespace {

std::string read_text(const std::string &path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

bool is_done(const Job &job) {
  const auto summary = nlohmann::json::parse(read_text(job.folder + "/summary.json"), nullptr, false);
  return !summary.is_discarded() && summary.value("status", "") == "done" &&
         read_text(job.folder + "/scene.toml") == scene::to_toml(job.scene);
}

/// The sentence a failed run left: its summary's reason, else the last line of its log.
std::string failure_of(const Job &job, int code) {
  const auto summary = nlohmann::json::parse(read_text(job.folder + "/summary.json"), nullptr, false);
  if (!summary.is_discarded() && summary.contains("reason") && summary["reason"].is_string())
    return summary["reason"];
  std::string line, last;
  for (std::istringstream log(read_text(job.folder + ".log")); std::getline(log, line);)
    if (!line.empty()) last = line;
  return last.empty() ? fmt::format("ended with exit code {}", code) : last;
}

struct Child {
  pid_t process;
  Job *job;
};

void stop(std::vector<Child> &children) {
  for (const auto &child : children) kill(child.process, SIGTERM); // each writes its checkpoint
  for (const auto &child : children) poll(child.process, true);
  throw Interrupted();
}

pid_t launch(const Job &job, bool share_cores) {
  const std::string scene_file = job.folder + ".toml";
  scene::write_text(scene::to_toml(job.scene), scene_file);
  std::vector<std::string> environment;
  if (share_cores) environment = {"OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1", "RIMPACT_THREADS=1"};
  return start({sibling("rimpact-fe"), "run", scene_file, "-o", job.folder, "--quiet"}, job.folder + ".log",
               environment);
}

} // namespace

std::vector<Job> main_jobs(const scene::Bearing &bearing, const std::string &folder) {
  std::vector<Job> jobs;
  const auto add = [&](const std::string &name, const std::string &role, const std::string &scene,
                       const std::string &override) {
    Job job{name, role, scene::load_scene(scene, {override}), folder + "/runs/" + name, false, false, {}};
    job.scene.bearing = bearing;
    job.scene.name = name;
    job.scene.validate();
    jobs.push_back(job);
  };
  for (const double scale : {1.10, 1.05, 1.0})
    for (const char *pulse : {"ricker-0.78g-1.0s", "ricker-0.38g-1.5s"})
      add(fmt::format("{}-x{:.2f}", pulse, scale), scale > 1 ? "fit" : "predict", pulse,
          fmt::format("excitation.scale={:.2f}", scale));
  for (const double speed : {1.0, 0.6, 0.35, 0.2, 0.1, 0.05})
    add(fmt::format("window-{:.2f}", speed), "window", "impact-window",
        fmt::format("excitation.speed_m_per_s={}", speed));
  return jobs;
}

void run_jobs(std::vector<Job> &jobs, Console &console) {
  const int at_once = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  std::filesystem::create_directories(std::filesystem::path(jobs.front().folder).parent_path());
  std::vector<Child> children;
  std::size_t next = 0, finished = 0;
  ProgressLine line(console.quiet);
  const auto begin = std::chrono::steady_clock::now();
  while (next < jobs.size() || !children.empty()) {
    if (interrupted()) stop(children);
    while (next < jobs.size() && static_cast<int>(children.size()) < at_once) {
      Job &job = jobs[next++];
      if (is_done(job)) {
        job.done = job.reused = true;
        ++finished;
        console.message(job.name + ": already done, kept");
      } else
        children.push_back({launch(job, at_once > 1), &job});
    }
    for (std::size_t k = 0; k < children.size(); ++k) {
      const int code = poll(children[k].process, false);
      if (code < 0) continue;
      Job &job = *children[k].job;
      children.erase(children.begin() + k--);
      ++finished;
      job.done = code == 0;
      line.finish();
      if (job.done) {
        const auto summary = nlohmann::json::parse(read_text(job.folder + "/summary.json"), nullptr, false);
        console.message(fmt::format("{:26s} {:8.1f} kN, {} impact(s), {}", job.name,
                                    1e-3 * (summary["peak_impact_force_N"].is_number()
                                                ? summary["peak_impact_force_N"].get<double>()
                                                : 0.0),
                                    summary["n_impacts"].get<int>(), duration(summary["wall_time_s"])));
      } else {
        job.failure = failure_of(job, code);
        console.warn(job.name + ": " + job.failure);
      }
    }
    std::string running;
    for (const auto &child : children) running += " " + child.job->name;
    line.show(fmt::format(
        "{} of {} runs done, running:{}  ({})", finished, jobs.size(), running,
        duration(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count())));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

} // namespace rimpact::app
