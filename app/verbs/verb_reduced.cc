// rimpact reduced SCENE: a scene by the reduced model, or a fleet of them (--sweep).
#include "app/console/child_process.h"
#include "app/jobs/bounds_runs.h"
#include "app/jobs/folder_claim.h"
#include "app/jobs/sweep_runs.h"
#include "app/verbs/catalogue.h"
#include "app/words/impact_words.h"
#include "io/files/error.h"
#include "io/files/json_text.h"
#include "reduced_models/bearings/node_kinematics.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/motion/integrator_check.h"
#include "reduced_models/record/run_doubts.h"
#include "reduced_models/simulate.h"
#include "responses/run_folder.h"
#include "scene/case_description.h"
#include "scene/doubts.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

std::string describe(const Summary &s, const scene::Scene &scene, const std::string &folder) {
  std::string text =
      fmt::format("{}: peak displacement {:.2f} mm, peak lateral force {:.1f} kN, {} impact(s); {}\n", scene.name,
                  1e3 * s.peak_displacement, 1e-3 * s.peak_lateral_force, s.impacts.size(), folder);
  const bool is_dynamic = scene.excitation.is_dynamic();
  for (const auto &i : s.impacts)
    text += fmt::format("  {} {:7.1f} deg  {}  {:.1f} kN  {:.3f} mm\n", when(i, is_dynamic), i.direction_deg,
                        how_fast(i, is_dynamic, 4), 1e-3 * i.peak_force, 1e3 * i.peak_penetration);
  if (s.extra.contains("integrator")) text += reduced::integrator_in_words(s.extra.at("integrator")) + "\n";
  return text;
}

/// What the run's folder says of itself besides its numbers, also on the screen.
void tell_doubts(const scene::Scene &scene, reduced::ReducedRun &run, Console &console) {
  reduced::add_doubts(scene, run.response, run.summary);
  auto &warnings = run.summary.extra["warnings"];
  for (const auto &warning : warnings) console.warn(warning.get<std::string>());
  for (const auto &sentences : {scene.remarks, scene::doubts(scene)}) // said when the scene was read
    for (const auto &sentence : sentences) warnings.push_back(sentence);
}

struct ReducedOptions {
  std::string scene, folder, model;
  SweepOptions sweep;
  std::vector<double> nodes; // [mm]
  std::vector<std::string> bounds;
  bool picture = false;
};

/// The scene's run, written into a folder and doubted.
Summary run_into(const ReducedOptions &options, const scene::Scene &scene, const std::string &folder,
                 Console &console) {
  const auto claim = claim_for_run({.given = options.scene, .folder = folder, .force = console.force}, scene, console);
  auto run = reduced::simulate(scene);
  if (!options.nodes.empty())
    reduced::add_nodal_moments(run.response, {options.nodes[0] / 1e3, options.nodes[1] / 1e3});
  tell_doubts(scene, run, console);
  write_run_folder(folder, scene, run.response, run.summary);
  if (options.picture && python({"report.quick", "reduced", folder}) != 0)
    throw IoError("the picture in " + folder + " was not made");
  return run.summary;
}

void run_reduced(const ReducedOptions &options, Console &console) {
  for (const double height : options.nodes)
    if (!std::isfinite(height)) throw InputError("--nodes takes two heights in mm, not " + std::to_string(height));
  const scene::Scene scene = console.load(options.scene);
  if (!options.nodes.empty() && scene.rigid_bodies())
    throw InputError("--nodes is for bearings of one dish: reduced.model \"" + word(scene.reduced.model) +
                     "\" passes moments through both plates");
  const std::string folder = options.folder.empty() ? default_folder(scene.name) + "-reduced" : options.folder;
  if (!options.bounds.empty())
    return run_bounds(
        {options.bounds, options.folder.empty() ? folder + "-bounds" : folder, options.picture}, scene,
        [&](const scene::Scene &one, const std::string &place) { return run_into(options, one, place, console); },
        console);
  const Summary s = run_into(options, scene, folder, console);
  console.data(console.json ? json_text(to_json(s)) : scene::describe_case(scene) + describe(s, scene, folder));
  if (s.status == RunStatus::stopped) throw SolverStopped(s.reason + "; what is before it is kept");
}

void add_reduced(CLI::App &verb, Console &console) {
  auto options = std::make_shared<ReducedOptions>();
  verb.add_option("SCENE", options->scene, "a TOML file or a built-in scene")->required();
  verb.add_option("-o,--output", options->folder, "run folder (default results/<scene>-reduced)");
  auto *nodes = verb.add_option("--nodes", options->nodes,
                                "BELOW,ABOVE: also the moments at nodes so many mm from the dish's vertex (P-Delta)")
                    ->delimiter(',')
                    ->expected(2)
                    ->check(CLI::Range(0.0, 1e5));
  verb.add_option("--model", options->model, "see rimpact list models");
  verb.add_flag("--png", options->picture, "also draw response.png, of a sweep fleet.png");
  auto *sweep = add_sweep_options(verb, options->sweep)->excludes(nodes);
  add_bounds_option(verb, options->bounds)->excludes(sweep);
  console.add_common(verb);
  console.add_json(verb);
  console.add_overrides(verb);
  console.add_force(verb);
  verb.callback([options, &console] {
    if (!options->model.empty()) console.overrides.push_back("reduced.model=\"" + options->model + "\"");
    if (!options->sweep.sweep.empty())
      return sweep_runs(options->sweep,
                        {.scene = options->scene,
                         .folder = options->folder,
                         .name = std::filesystem::path(options->scene).stem().string(),
                         .picture = options->picture},
                        fleets::reduced_models(), console);
    run_reduced(*options, console);
  });
}

} // namespace

const Verb reduced_verb{{.name = "reduced",
                         .help = "a scene by the reduced model, in about a millisecond",
                         .examples =
                             "rimpact reduced ricker-0.78g-1.0s --set excitation.scale=1.05 -o my-run --png\n"
                             "rimpact reduced my-case/scene.toml --calibration my-case/main/calibration\n"
                             "rimpact reduced my-case/scene.toml --sweep excitation.scale=0.8:1.2:9 -o my-sweep",
                         .next = "rimpact report {}",
                         .next_of_sweep = "rimpact.load_fleet(FOLDER) in Python reads its table.csv"},
                        add_reduced};

} // namespace rimpact::app
