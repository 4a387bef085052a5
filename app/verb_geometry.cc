// rimpact geometry: k_i, e, peak force and plastic strain over rim and slider dimensions, yield stress and
// speed.
#include "app/job_runner.h"
#include "app/shard.h"
#include "app/sibling.h"
#include "app/verb.h"
#include "calibration/geometry_study.h"
#include "scene/response.h"
#include "scene/text.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

struct Options {
  std::string bearing = "shfps-225", folder = "results/geometry", shard;
  std::vector<std::string> ranges;
  calibration::GeometryOptions study;
};

void read_ranges(Options &options) {
  for (const auto &word : options.ranges) {
    const auto equals = word.find('='), colon = word.find(':');
    const auto low = equals < colon ? scene::to_number(word.substr(equals + 1, colon - equals - 1))
                                    : std::nullopt,
               high = colon != std::string::npos ? scene::to_number(word.substr(colon + 1)) : std::nullopt;
    if (!low || !high) throw InputError("--range " + word + ": must be NAME=LOW:HIGH");
    options.study.ranges[word.substr(0, equals)] = {*low, *high};
  }
}

/// Rows of all runs that are done, whichever shard ran them.
std::vector<calibration::GeometryRow> rows_of(const std::vector<Job> &jobs, Console &console) {
  std::vector<calibration::GeometryRow> rows;
  for (const auto &job : jobs) {
    if (!is_done(job)) continue;
    try {
      const auto strain = summary_of(job.folder)["max_plastic_strain"];
      rows.push_back(calibration::geometry_row(job.name, calibration::read_run(job.folder, {}),
                                               strain.is_number() ? strain.get<double>() : 0.0));
    } catch (const DataError &error) {
      console.warn(error.what());
    }
  }
  return rows;
}

void run_geometry(Options options, Console &console) {
  const auto [part, n_parts] = parse_shard(options.shard);
  read_ranges(options);
  auto window = scene::load_scene("impact-window", console.overrides);
  window.bearing = scene::load_bearing(options.bearing);
  window.validate();
  std::vector<Job> jobs, own;
  for (const auto &scene : calibration::geometry_scenes(window, options.study)) {
    jobs.push_back({scene.name, "geometry", scene, options.folder + "/runs/" + scene.name, false, false, {}});
    if (static_cast<int>(jobs.size() - 1) % n_parts == part - 1) own.push_back(jobs.back());
  }
  std::error_code error;
  std::filesystem::create_directories(options.folder + "/runs", error);
  if (error) throw IoError("cannot make " + options.folder + "/runs: " + error.message());
  JobRunner runner(own, console);
  watch_interrupts();
  runner.run();

  const auto study = calibration::geometry_study(rows_of(jobs, console), window, options.study);
  scene::write_text(calibration::to_json(study).dump(2) + "\n", options.folder + "/geometry.json");
  scene::write_text(calibration::to_csv(study), options.folder + "/geometry.csv");
  console.data(console.json ? calibration::to_json(study).dump(2) + "\n" : calibration::describe(study));
  if (!study.rows.empty() && python({"report.quick", "geometry", options.folder}) != 0)
    console.warn("the picture in " + options.folder + " was not made");
  if (interrupted())
    throw Error(ExitCode::interrupted, "interrupted; the same command goes on where it stopped");
  for (const auto &job : own)
    if (!job.done) throw SolverStopped(job.name + " did not end well: " + job.failure);
}

} // namespace

void add_geometry(CLI::App &app, Console &console) {
  auto *verb =
      app.add_subcommand("geometry", "k_i and e over rim and slider dimensions, yield stress and speed");
  auto options = std::make_shared<Options>();
  verb->add_option("BEARING", options->bearing, "a TOML file or a built-in bearing")->capture_default_str();
  verb->add_option("-o,--output", options->folder, "results folder")->capture_default_str();
  verb->add_option("--samples", options->study.samples, "impacts by finite elements, about a minute each")
      ->capture_default_str();
  verb->add_option("--range", options->ranges,
                   "NAME=LOW:HIGH of rim_height, rim_thickness, slider_diameter, contact_band "
                   "(mm), yield_stress, tangent_modulus (MPa), speed (m/s); repeatable");
  verb->add_option("--strain-limit", options->study.strain_limit,
                   "plastic strain at which a rim counts as lost")
      ->capture_default_str();
  verb->add_option("--shard", options->shard, "I/N: every N-th run from the I-th on, with the same -o");
  console.add_common(*verb);
  console.add_json(*verb);
  console.add_overrides(*verb);
  verb->callback([options, &console] { run_geometry(*options, console); });
}

} // namespace rimpact::app
