#include "app/jobs/geometry_vary.h"

#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/jobs/folder_claim.h"
#include "app/jobs/geometry_target.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/run_plan.h"
#include "app/jobs/shard.h"
#include "calibration/studies/vary_answer.h"
#include "calibration/studies/vary_results.h"
#include "fe_contact/planning/plan.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "responses/build_version.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

using calibration::VaryAnswer;
using calibration::VaryPoint;
using calibration::VaryQuestion;
using nlohmann::json;

/// The isolated impact of the bearing with these values.
scene::Scene window_at(const VaryOptions &options, const VaryQuestion &question, const std::vector<double> &at,
                       const Console &console) {
  auto overrides = console.overrides;
  for (auto &setting : settings_of(question, at)) overrides.push_back(setting);
  GivenCase given = given_case(options.where, overrides);
  given.scene.model.rung = scene::Rung::rim;
  scene::Scene window = window_of(given, console.overrides);
  window.excitation.speed = question.speed;
  window.name = name_of(question, at);
  window.validate();
  return window;
}

std::vector<CurveJob> curve_jobs(const VaryOptions &options, const VaryQuestion &question, const Console &console) {
  std::vector<CurveJob> jobs;
  for (const auto &at : combinations(question)) {
    const auto window = window_at(options, question, at, console);
    jobs.push_back({.name = window.name,
                    .scene = window,
                    .folder = options.folder + "/curves/" + window.name,
                    .expected_seconds = expected_seconds_of_curve(window)});
  }
  return jobs;
}

RunPlan plan_of(const VaryOptions &options, const std::vector<CurveJob> &jobs, std::size_t at_once) {
  RunPlan plan{.what = "rim curve", .several = "curves", .width = 32, .runs = {}, .at_once = at_once, .proof = 0.0};
  for (const auto &job : jobs) plan.runs.push_back({job.name, job.expected_seconds});
  if (!options.no_proof) plan.proof = planning::make_plan(jobs[jobs.size() / 2].scene).expected_seconds;
  return plan;
}

/// What the curves of all shards say.
std::vector<VaryPoint> points_of(const std::vector<CurveJob> &jobs, const VaryQuestion &question) {
  std::vector<VaryPoint> points;
  const auto all = combinations(question);
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    const auto curve = kept_curve(jobs[k]);
    if (!curve) continue;
    VaryPoint point = vary_point(*curve, question);
    point.name = jobs[k].name, point.at = all[k];
    points.push_back(std::move(point));
  }
  return points;
}

/// A solid run of the answer's rim beside what the curves say of it.
struct Proof {
  json said;
  std::string sentence;
};

Proof proof_of(const Job &job, const VaryPoint &predicted, Console &console) {
  if (!is_done(job))
    return {{{"name", job.name}, {"failure", job.failure}}, "Its solid run did not end: " + job.failure + "."};
  const auto summary = summary_of(job.folder);
  if (summary.value("impacts", json::array()).empty())
    return {{{"name", job.name}, {"failure", "no impact"}}, "Its solid run met no rim."};
  const auto &impact = summary["impacts"][0];
  const double force = impact["peak_force_N"], depth = impact["peak_penetration_m"],
               strain = strain_in(summary, job.folder);
  const double off = predicted.peak_force / force - 1;
  json said{{"name", job.name},
            {"peak_kN", force / 1e3},
            {"depth_mm", 1e3 * depth},
            {"rebound_m_per_s", impact["rebound_speed_m_s"]},
            {"strain", strain},
            {"force_error_of_the_answer", off},
            {"error_estimate", summary.value("error_estimate", json())},
            {"doubts", doubts_of(summary)}};
  std::string sentence = fmt::format(
      "Its solid run ({}) gives {:.0f} kN, {:.2f} mm, rebound {:.3f} m/s, strain {:.3f}: the answer's force is "
      "off by {:+.1f} %.",
      job.name, force / 1e3, 1e3 * depth,
      impact["rebound_speed_m_s"].is_number() ? impact["rebound_speed_m_s"].get<double>() : 0.0, strain, 100 * off);
  constexpr double much = 0.05;
  if (std::abs(off) > much)
    console.warn(fmt::format(
        "the answer's force is {:+.1f} % from its solid run: ask with more rims (--vary KEY=LOW:HIGH:N)", 100 * off));
  return {std::move(said), std::move(sentence)};
}

/// On the wall of the rim that was pushed nearest to the answer; none: no force is asked for.
std::optional<calibration::LinerAnswer> liner_of(const VaryOptions &options, const VaryQuestion &question,
                                                 const std::vector<VaryPoint> &points, const VaryAnswer &answer,
                                                 const Console &console) {
  if (!answer.design || !question.targets.contains("peak_kN")) return {};
  const auto distance = [&](const VaryPoint &point) {
    double sum = 0;
    for (std::size_t j = 0; j < point.at.size(); ++j) sum += std::abs(std::log(point.at[j] / (*answer.design)[j]));
    return sum;
  };
  const auto &nearest = *std::min_element(points.begin(), points.end(),
                                          [&](const auto &a, const auto &b) { return distance(a) < distance(b); });
  return calibration::liner_answer(question, nearest, window_at(options, question, nearest.at, console).bearing,
                                   options.crush_share);
}

