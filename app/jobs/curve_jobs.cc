#include "app/jobs/curve_jobs.h"

#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/console/progress.h"
#include "app/jobs/fe_processes.h"
#include "fe_contact/planning/plan.h"
#include "io/files/file.h"
#include "responses/build_version.h"
#include "scene/rim_identity.h"
#include "scene/toml_writer.h"
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <thread>

namespace rimpact::app {
namespace {

using Clock = std::chrono::steady_clock;

/// The last one begins where the mass is stopped, so that its rebound is not interpolated; the others serve slower
/// ones.
constexpr int unloadings = 3;

struct Child {
  pid_t process;
  CurveJob *job;
};

std::string log_of(const CurveJob &job, const std::string &folder) {
  return folder + "/logs/" + job.name + ".log";
}

Child launch(CurveJob &job, const std::string &folder, bool alone) {
  const std::string scene = folder + "/logs/" + job.name + ".toml";
  write_atomically(scene::to_toml(job.scene), scene);
  const std::vector<std::string> words{"curve",
                                       scene,
                                       "-o",
                                       job.folder,
                                       "--quiet",
                                       "--force",
                                       "--held",
                                       "--mesh",
                                       fmt::format("{}", job.scene.model.mesh),
                                       "--speed",
                                       fmt::format("{}", job.scene.excitation.speed),
                                       "--unloadings",
                                       fmt::format("{}", unloadings)};
  return {start_fe(words, log_of(job, folder), alone), &job};
}

[[noreturn]] void stop(const std::vector<Child> &children) {
  std::vector<pid_t> running;
  for (const auto &child : children) running.push_back(child.process);
  stop_fe(running);
}

/// Takes what has ended out of the list.
void collect(std::vector<Child> &children, const std::string &folder, Console &console) {
  for (std::size_t k = 0; k < children.size();) {
    const int code = poll(children[k].process, false);
    if (code < 0) {
      ++k;
      continue;
    }
    CurveJob &job = *children[k].job;
    children.erase(children.begin() + static_cast<std::ptrdiff_t>(k));
    if (code == 0 && kept_curve(job))
      console.message(job.name + ": pushed");
    else
      console.warn(job.name + ": " + (job.failure = failure_in_words(code, log_of(job, folder))));
  }
}

} // namespace

double expected_seconds_of_curve(const scene::Scene &window) {
  constexpr double share = 0.7;
  return share * planning::make_plan(window).expected_seconds;
}

std::optional<reduced::RimCurveFile> kept_curve(const CurveJob &job) {
  const std::string path = job.folder + "/curve.h5";
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return {};
  try {
    auto file = reduced::read_rim_curve(path);
    const laws::RimCurve curve(file.held);
    const double needed = job.scene.load.mass / 2 * std::pow(job.scene.excitation.speed, 2);
    const bool same = file.rim_identity == scene::rim_identity(job.scene.bearing) && file.made_by == build_version() &&
                      file.joint == strength_in_words(job.scene.bearing.rim.connection) &&
                      file.mesh.starts_with(fmt::format("level {},", job.scene.model.mesh));
    if (!same || curve.work(curve.range()) < needed) return {};
    return file;
  } catch (const Error &) { // a damaged one is pushed again
    return {};
  }
}

void run_curves(std::vector<CurveJob> &jobs, const std::string &folder, std::size_t at_once, Console &console) {
  std::vector<CurveJob *> waiting;
  for (auto &job : jobs)
    if (job.reused = kept_curve(job).has_value(); job.reused)
      console.message(job.name + ": already pushed, kept");
    else
      waiting.push_back(&job);
  std::vector<Child> children;
  ProgressLine line(console.quiet);
  const auto begin = Clock::now();
  for (std::size_t next = 0; next < waiting.size() || !children.empty();) {
    if (interrupted()) stop(children);
    while (next < waiting.size() && children.size() < at_once) {
      const bool is_odd_last = next + 1 == waiting.size() && waiting.size() % at_once == 1;
      children.push_back(launch(*waiting[next++], folder, at_once == 1 || is_odd_last)); // the last one has all cores
    }
    collect(children, folder, console);
    std::string running;
    for (const auto &child : children) running += " " + child.job->name;
    line.show(fmt::format("{} of {} curves pushed, running:{}  ({})", next - children.size(), waiting.size(), running,
                          duration(std::chrono::duration<double>(Clock::now() - begin).count())));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  line.finish();
}

} // namespace rimpact::app
