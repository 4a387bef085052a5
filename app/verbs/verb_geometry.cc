// rimpact geometry: k_i, e, peak force and plastic strain over rim and slider dimensions, yield stress and
// speed.
#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/jobs/folder_claim.h"
#include "app/jobs/geometry_target.h"
#include "app/jobs/geometry_vary.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/run_plan.h"
#include "app/jobs/shard.h"
#include "app/verbs/catalogue.h"
#include "app/words/assignments.h"
#include "calibration/studies/geometry_results.h"
#include "calibration/studies/wanted_pair.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "responses/build_version.h"
#include "responses/response.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

struct GeometryOptions {
  std::string bearing = "shfps-225", folder = "results/geometry", shard;
  std::vector<std::string> ranges;
  std::vector<double> pair; ///< k_i, e; empty: none is wanted
  std::size_t jobs = 0;     ///< side by side; 0: as many as there are cores
  bool dry_run = false, no_proof = false;
  double crush_share = calibration::usual_crush_share;
  calibration::GeometryOptions study;
  VaryWords vary;
};

/// Rows of all runs that are done, whichever shard ran them.
std::vector<calibration::GeometryRow> rows_of(const std::vector<Job> &jobs, Console &console) {
  std::vector<calibration::GeometryRow> rows;
  for (const auto &job : jobs) {
    if (!is_done(job)) continue;
    try {
      rows.push_back(calibration::geometry_row(job.name, calibration::read_run(job.folder, {}),
                                               strain_in(summary_of(job.folder), job.folder)));
    } catch (const DataError &error) {
      console.warn(error.what());
    }
  }
  return rows;
}

/// To files and screen: the case, the rows, their surrogates and, where a pair is wanted, the rims that return it.
void write_study(const calibration::GeometryStudy &study, const GivenCase &given,
                 const std::optional<calibration::WantedPair> &wanted, const std::string &folder, Console &console) {
  auto json = calibration::to_json(study);
  json["bearing"] = given.bearing_json(), json["load"] = given.load_json(), json["warnings"] = given.warnings;
  json["command"] = console.command(), json["made_by"] = build_version();
  std::string text = given.head() + calibration::describe(study);
  if (wanted) {
    const auto region = calibration::pair_region(study, *wanted);
    json["pair"] = region ? calibration::to_json(*region) : nullptr;
    text +=
        (region ? region->sentence : "No surrogate tells where the wanted pair is returned: take more samples.") + "\n";
  }
  write_atomically(json_text(json), folder + "/geometry.json");
  write_atomically(calibration::to_csv(study), folder + "/geometry.csv");
  console.data(console.json ? json_text(json) : text);
}

/// The runs of this part.
RunPlan plan_of(const std::vector<Job> &jobs, std::size_t at_once) {
  const auto times = expected_times(jobs);
  RunPlan plan{.what = "run",
               .several = "runs",
               .width = 10,
               .runs = {},
               .at_once = at_once > 0 ? at_once : cores_to_use(),
               .proof = {}};
  for (std::size_t k = 0; k < jobs.size(); ++k) plan.runs.push_back({jobs[k].name, times[k].expected});
  return plan;
}

void run_geometry(GeometryOptions options, Console &console) {
  const auto [part, n_parts] = parse_shard(options.shard);
  std::optional<calibration::WantedPair> wanted;
  if (!options.pair.empty()) {
    wanted = {options.pair[0], options.pair[1]};
    wanted->validate();
  }
  options.study.ranges = ranges_of(options.ranges, "--range");
  if (!options.vary.at.empty() || !options.vary.targets.empty())
    throw InputError("--at and --target belong to --vary KEY=LOW:HIGH");
  GivenCase given = geometry_target(options.bearing, console);
  const scene::Scene window = window_of(given, console.overrides);
  for (const auto &remark : window.remarks) // what a window does not read
    if (std::find(given.warnings.begin(), given.warnings.end(), remark) == given.warnings.end())
      given.warnings.push_back(remark), console.warn(remark);
  if (!console.json) console.message(given.load_line().substr(0, given.load_line().size() - 1));
  std::vector<Job> jobs;
  for (const auto &scene : calibration::geometry_scenes(window, options.study))
    jobs.push_back({.name = scene.name,
                    .role = JobRole::geometry,
                    .scene = scene,
                    .folder = options.folder + "/runs/" + scene.name});
  std::vector<Job> own = shard_of(jobs, part, n_parts);
  if (options.dry_run) return print_plan(given, plan_of(own, options.jobs), console);
  const auto lock =
      claim_for_jobs(options.folder, Collection::geometry_study, jobs, console.force, part_name(part, n_parts));
  make_runs_folder(options.folder);
  JobRunner runner(own, console, options.jobs);
  watch_interrupts();
  runner.run();

  const auto study = calibration::geometry_study(rows_of(jobs, console), window, options.study);
  write_study(study, given, wanted, options.folder, console);
  if (!study.rows.empty() && python({"report.quick", "geometry", options.folder}) != 0)
    console.warn("the picture in " + options.folder + " was not made");
  if (interrupted()) throw Error(ExitCode::interrupted, "interrupted; the same command goes on where it stopped");
  require_done(own);
}

