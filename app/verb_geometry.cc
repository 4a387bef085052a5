// rimpact geometry: k_i, e, peak force and plastic strain over rim and slider dimensions, yield stress and
// speed.
#include "app/assignments.h"
#include "app/folder_claim.h"
#include "app/job_runner.h"
#include "app/main_target.h"
#include "app/set_keys.h"
#include "app/shard.h"
#include "app/sibling.h"
#include "app/verb.h"
#include "calibration/studies/wanted_pair.h"
#include "files/file.h"
#include "files/json_text.h"
#include "responses/build_version.h"
#include "responses/response.h"
#include "responses/steel_report.h"
#include "scene/doubts.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

struct GeometryOptions {
  std::string bearing = "shfps-225", folder = "results/geometry", shard;
  std::vector<std::string> ranges;
  std::vector<double> pair; ///< k_i, e; empty: none is wanted
  calibration::GeometryOptions study;
};

/// Of the rim's side, averaged; of a summary without places, the largest of any body.
double strain_in(const nlohmann::json &summary, const std::string &folder) {
  const auto of_any_body = summary.value("max_plastic_strain", nlohmann::json());
  const auto judged = judged_strain(steel_report_in(summary, folder),
                                    of_any_body.is_number() ? std::optional(of_any_body.get<double>()) : std::nullopt);
  return judged ? judged->largest : 0.0;
}

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

std::string not_of_geometry(const std::string &key) {
  if (is_in(key, "excitation.kind")) return "every run is an isolated impact (impact-window)";
  if (is_in(key, "excitation.speed_m_per_s") || is_in(key, "excitation.scale"))
    return "the speed is one of its ranges: --range speed=LOW:HIGH";
  if (is_in(key, "reduced.calibration") || is_of_a_fit(key)) return "each impact gets a k_i and e of its own";
  return key == "name" ? "its runs are numbered" : "";
}

/// The isolated impact of the bearing under its load.
scene::Scene window_of(const GivenCase &given, const std::vector<std::string> &overrides) {
  std::vector<std::string> motion;
  for (const auto &assignment : overrides) {
    const auto keys = keys_set({assignment});
    if (std::any_of(keys.begin(), keys.end(), [](const auto &key) { return is_in(key, "excitation"); }))
      motion.push_back(assignment);
  }
  scene::Scene window = scene::load_scene("impact-window", motion);
  window.bearing = given.scene.bearing, window.load = given.scene.load;
  window.load_remark = given.scene.load_remark;
  window.model = given.scene.model, window.reduced = given.scene.reduced;
  window.reduced.forget_fit();
  window.validate();
  return window;
}

/// The bearing and load that are flown, with what is to be said of them.
GivenCase geometry_target(const GeometryOptions &options, Console &console) {
  if (!console.calibration.empty())
    throw InputError("--calibration: geometry fits k_i and e to each impact by itself, it takes no element");
  GivenCase given = given_case(options.bearing, console.overrides);
  refuse_unread(console.overrides, "geometry", not_of_geometry);
  require_rigid_mass_on_one_dish(given.scene, "geometry");
  take_rung(given, console.overrides);
  for (const auto &doubt : scene::doubts(given.scene)) given.warnings.push_back(doubt);
  for (const auto &warning : given.warnings) console.warn(warning);
  if (!given.built_in && given.has_motion)
    console.message(fmt::format("the motion of {} is not run: geometry runs isolated impacts (impact-window); --range "
                                "speed=LOW:HIGH gives their speeds",
                                given.origin));
  return given;
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

void run_geometry(GeometryOptions options, Console &console) {
  const auto [part, n_parts] = parse_shard(options.shard);
  std::optional<calibration::WantedPair> wanted;
  if (!options.pair.empty()) {
    wanted = {options.pair[0], options.pair[1]};
    wanted->validate();
  }
  options.study.ranges = ranges_of(options.ranges, "--range");
  GivenCase given = geometry_target(options, console);
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
  const auto lock =
      claim_for_jobs(options.folder, Collection::geometry_study, jobs, console.force, part_name(part, n_parts));
  make_runs_folder(options.folder);
  JobRunner runner(own, console);
  watch_interrupts();
  runner.run();

  const auto study = calibration::geometry_study(rows_of(jobs, console), window, options.study);
  write_study(study, given, wanted, options.folder, console);
  if (!study.rows.empty() && python({"report.quick", "geometry", options.folder}) != 0)
    console.warn("the picture in " + options.folder + " was not made");
  if (interrupted()) throw Error(ExitCode::interrupted, "interrupted; the same command goes on where it stopped");
  require_done(own);
}

} // namespace

void add_geometry(CLI::App &app, Console &console) {
  auto *verb = app.add_subcommand("geometry", "k_i and e over rim and slider dimensions, yield stress and speed");
  auto options = std::make_shared<GeometryOptions>();
  verb->add_option("BEARING", options->bearing,
                   "a bearing, scene or case folder: built-in or a TOML file; a scene's load and settings are taken")
      ->capture_default_str();
  verb->add_option("-o,--output", options->folder, "results folder")->capture_default_str();
  verb->add_option("--samples", options->study.samples, "impacts by finite elements, about a minute each")
      ->capture_default_str();
  verb->add_option("--range", options->ranges,
                   "NAME=LOW:HIGH of rim_height, rim_thickness, slider_diameter, contact_band "
                   "(mm), yield_stress, tangent_modulus (MPa), speed (m/s); repeatable");
  verb->add_option("--strain-limit", options->study.strain_limit, "plastic strain at which a rim counts as lost")
      ->capture_default_str();
  verb->add_option("--pair", options->pair, "K_I,E (kN/m, -): which of the rims return this pair, and at what speed")
      ->expected(2)
      ->delimiter(',');
  verb->add_option("--shard", options->shard, "I/N: every N-th run from the I-th on, with the same -o");
  console.add_common(*verb);
  console.add_json(*verb);
  console.add_overrides(*verb);
  console.add_force(*verb);
  verb->callback([options, &console] { run_geometry(*options, console); });
}

} // namespace rimpact::app
