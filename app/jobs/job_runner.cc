#include "app/jobs/job_runner.h"

#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/jobs/fe_processes.h"
#include "io/files/file.h"
#include "responses/kept_run.h"
#include "responses/physics_version.h"
#include "responses/response.h"
#include "scene/toml_writer.h"
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <thread>
#include <unistd.h>
#include <utility>

namespace rimpact::app {
namespace {

std::string read_text(const std::string &path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The physics_version() of the finite-element program: this one's own, unless another build's was asked for.
const std::string &fe_physics() {
  static const std::string physics = [] {
    if (!std::getenv("RIMPACT_FE_PROGRAM")) return physics_version();
    const auto file = std::filesystem::temp_directory_path() / fmt::format("rimpact-version-{}.json", getpid());
    poll(start({.command = {fe_program(), "version", "--json"}, .output = file.string(), .errors = "/dev/null"}), true);
    const auto versions = nlohmann::json::parse(read_text(file.string()), nullptr, false);
    std::filesystem::remove(file);
    return versions.is_object() ? versions.value("physics", physics_version()) : physics_version();
  }();
  return physics;
}

KeptRun kept_in(const Job &job) {
  return kept_run(job.folder, job.scene, job.reduced ? physics_version() : fe_physics());
}

bool is_done(const KeptRun &kept) {
  return kept.is_current() && kept.status == RunStatus::done;
}

/// Why what the folder holds is not kept, a sentence; empty: there is nothing, or it is kept.
std::string out_of_date(const KeptRun &kept) {
  if (!kept.any || kept.is_current()) return {};
  return kept.other_scene.empty() ? kept.changed : "the scene there is another: " + kept.other_scene;
}

/// DIR/logs/NAME.EXTENSION of DIR/runs/NAME.
std::string beside_runs(const Job &job, const char *extension) {
  const auto runs = std::filesystem::path(job.folder).parent_path();
  return (runs.parent_path() / "logs" / (job.name + extension)).string();
}

} // namespace

void make_runs_folder(const std::string &folder) {
  for (const std::string part : {"/runs", "/logs"}) {
    std::error_code error;
    std::filesystem::create_directories(folder + part, error);
    if (error) throw IoError("cannot make " + folder + part + ": " + error.message());
  }
}

void require_done(const std::vector<Job> &jobs) {
  for (const auto &job : jobs)
    if (!job.done && !job.left_out) throw SolverStopped(job.name + " did not end well: " + job.failure);
}

bool is_done(const Job &job) {
  return is_done(kept_in(job));
}

nlohmann::json summary_of(const std::string &folder) {
  return read_summary(folder);
}

std::vector<std::string> doubts_of(const nlohmann::json &summary) {
  std::vector<std::string> doubts;
  if (const auto found = summary.find("warnings"); found != summary.end() && found->is_array())
    for (const auto &sentence : *found)
      if (sentence.is_string()) doubts.push_back(sentence);
  return doubts;
}

nlohmann::json fe_versions(const std::string &folder, Console &console) {
  const std::string file = folder + "/versions.json", log = folder + "/versions.log";
  const int code = poll(start({.command = {fe_program(), "version", "--json"}, .output = file, .errors = log}), true);
  auto versions = nlohmann::json::parse(read_text(file), nullptr, false);
  const std::string said = last_line(log);
  if (code != 0 || !versions.is_object())
    throw IoError(fmt::format("the finite-element program does not start (exit code {}){}{}", code,
                              said.empty() ? "" : ": ", said));
  std::filesystem::remove(log);
  if (said.rfind("warning: ", 0) == 0) console.warn(said.substr(9));
  return versions;
}

JobRunner::JobRunner(std::vector<Job> &jobs, Console &console, std::size_t at_once)
    : jobs_(jobs), console_(console), at_once_(at_once > 0 ? at_once : cores_to_use()), times_(expected_times(jobs)),
      line_(console.quiet) {
  static_cast<void>(fe_program()); // before the first run, so that nothing is begun without it
}

void JobRunner::run(const std::function<void(std::vector<Job> &)> &on_end) {
  while (next_ < jobs_.size() || !children_.empty()) {
    if (interrupted()) stop_all();
    collect();
    if (std::exchange(ended_, false) && on_end) line_.finish(), on_end(jobs_);
    while (next_ < jobs_.size() && children_.size() < at_once_ && !ended_) start_next();
    show_progress();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  line_.finish();
}

void JobRunner::start_next() {
  Job &job = jobs_[next_++];
  if (job.left_out) {
    time_of(job).state = RunTime::State::out;
    return;
  }
  job.begun = true;
  const KeptRun kept = kept_in(job);
  if (is_done(kept)) {
    job.done = job.reused = true;
    time_of(job).state = RunTime::State::out;
    ++finished_, ended_ = true;
    console_.message(job.name + ": already done, kept");
    return;
  }
  write_atomically(scene::to_toml(job.scene), beside_runs(job, ".toml"));
  const bool has_checkpoint = std::filesystem::exists(job.folder + "/checkpoint.h5");
  if (kept.killed && kept.other_scene.empty()) {
    console_.message(job.name + ": was killed, goes on from its checkpoint");
    launch(job, {"--resume"}, true);
  } else if (const auto why = out_of_date(kept); !why.empty())
    start_anew(job, why);
  else if (kept.status == RunStatus::interrupted && has_checkpoint)
    launch(job, {"--resume"});
  else
    launch(job, {});
}

void JobRunner::start_anew(Job &job, const std::string &why) {
  console_.message(job.name + ": run again, because " + why);
  launch(job, {"--force"});
}

void JobRunner::launch(Job &job, const std::vector<std::string> &words, bool picked_up) {
  std::vector<std::string> command{"run", beside_runs(job, ".toml"), "-o", job.folder, "--quiet"};
  command.insert(command.end(), words.begin(), words.end());
  children_.push_back({start_fe(command, beside_runs(job, ".log"), at_once_ == 1), &job, picked_up});
  time_of(job).state = RunTime::State::running;
}

void JobRunner::collect() {
  for (std::size_t k = 0; k < children_.size();) {
    const int code = poll(children_[k].process, false);
    if (code < 0) {
      ++k;
      continue;
    }
    const Child child = children_[k];
    children_.erase(children_.begin() + k);
    if (child.picked_up && code == static_cast<int>(ExitCode::data)) {
      line_.finish();
      const std::string why = failure_in_words(code, beside_runs(*child.job, ".log"));
      start_anew(*child.job, why.substr(0, why.find("; run without --resume")));
      continue;
    }
    time_of(*child.job).spent = std::chrono::duration<double>(Clock::now() - child.begin).count();
    finish(*child.job, code);
  }
}

void JobRunner::finish(Job &job, int code) {
  ++finished_, ended_ = true;
  line_.finish();
  job.done = code == 0 && is_done(job);
  time_of(job).state = job.done ? RunTime::State::finished : RunTime::State::out;
  if (!job.done) {
    job.failure = failure_in_words(code, beside_runs(job, ".log"));
    return console_.warn(job.name + ": " + job.failure);
  }
  const auto summary = summary_of(job.folder);
  const auto &force = summary["peak_impact_force_N"];
  console_.message(fmt::format("{:26s} {:8.1f} kN, {} impact(s), {}", job.name,
                               force.is_number() ? 1e-3 * force.get<double>() : 0.0, summary.value("n_impacts", 0),
                               duration(summary.value("wall_time_s", 0.0))));
  for (const auto &doubt : doubts_of(summary)) console_.warn(job.name + ": " + doubt);
}

void JobRunner::show_progress() {
  std::string running;
  for (const auto &child : children_) {
    running += " " + child.job->name;
    time_of(*child.job).spent = std::chrono::duration<double>(Clock::now() - child.begin).count();
  }
  const std::chrono::duration<double> spent = Clock::now() - begin_;
  line_.show(fmt::format("{} of {} runs done, {} to go, running:{}  ({})", finished_, jobs_.size(),
                         about(time_to_go(times_, at_once_)), running, duration(spent.count())));
}

void JobRunner::stop_all() {
  line_.finish();
  console_.message("interrupted: waiting for the runs to write their checkpoints");
  std::vector<pid_t> running;
  for (const auto &child : children_) running.push_back(child.process);
  stop_fe(running);
}

} // namespace rimpact::app