/// --vary asks another question than the samples do, whose options it does not read.
void answer(const GeometryOptions &options, const CLI::App &verb, Console &console) {
  if (console.mesh >= 0) console.overrides.push_back(fmt::format("model.mesh={}", console.mesh));
  const bool wants_force = std::any_of(options.vary.targets.begin(), options.vary.targets.end(),
                                       [](const auto &word) { return word.starts_with("peak_kN="); });
  if (verb.count("--crush") > 0 && !(wants_force && !options.vary.vary.empty()))
    throw InputError("--crush belongs to --vary with --target peak_kN=MOST, which a liner may keep");
  if (options.vary.vary.empty()) return run_geometry(options, console);
  for (const char *other : {"--samples", "--range", "--pair", "--strain-limit"})
    if (verb.count(other) > 0)
      throw InputError(fmt::format("{} belongs to the samples, which --vary does not take{}", other,
                                   std::string(other) == "--strain-limit"
                                       ? "; its limit is the steel's: --set bearing.material.steel.strain_limit=..."
                                       : ""));
  run_vary({.words = options.vary,
            .where = options.bearing,
            .folder = options.folder,
            .shard = options.shard,
            .jobs = options.jobs,
            .dry_run = options.dry_run,
            .no_proof = options.no_proof,
            .crush_share = options.crush_share},
           console);
}

/// Of the question by rim curves.
void add_vary(CLI::App &verb, GeometryOptions &options) {
  verb.add_option("--vary", options.vary.vary,
                  "KEY=LOW:HIGH[:N] of a bearing's key, as rim.thickness_mm=20:80: N (3) rims are pushed; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--at", options.vary.at, "speed=V: the speed of approach that --vary asks at [m/s]")
      ->allow_extra_args(false);
  verb.add_option("--target", options.vary.targets,
                  "NAME=MOST of peak_kN, depth_mm, rebound_m_per_s, strain, rim_foot_use: which of the rims of --vary "
                  "meets it; repeatable")
      ->allow_extra_args(false);
  verb.add_flag("--no-proof", options.no_proof, "without the solid run of the rim that --vary answers with");
  verb.add_option("--crush", options.crush_share,
                  "share of a sacrificial liner's thickness that crushes at its stress, of --target peak_kN")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1.0));
}

void add_geometry(CLI::App &verb, Console &console) {
  auto options = std::make_shared<GeometryOptions>();
  verb.add_option("BEARING", options->bearing,
                  "a bearing, scene or case folder: built-in or a TOML file; a scene's load and settings are taken")
      ->capture_default_str();
  verb.add_option("-o,--output", options->folder, "results folder")->capture_default_str();
  add_vary(verb, *options);
  verb.add_option("--mesh", console.mesh, "1 | 2 | 3: finer and more expensive")->check(CLI::Range(0, 3));
  verb.add_option("--jobs", options->jobs, "runs side by side (default: one a core)")->check(CLI::Range(1, 64));
  verb.add_flag("--dry-run", options->dry_run, "list the runs and the time they take, and stop");
  verb.add_option("--samples", options->study.samples, "impacts by finite elements, about a minute each")
      ->capture_default_str();
  verb.add_option("--range", options->ranges,
                  "NAME=LOW:HIGH of rim_height, rim_thickness, slider_diameter, contact_band "
                  "(mm), yield_stress, tangent_modulus (MPa), speed (m/s); repeatable");
  verb.add_option("--strain-limit", options->study.strain_limit, "plastic strain at which a rim counts as lost")
      ->capture_default_str();
  verb.add_option("--pair", options->pair, "K_I,E (kN/m, -): which of the rims return this pair, and at what speed")
      ->expected(2)
      ->delimiter(',');
  verb.add_option("--shard", options->shard, "I/N: every N-th run from the I-th on, with the same -o");
  console.add_common(verb);
  console.add_json(verb);
  console.add_overrides(verb);
  console.add_force(verb);
  verb.callback([options, &verb, &console] { answer(*options, verb, console); });
}

} // namespace

const Verb geometry_verb{
    {.name = "geometry",
     .help = "force, depth, rebound and strain over a rim's dimension, and which of them "
             "meets a target (--vary); or k_i and e over samples of them all",
     .examples = "rimpact geometry my-case --vary rim.thickness_mm=20:80 --at speed=0.8 --target peak_kN=4000\n"
                 "rimpact geometry my-case/bearing.toml --samples 40 --range speed=0.1:0.6 -o my-study",
     .next = "rimpact report {}"},
    add_geometry};

} // namespace rimpact::app
