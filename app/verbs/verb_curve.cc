// rimpact curve [BEARING]: the rim's quasi-static force curve with unloadings, flown by impact_law = "curve".
#include "app/console/interrupts.h"
#include "app/console/progress.h"
#include "app/jobs/given_case.h"
#include "app/verbs/catalogue.h"
#include "app/verbs/fe_verb_texts.h"
#include "fe_contact/drive/curve_push.h"
#include "fe_contact/drive/fast_curve.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "scene/scene.h"
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace rimpact::app {
namespace {

struct CurveOptions {
  std::string bearing = "shfps-225", folder;
  fe::CurveOrder order;
  std::optional<double> mass;     ///< --mass-kg; none: the scene's
  std::optional<double> at_speed; ///< of the steel's rate [m/s]; none: the curve of static steel alone
  std::string mass_from;
};

nlohmann::json answer_of(const CurveOptions &options, const reduced::RimCurveFile &file, double seconds) {
  const laws::RimCurve held(file.held);
  const auto speed = [&](const laws::RimCurve &curve) {
    return std::sqrt(2 * curve.work(curve.range()) / options.order.mass);
  };
  nlohmann::json deepest{{"held", held.range()}, {"dish", nullptr}};
  nlohmann::json fastest{{"held", speed(held)}, {"dish", nullptr}};
  if (!options.order.held_only) {
    const laws::RimCurve dish(file.dish);
    deepest["dish"] = dish.range(), fastest["dish"] = speed(dish);
  }
  return {{"file", options.folder + "/curve.h5"},
          {"bearing", file.bearing},
          {"rim_identity", file.rim_identity},
          {"mesh", file.mesh},
          {"mass_kg", options.order.mass},
          {"mass_from", options.mass_from},
          {"deepest_m", deepest},
          {"fastest_m_s", fastest},
          {"n_unloadings", file.held.unloading.size()},
          {"largest_strain", file.strain.strain.empty() ? nlohmann::json() : nlohmann::json(file.strain.strain.back())},
          {"error",
           {{"mesh_force", file.errors.mesh_force ? nlohmann::json(*file.errors.mesh_force) : nlohmann::json()},
            {"left_out_rebound", file.errors.left_out_rebound}}},
          {"wall_time_s", seconds}};
}

/// Writes the curve at the speed that is asked for; what it is of, or null.
nlohmann::json write_fast_curve(const CurveOptions &options, const reduced::RimCurveFile &slow,
                                const scene::Bearing &bearing) {
  if (!options.at_speed) return nullptr;
  fe::FastCurve fast = fe::fast_curve(slow, bearing, options.order.mass, *options.at_speed);
  const std::string file = options.folder + "/curve-fast.h5";
  fast.file.made_by += fmt::format(", steel at {:.3g} 1/s as of an approach at {:g} m/s", fast.rate, *options.at_speed);
  reduced::write_rim_curve(fast.file, file);
  return {{"file", file}, {"speed_m_s", *options.at_speed}, {"rate_per_s", fast.rate}, {"factor", fast.factor}};
}

std::string describe_fast(const nlohmann::json &fast) {
  if (fast.is_null()) return {};
  return fmt::format(
      "at {:g} m/s the rim strains at {:.3g} 1/s, its flow stress is {:.3f} times the static one: {} is the "
      "curve of that speed\n",
      fast["speed_m_s"].get<double>(), fast["rate_per_s"].get<double>(), fast["factor"].get<double>(),
      fast["file"].get<std::string>());
}

/// "18.72 mm along the dish and 18.29 mm held"; of one path that one alone.
std::string by_path(const nlohmann::json &values, double factor, int digits, const char *unit) {
  std::string text;
  for (const auto &[name, words] : {std::pair{"dish", "along the dish"}, std::pair{"held", "held"}})
    if (!values[name].is_null())
      text += fmt::format("{}{:.{}f} {} {}", text.empty() ? "" : " and ", factor * values[name].get<double>(), digits,
                          unit, words);
  return text;
}

std::string describe(const nlohmann::json &answer) {
  const auto &error = answer["error"];
  return fmt::format("{}: {}, pressed to {}: {:g} kg ({}) at up to {}\n"
                     "error: mesh {}, unloading between the pushed depths {:.2f} % of "
                     "the rebound; {}\n"
                     "use it: --set reduced.impact_law=curve --set reduced.impact_curve={}\n",
                     answer["bearing"].get<std::string>(), answer["mesh"].get<std::string>(),
                     by_path(answer["deepest_m"], 1e3, 2, "mm"), answer["mass_kg"].get<double>(),
                     answer["mass_from"].get<std::string>(), by_path(answer["fastest_m_s"], 1, 3, "m/s"),
                     error["mesh_force"].is_null() ? "not estimated"
                                                   : fmt::format("{:.2f} % of the force (from the next coarser mesh)",
                                                                 1e2 * error["mesh_force"].get<double>()),
                     1e2 * error["left_out_rebound"].get<double>(), duration(answer["wall_time_s"].get<double>()),
                     answer["file"].get<std::string>());
}

/// The bearing to be pushed; the mass that its speeds are of is typed, else the scene's.
scene::Scene scene_to_push(CurveOptions &options, Console &console) {
  const GivenCase given = given_case(options.bearing, {});
  require_bearing(given.scene, "curve");
  if (!options.mass)
    for (const auto &warning : given.warnings) console.warn(warning);
  options.order.mass = options.mass.value_or(given.scene.load.mass);
  options.mass_from = options.mass ? "--mass-kg" : given.mass_from;
  scene::Scene scene = scene::load_scene("rim-push");
  scene.bearing = given.scene.bearing;
  return scene;
}

void curve(CurveOptions &options, Console &console) {
  scene::Scene scene = scene_to_push(options, console);
  if (console.mesh >= 0) scene.model.mesh = console.mesh;
  scene.validate();
  fe::check_supported(scene);
  const scene::Material &steel = scene.bearing.rim_steel();
  if (options.at_speed) fe::require_rate(scene.bearing);
  if (options.at_speed && *options.at_speed > options.order.speed)
    throw InputError(fmt::format("--at-speed {:g} is beyond --speed {:g}, which the curve is pushed for",
                                 *options.at_speed, options.order.speed));
  if (steel.knows_rate() && !options.at_speed)
    console.warn(fmt::format(
        "the curve is pushed infinitely slowly: the steel's law of the rate ({}) has no part in it (--at-speed)",
        in_words(steel.rate)));
  if (options.folder.empty()) options.folder = default_folder(scene.bearing.name) + "-curve";
  const std::filesystem::path folder(options.folder);
  if (std::filesystem::exists(folder / "curve.h5") && !console.force)
    throw InputError(options.folder + " holds a curve already; --force replaces it, -o names another folder");
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw IoError("cannot make the folder " + options.folder + ": " + failed.message());
  std::filesystem::remove(folder / "curve-fast.h5", failed); // of an earlier curve
  watch_interrupts();
  ProgressLine line(console.quiet);
  fe::RunOptions run;
  run.interrupted = &interrupted();
  run.progress = [&](const fe::Progress &p) {
    line.show(fmt::format("{}: {:.2f} mm, {:.0f} kN, {:.0f} % of the work", word(p.phase), -1e3 * p.gap, p.force / 1e3,
                          1e2 * std::min(1.0, p.time / p.end_time)));
  };
  const auto start = std::chrono::steady_clock::now();
  const auto file = fe::push_rim_curve(scene, options.order, run);
  line.finish();
  reduced::write_rim_curve(file, (folder / "curve.h5").string());
  reduced::write_rim_curve_csv(file, (folder / "curve.csv").string());
  auto answer =
      answer_of(options, file, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  answer["fast"] = write_fast_curve(options, file, scene.bearing);
  write_atomically(json_text(answer), (folder / "curve.json").string());
  console.data(console.json ? json_text(answer) : describe(answer) + describe_fast(answer["fast"]));
}

void add_curve(CLI::App &verb, Console &console) {
  auto options = std::make_shared<CurveOptions>();
  verb.add_option("BEARING", options->bearing,
                  "a bearing, scene or case folder: built-in or a TOML file; a scene's load.mass_kg is taken");
  verb.add_option("-o,--output", options->folder,
                  "folder for curve.h5, curve.csv and curve.json (default results/<bearing>-curve)");
  verb.add_option("--mass-kg", options->mass, "supported mass that --speed is of (default: the scene's)")
      ->check(CLI::Range(1.0, 1e9));
  verb.add_option("--speed", options->order.speed, "fastest approach to be stopped [m/s]")
      ->check(CLI::Range(1e-3, 10.0));
  verb.add_option("--at-speed", options->at_speed,
                  "beside it, curve-fast.h5 of the steel's rate at this approach speed [m/s]")
      ->check(CLI::Range(1e-3, 10.0));
  verb.add_option("--unloadings", options->order.unloadings, "depths to unload from")->check(CLI::Range(3, 100));
  verb.add_flag("--held", options->order.held_only,
                "the path with the height held alone, for windows without weight: half the time; no estimate of the "
                "mesh's error");
  verb.add_option("--mesh", console.mesh, "1 | 2 | 3: finer and more expensive")->check(CLI::Range(0, 3));
  console.add_common(verb);
  console.add_json(verb);
  console.add_force(verb);
  verb.callback([options, &console] { curve(*options, console); });
}

} // namespace

const Verb curve_verb{text_of_curve, add_curve};

} // namespace rimpact::app
