// rimpact building SCENE: a building on bearings, one under each of its columns, moved as the scene says.
#include "app/console/child_process.h"
#include "app/jobs/bounds_runs.h"
#include "app/jobs/folder_claim.h"
#include "app/jobs/sweep_runs.h"
#include "app/verbs/catalogue.h"
#include "app/words/set_keys.h"
#include "buildings/bearing_doubts.h"
#include "buildings/frame_doubts.h"
#include "buildings/frame_source.h"
#include "buildings/frame_tables.h"
#include "buildings/simulate.h"
#include "buildings/summary_row.h"
#include "buildings/vtk_series.h"
#include "io/files/digest.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "reduced_models/simulate.h"
#include "responses/identity.h"
#include "responses/limits.h"
#include "responses/run_folder.h"
#include "scene/toml_writer.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::app {
namespace {

std::string friction_in_words(const scene::ReducedSettings &reduced) {
  if (reduced.friction == scene::Friction::coulomb) return "Coulomb's friction in implicit steps";
  return fmt::format("Park-Wen friction with an elastic slip of {:g} mm", 1e3 * reduced.elastic_slip);
}

std::string describe(const scene::Scene &scene, const buildings::Frame &frame, const Summary &s,
                     const std::string &folder) {
  const auto &all = s.extra.at("building");
  std::string text =
      fmt::format("{}: {:.0f} kN on {} bearings; {}\n", frame.name, 1e-3 * all.at("weight_N").get<double>(),
                  all.at("bearings").size(), friction_in_words(scene.reduced));
  text += fmt::format("base shear {:.1f} kN, overturning moment {:.0f} kN m, {} impact(s); {}\n",
                      1e-3 * s.peak_lateral_force, 1e-3 * all.at("peak_overturning_N_m").get<double>(),
                      s.impacts.size(), folder);
  text += "bearing     arm x, y [m]   travel [mm]   N at rest, least, largest [kN]    impacts  rim force [kN]  lifted "
          "[mm]\n";
  int number = 0;
  for (const auto &b : all.at("bearings")) {
    const auto value = [&](const char *key, double unit) { return b.at(key).get<double>() / unit; };
    text += fmt::format("{:5}  {:8.2f} {:8.2f}    {:8.2f}     {:8.1f} {:8.1f} {:8.1f}    {:9}    {:9.1f}    {:9.2f}\n",
                        ++number, value("x_m", 1), value("y_m", 1), value("peak_displacement_m", 1e-3),
                        value("static_normal_force_N", 1e3), value("min_normal_force_N", 1e3),
                        value("max_normal_force_N", 1e3), b.at("impacts").get<int>(), value("peak_impact_force_N", 1e3),
                        value("peak_uplift_m", 1e-3));
  }
  if (all.contains("dish_springs"))
    text += fmt::format("every dish stands on a spring of {:g} kN/m (isolator.points times "
                        "isolator.contact_stiffness_kN_per_m{}); vertical forces and overturning follow it\n",
                        1e-3 * all.at("dish_springs").at("stiffness_N_per_m").get<double>(),
                        all.at("dish_springs").at("assumed").get<bool>() ? ", an assumption" : "");
  number = 0;
  for (const auto &f : all.at("floors"))
    text += fmt::format("floor {}: drift {:.2f} mm, acceleration {:.2f} m/s2, shear of its storey {:.1f} kN\n",
                        ++number, 1e3 * f.at("peak_drift_m").get<double>(),
                        f.at("peak_acceleration_m_s2").get<double>(), 1e-3 * f.at("peak_shear_N").get<double>());
  if (!all.contains("inelastic")) return text;
  for (const auto &s : all.at("inelastic").at("sections"))
    text += fmt::format("{}: {} ends of members yielded, largest ductility {:.2f}, plastic rotation {:.2f} mrad\n",
                        s.at("name").get<std::string>(), s.at("yielded_ends").get<int>(),
                        s.at("peak_ductility").get<double>(), 1e3 * s.at("peak_plastic_rotation_rad").get<double>());
  if (const auto &assumed = all.at("inelastic").at("assumed"); !assumed.empty())
    text += fmt::format("assumed of the frame: {}\n", fmt::join(assumed.get<std::vector<std::string>>(), "; "));
  return text;
}

void add_warnings(const scene::Scene &scene, const buildings::Frame &frame, const std::vector<scene::Scene> &bearings,
                  reduced::ReducedRun &run, Console &console) {
  std::vector<double> reactions;
  for (const auto &bearing : run.summary.extra["building"].at("bearings"))
    reactions.push_back(bearing.at("static_normal_force_N"));
  auto &warnings = run.summary.extra["warnings"] = nlohmann::json::array();
  if (!run.summary.impacts.empty())
    for (const auto &doubt : buildings::doubts_of_elements(bearings, reactions)) warnings.push_back(doubt);
  if (const auto doubt = doubt_of_ledger(run.summary.energy.value_or(EnergyLedger()));
      doubt && run.summary.status == RunStatus::done)
    warnings.push_back(*doubt);
  judge(scene, run.summary);
  for (const auto &warning : warnings) console.warn(warning.get<std::string>());
  for (const auto &said : {buildings::doubts_of(frame), scene.remarks}) // before the run
    for (const auto &sentence : said) warnings.push_back(sentence);
}

struct BuildingOptions {
  std::string scene, frame = "thesis-2.4", folder;
  SweepOptions sweep;
  std::vector<std::string> bounds;
  double vtk_step = 0; // [ms]
  bool picture = false;
};

/// Of a frame's table in a run's folder, as the identity names it.
std::string path_of_table(const std::string &folder, const std::string &name) {
  return std::filesystem::absolute(std::filesystem::path(folder) / name).string();
}

/// Beside what the scene reads: the frame as its tables stand in the folder, and every bearing of its own, by contents.
Identity identity_of_building(const scene::Scene &scene, const buildings::Frame &frame,
                              const std::vector<scene::Scene> &bearings, const std::string &folder) {
  Identity identity = identity_of(scene);
  for (const auto &[name, text] : buildings::tables_of(frame))
    identity.inputs[path_of_table(folder, name)] = sha256(text);
  const std::string common = to_toml(scene);
  for (std::size_t b = 0; b < bearings.size(); ++b)
    if (const std::string own = to_toml(bearings[b]); own != common)
      identity.inputs[fmt::format("bearing {}", b + 1)] = sha256(own);
  return identity;
}

/// A folder holds one building: another one's run is not written over it.
void require_same_building(const std::string &folder, const buildings::Frame &frame, bool force) {
  const auto path = std::filesystem::path(folder) / "summary.json";
  std::error_code none;
  if (force || !std::filesystem::exists(path, none)) return;
  const auto kept = nlohmann::json::parse(read_file(path.string()), nullptr, false);
  if (!kept.is_object() || !kept.contains("identity")) return;
  const auto there = identity_from(kept["identity"]);
  if (!there) return;
  for (const auto &[name, text] : buildings::tables_of(frame)) {
    const auto old = there->inputs.find(path_of_table(folder, name));
    if (old != there->inputs.end() && old->second != sha256(text))
      throw InputError(
          fmt::format("{} holds a run of another building: its {} differs; --force replaces it", folder, name));
  }
}

/// What stands beside the run's own files: the frame, its members' forces, its shape. An earlier run's goes first.
void write_building(const buildings::Frame &frame, const buildings::BuildingResult &result, const std::string &folder) {
  std::error_code none;
  for (const char *name : {"building.png", "elevation.csv", "hinges.csv", "members.csv"})
    std::filesystem::remove(std::filesystem::path(folder) / name, none);
  buildings::write_tables(frame, folder);
  buildings::write_members(frame, result.trace.members, folder + "/members.csv");
  if (frame.inelastic()) buildings::write_hinges(frame, result.trace.hinges, folder + "/hinges.csv");
  buildings::write_elevation(frame, result.model, result.trace.hardest, folder + "/elevation.csv");
  if (result.trace.step > 0) buildings::write_vtk_series(frame, result.model, result.trace, folder);
}

/// Its doubts are said before anything is run: they name what a refusal or a long run comes from.
buildings::Frame doubted_frame(const std::string &where, Console &console) {
  auto frame = buildings::load_frame(where);
  for (const auto &doubt : buildings::doubts_of(frame)) console.warn(doubt);
  return frame;
}

std::string not_of_a_building(const std::string &key) {
  if (is_in(key, "load.vertical_kN") || is_in(key, "load.mass_kg"))
    return "a building's bearings carry what stands on them; its masses are the frame's (--frame)";
  return "";
}

/// The frame, doubted; the console then knows what its bearings read of the scene.
buildings::Frame frame_of(const BuildingOptions &options, Console &console) {
  auto frame = doubted_frame(options.frame, console);
  const auto use = buildings::isolator_use(frame);
  const bool coulomb = std::any_of(console.overrides.begin(), console.overrides.end(), [](const std::string &set) {
    return set.starts_with("reduced.friction=") && set.find("coulomb") != std::string::npos;
  });
  console.springs_are_read = use.springs || use.whole || coulomb, console.isolator_is_read = use.whole;
  return frame;
}

/// A building's frame stays as it is; the sweep moves the scene's keys, and the bearings' with them.
void sweep_building(const BuildingOptions &options, Console &console) {
  const auto frame = frame_of(options, console);
  fleets::FleetModel model{
      .name = "building " + frame.name, .run = [&](const scene::Scene &scene) {
        return buildings::row_summary(
            buildings::simulate(frame, scene, buildings::bearings_of(frame, scene), false).summary);
      }};
  for (const auto &[name, text] : buildings::tables_of(frame)) model.inputs[frame.name + "/" + name] = sha256(text);
  std::error_code none;
  for (const auto &node : frame.nodes) // a name is in the tables; what a file holds is not
    if (std::filesystem::is_regular_file(node.bearing, none)) model.inputs[node.bearing] = sha256_of_file(node.bearing);
  sweep_runs(options.sweep,
             {.scene = options.scene,
              .folder = options.folder,
              .name = std::filesystem::path(options.scene).stem().string() + "-" + frame.name,
              .picture = options.picture,
              .why_unread = not_of_a_building},
             model, console);
}

/// The building's run, written into a folder and doubted.
Summary run_building_into(const BuildingOptions &options, const buildings::Frame &frame, const scene::Scene &scene,
                          const std::string &folder, Console &console) {
  const auto bearings = buildings::bearings_of(frame, scene);
  const auto claim = claim_for_run({.given = options.scene, .folder = folder, .force = console.force}, scene, console);
  const Identity identity = identity_of_building(scene, frame, bearings, folder);
  require_same_building(folder, frame, console.force);
  auto result = buildings::simulate_whole(frame, scene, bearings, 1e-3 * options.vtk_step);
  auto &run = result.run;
  run.summary.extra["building"]["name"] = frame.name;
  run.summary.extra["identity"] = to_json(identity);
  run.summary.extra["building"]["hardest_instant_s"] = result.trace.hardest.t;
  add_warnings(scene, frame, bearings, run, console);
  write_run_folder(folder, scene, run.response, run.summary);
  write_building(frame, result, folder);
  if (options.picture && python({"report.quick", "building", folder}) != 0)
    throw IoError("the picture in " + folder + " was not made");
  return run.summary;
}

void run_building(const BuildingOptions &options, Console &console) {
  refuse_unread(console.overrides, "building", not_of_a_building);
  console.overrides.insert(console.overrides.begin(), "reduced.friction=\"park-wen\""); // what a common base takes
  console.load_is_shared = true;
  if (!options.sweep.sweep.empty()) return sweep_building(options, console);
  const auto frame = frame_of(options, console);
  const scene::Scene scene = console.load(options.scene);
  const std::string folder = options.folder.empty() ? default_folder(scene.name + "-" + frame.name) : options.folder;
  if (!options.bounds.empty())
    return run_bounds(
        {options.bounds, options.folder.empty() ? folder + "-bounds" : folder, options.picture}, scene,
        [&](const scene::Scene &one, const std::string &place) {
          return run_building_into(options, frame, one, place, console);
        },
        console);
  const Summary s = run_building_into(options, frame, scene, folder, console);
  console.data(console.json ? json_text(to_json(s)) : describe(scene, frame, s, folder));
  if (s.status == RunStatus::stopped) throw SolverStopped(s.reason + "; what is before it is kept");
}

void add_building(CLI::App &verb, Console &console) {
  auto options = std::make_shared<BuildingOptions>();
  verb.add_option("SCENE", options->scene, "a TOML file or a built-in scene: ground motion, bearing, [reduced]")
      ->required();
  verb.add_option("--frame", options->frame,
                  "thesis-2.4, thesis-3.5 and thesis-3.5-slab (linear), thesis-2.5 (inelastic, in the plane), a TOML "
                  "file of either "
                  "kind, or a folder of nodes.csv, elements.csv, diaphragms.csv")
      ->capture_default_str();
  verb.add_option("-o,--output", options->folder, "run folder (default results/<scene>-<building>)");
  auto *vtk = verb.add_option("--vtk-step", options->vtk_step,
                              "also fields/*.vtu and fields.pvd for ParaView, one every so many ms")
                  ->check(CLI::Range(0.1, 1e6));
  verb.add_flag("--png", options->picture,
                "also draw building.png (plan with orbits, elevation at the hardest impact), of a sweep fleet.png");
  auto *sweep = add_sweep_options(verb, options->sweep)->excludes(vtk);
  add_bounds_option(verb, options->bounds)->excludes(sweep);
  console.add_common(verb);
  console.add_json(verb);
  console.add_overrides(verb);
  console.add_force(verb);
  verb.callback([options, &console] { run_building(*options, console); });
}

} // namespace

const Verb building_verb{{.name = "building",
                          .help = "a building on bearings, one under each column, moved as a scene says",
                          .examples = "rimpact building pulse-bidirectional -o my-building",
                          .next = "rimpact report {}"},
                         add_building};

} // namespace rimpact::app