/// What is said at the end, each part where there is one.
struct Said {
  const VaryAnswer &answer;
  std::optional<calibration::LinerAnswer> liner;
  std::optional<Proof> proof;
};

void write_answer(const GivenCase &given, const VaryQuestion &question, const std::vector<VaryPoint> &points,
                  const Said &all, const std::vector<CurveJob> &jobs, const VaryOptions &options, Console &console) {
  const auto &[answer, liner, proof] = all;
  const std::string &folder = options.folder;
  json said = calibration::to_json(points, question);
  said["bearing"] = given.bearing_json(), said["load"] = given.load_json(), said["warnings"] = console.warnings();
  said["command"] = console.command(), said["made_by"] = build_version();
  said["mesh"] = given.scene.model.mesh;
  said["failures"] = json::object();
  for (const auto &job : jobs)
    if (!job.failure.empty()) said["failures"][job.name] = job.failure;
  said["between"] = calibration::between_json(answer.between);
  said["answer"] = {{"design", answer.design ? json(*answer.design) : json()},
                    {"reached", answer.reached},
                    {"force_error", answer.force_error},
                    {"sentence", answer.sentence},
                    {"proof", proof ? proof->said : json()}};
  said["liner"] = liner ? calibration::to_json(*liner, options.crush_share) : json();
  std::string sentence = answer.sentence + (proof ? " " + proof->sentence : "") + (liner ? " " + liner->sentence : "");
  for (const auto &job : jobs)
    if (!job.failure.empty()) sentence += fmt::format(" {} has no result.", job.name);
  said["sentence"] = sentence;
  write_atomically(json_text(said), folder + "/geometry.json");
  write_atomically(calibration::to_csv(points, question), folder + "/geometry.csv");
  console.data(console.json ? json_text(said)
                            : given.head() + calibration::describe(points, question) + sentence + "\n");
  if (!points.empty() && python({"report.quick", "geometry", folder}) != 0)
    console.warn("the picture in " + folder + " was not made");
}

Job proof_job(const VaryOptions &options, const VaryQuestion &question, const VaryAnswer &answer,
              const Console &console) {
  const auto window = window_at(options, question, *answer.design, console);
  return {.name = window.name,
          .role = JobRole::geometry,
          .scene = window,
          .folder = options.folder + "/runs/" + window.name};
}

void require_pushed(const std::vector<CurveJob> &jobs) {
  for (const auto &job : jobs)
    if (!job.failure.empty()) throw SolverStopped(job.name + " was not pushed: " + job.failure);
}

} // namespace

void run_vary(const VaryOptions &options, Console &console) {
  const auto [part, n_parts] = parse_shard(options.shard);
  GivenCase given = geometry_target(options.where, console);
  const VaryQuestion question = vary_question(options.words, given);
  if (given.scene.bearing.rim_steel().knows_rate())
    console.warn(fmt::format("the curves are pushed infinitely slowly: the steel's law of the rate ({}) has no part in "
                             "their forces, which are too low; the solid run has it",
                             in_words(given.scene.bearing.rim_steel().rate)));
  auto jobs = curve_jobs(options, question, console);
  const std::size_t at_once = options.jobs > 0 ? options.jobs : cores_to_use();
  if (options.dry_run) return print_plan(given, plan_of(options, jobs, at_once), console);
  if (!console.json) console.message(given.load_line().substr(0, given.load_line().size() - 1));
  const auto lock =
      claim_for_jobs(options.folder, Collection::geometry_study, {}, console.force, part_name(part, n_parts));
  make_runs_folder(options.folder);
  watch_interrupts();
  std::vector<CurveJob> own = shard_of(jobs, part, n_parts);
  run_curves(own, options.folder, at_once, console);
  const auto points = points_of(jobs, question);
  if (n_parts > 1 && points.size() < jobs.size()) {
    console.message(
        fmt::format("{} of {} curves are pushed: the last part gives the answer", points.size(), jobs.size()));
    return require_pushed(own);
  }
  const VaryAnswer answer = vary_answer(points, question);
  std::optional<Proof> proof;
  if (answer.design && !options.no_proof) {
    std::vector<Job> solid{proof_job(options, question, answer, console)};
    JobRunner(solid, console, 1).run();
    proof = proof_of(solid[0], *answer.predicted, console);
  }
  write_answer(given, question, points, {answer, liner_of(options, question, points, answer, console), proof}, own,
               options, console);
  require_pushed(own);
}

} // namespace rimpact::app
