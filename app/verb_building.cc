// rimpact building SCENE: a building on bearings, one under each of its columns, moved as the scene says.
#include "app/folder_claim.h"
#include "app/verb.h"
#include "buildings/frame_tables.h"
#include "buildings/regular_building.h"
#include "buildings/simulate.h"
#include "files/error.h"
#include "files/json_text.h"
#include "scene/doubts.h"
#include <fmt/format.h>

namespace rimpact::app {
namespace {

std::string describe(const scene::Scene &scene, const buildings::Frame &frame, const Summary &s,
                     const std::string &folder) {
  const auto &all = s.extra.at("building");
  std::string text =
      fmt::format("{}: {:.0f} kN on {} bearings; Park-Wen friction with an elastic slip of {:g} mm\n", frame.name,
                  1e-3 * all.at("weight_N").get<double>(), all.at("bearings").size(), 1e3 * scene.reduced.elastic_slip);
  text += fmt::format("base shear {:.1f} kN, overturning moment {:.0f} kN m, {} impact(s); {}\n",
                      1e-3 * s.peak_lateral_force, 1e-3 * all.at("peak_overturning_N_m").get<double>(),
                      s.impacts.size(), folder);
  text += "bearing      at x, y [m]   travel [mm]   N at rest, least, largest [kN]    impacts  rim force [kN]  lifted "
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
  number = 0;
  for (const auto &f : all.at("floors"))
    text += fmt::format("floor {}: drift {:.2f} mm, acceleration {:.2f} m/s2, shear of its storey {:.1f} kN\n",
                        ++number, 1e3 * f.at("peak_drift_m").get<double>(),
                        f.at("peak_acceleration_m_s2").get<double>(), 1e-3 * f.at("peak_shear_N").get<double>());
  return text;
}

void add_warnings(const scene::Scene &scene, reduced::ReducedRun &run, Console &console) {
  auto &warnings = run.summary.extra["warnings"] = nlohmann::json::array();
  if (!run.summary.impacts.empty())
    for (const auto &doubt : scene::doubts_of_element(scene)) warnings.push_back(doubt);
  if (const auto doubt = doubt_of_ledger(run.summary.energy.value_or(EnergyLedger()));
      doubt && run.summary.status == "done")
    warnings.push_back(*doubt);
  for (const auto &warning : warnings) console.warn(warning.get<std::string>());
  for (const auto &sentence : scene.remarks) warnings.push_back(sentence);
}

} // namespace

void add_building(CLI::App &app, Console &console) {
  struct Options {
    std::string scene, frame = "thesis-2.4", folder;
  };
  auto *verb =
      app.add_subcommand("building", "a linear building on bearings, one under each column, moved as a scene says");
  auto options = std::make_shared<Options>();
  verb->add_option("SCENE", options->scene, "a TOML file or a built-in scene: ground motion, bearing, [reduced]")
      ->required();
  verb->add_option("--frame", options->frame, "a building file, or a built-in one")->capture_default_str();
  verb->add_option("-o,--output", options->folder, "run folder (default results/<scene>-<building>)");
  console.add_common(*verb);
  console.add_json(*verb);
  console.add_overrides(*verb);
  console.add_force(*verb);
  verb->callback([options, &console] {
    console.overrides.insert(console.overrides.begin(), "reduced.friction=\"park-wen\""); // what a common base takes
    const scene::Scene scene = console.load(options->scene);
    const auto frame = buildings::make_frame(buildings::load_building(options->frame));
    const std::string folder =
        options->folder.empty() ? default_folder(scene.name + "-" + frame.name) : options->folder;
    const auto claim =
        claim_for_run({.given = options->scene, .folder = folder, .force = console.force}, scene, console);
    auto run = buildings::simulate(frame, scene);
    run.summary.rung = "building", run.summary.extra["building"]["name"] = frame.name;
    add_warnings(scene, run, console);
    write_run_folder(folder, scene, run.response, run.summary);
    buildings::write_tables(frame, folder);
    console.data(console.json ? json_text(to_json(run.summary)) : describe(scene, frame, run.summary, folder));
    if (run.summary.status == "stopped") throw SolverStopped(run.summary.reason + "; what is before it is kept");
  });
}

} // namespace rimpact::app
