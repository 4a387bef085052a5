#include "app/jobs/early_answer.h"

#include "app/jobs/job_runner.h"
#include "calibration/answer/answer.h"
#include "calibration/answer/answer_json.h"
#include "calibration/answer/calibration_json.h"
#include "calibration/laws/percent.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

constexpr std::size_t fewest = 3; ///< windows: one is left out, two are fitted

/// The largest of peak force and rebound [-]; none: no run could be left out, or an error is unknown.
std::optional<double> error_left_out(const calibration::AnswerLaw &law) {
  double most = law.left_out.empty() ? NAN : 0;
  for (const auto &error : law.left_out)
    for (const double each : {error.peak_force, error.rebound}) most = calibration::larger_of(most, std::abs(each));
  return calibration::known(most);
}

bool touches(const Job &job) {
  return job.done && summary_of(job.folder).value("n_impacts", 0) > 0;
}

/// Whether the fastest and the slowest window have ended, well or not: until then an answer would not be of the speeds
/// asked for.
bool spans(const std::vector<const Job *> &windows) {
  const auto by_speed = [](const Job *a, const Job *b) {
    return a->scene.excitation.speed < b->scene.excitation.speed;
  };
  const auto [slowest, fastest] = std::ranges::minmax_element(windows, by_speed);
  const auto ended = [](const Job *job) { return job->done || !job->failure.empty(); };
  return ended(*slowest) && ended(*fastest);
}

} // namespace

EarlyAnswer::EarlyAnswer(std::string folder, std::vector<std::string> laws, std::optional<double> until,
                         Console &console)
    : folder_(std::move(folder)), laws_(std::move(laws)), until_(until), console_(console) {}

bool EarlyAnswer::due(std::size_t done, std::size_t all) const {
  return done >= fewest && done > fitted_ && (fitted_ == 0 || done == all || until_);
}

void EarlyAnswer::operator()(std::vector<Job> &jobs) {
  if (!left_out_.empty()) return;
  std::vector<const Job *> windows;
  std::vector<std::string> done;
  for (const Job &job : jobs) {
    if (job.role != JobRole::window) continue;
    windows.push_back(&job);
    if (touches(job)) done.push_back(job.folder);
  }
  if (!due(done.size(), windows.size()) || !spans(windows)) return;
  fitted_ = done.size();
  if (std::ranges::all_of(jobs, &Job::begun)) return; // the whole answer comes next
  reached_ = error_of(done);
  if (until_ && reached_ && *reached_ <= *until_) leave_out(jobs);
}

std::optional<double> EarlyAnswer::error_of(const std::vector<std::string> &folders) {
  try {
    calibration::CalibrationOptions options;
    options.laws = laws_, options.profiles = false;
    const auto fitted = calibration::calibrate(folders, options);
    calibration::write_calibration(fitted, folder_ + "/calibration");
    const calibration::AnswerLaw &law = fitted.answer->law;
    const auto error = error_left_out(law);
    console_.message(
        fmt::format("after {} windows: {}{}", folders.size(), law.sentence,
                    error ? fmt::format(" Largest error of a window left out: {:.2g} %.", 100 * *error) : ""));
    return error;
  } catch (const Error &why) { // the whole set may still have an answer
    console_.message(fmt::format("after {} windows there is no answer: {}", folders.size(), why.what()));
    return {};
  }
}

void EarlyAnswer::leave_out(std::vector<Job> &jobs) {
  const auto window_is_left_out = [&](const Job &twin) {
    return std::ranges::any_of(jobs, [&](const Job &job) {
      return job.role == JobRole::window && job.left_out && job.scene.excitation.speed == twin.scene.excitation.speed;
    });
  };
  for (const bool twins : {false, true})
    for (Job &job : jobs) {
      if (job.begun || (job.role == JobRole::twin) != twins) continue;
      job.left_out = !twins || window_is_left_out(job);
      if (job.left_out) names_.push_back(job.name);
    }
  left_out_ = fmt::format("{} runs are left out by --until: with {} windows the largest error of peak force and "
                          "rebound of a window left out of the fit is {:.2g} %, and {:.2g} % was asked; without "
                          "--until the same command makes them",
                          names_.size(), fitted_, 100 * *reached_, 100 * *until_);
  console_.message(left_out_);
}

nlohmann::json EarlyAnswer::to_json() const {
  if (!until_) return {};
  return {{"asked_percent", 100 * *until_},
          {"reached_percent", reached_ ? nlohmann::json(100 * *reached_) : nlohmann::json()},
          {"left_out", names_}};
}

} // namespace rimpact::app
