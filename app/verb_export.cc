// rimpact export DIR --opensees|--sap2000|--etabs|--csv: a calibrated rim, and its bearing, for other programs.
#include "app/export_building.h"
#include "app/verb.h"
#include "calibration/export/comment.h"
#include "calibration/export/csi.h"
#include "calibration/export/opensees.h"
#include "files/file.h"
#include "responses/build_version.h"
#include "responses/response.h"
#include "scene/rim_identity.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

namespace fs = std::filesystem;
using calibration::Dish;
using calibration::ExportedRim;
using calibration::PulseCheck;
using calibration::SelfCheck;
using nlohmann::json;

struct ExportOptions {
  std::string folder, out, law, scene;
  std::optional<double> mass, load; ///< [kg], [kN]
  bool opensees = false, sap2000 = false, etabs = false, csv = false;
};

/// The folder that holds calibration.json: DIR itself, or the one a `main` leaves in it.
std::string calibration_folder(const std::string &folder) {
  for (const auto &path : {fs::path(folder), fs::path(folder) / "calibration"})
    if (fs::exists(path / "calibration.json")) return path.string();
  throw DataError(folder + ": no calibration.json in it; run `rimpact calibrate` first");
}

json read_calibration(const std::string &folder) {
  const std::string path = (fs::path(folder) / "calibration.json").string();
  auto json = nlohmann::json::parse(read_file(path), nullptr, false);
  if (json.is_discarded()) throw DataError(path + ": not valid JSON");
  return json;
}

scene::Scene scene_or_bearing(const std::string &where) {
  scene::Scene scene;
  try {
    return scene::load_scene(where);
  } catch (const InputError &) {
    scene.bearing = scene::load_bearing(where); // its message stands where both fail
  }
  return scene;
}

/// The scene whose dish the bearing has: given, or of a fitted run, or a built-in bearing; of this rim by its identity.
std::optional<scene::Scene> scene_of(const ExportOptions &options, const json &calibration, const ExportedRim &rim) {
  if (!options.scene.empty()) {
    auto scene = scene_or_bearing(options.scene);
    if (const auto identity = scene::rim_identity(scene.bearing); identity != rim.rim_identity)
      throw InputError(fmt::format("--scene {}: its rim is {}, the calibration's {}: another bearing", options.scene,
                                   identity, rim.rim_identity));
    return scene;
  }
  std::vector<std::string> candidates;
  if (calibration.contains("fit") && calibration["fit"].is_object())
    for (const auto &[run, check] : calibration["fit"].items())
      for (const auto &path : {fs::path(run), fs::path(options.folder) / fs::path(run).filename(),
                               fs::path(options.folder) / ".." / fs::path(run).filename()})
        candidates.push_back((path / "scene.toml").string()); // also where runs and calibration were moved together
  candidates.push_back((fs::path(options.folder) / "fitted-scene.toml").string());
  candidates.push_back(rim.bearing);
  for (const auto &candidate : candidates) try {
      const bool file = candidate != rim.bearing;
      if (file && !fs::exists(candidate)) continue;
      scene::Scene scene;
      if (file)
        scene = scene::load_scene(candidate);
      else
        scene.bearing = scene::builtin_bearing(candidate);
      if (scene::rim_identity(scene.bearing) == rim.rim_identity) return scene;
    } catch (const Error &) { // a run that cannot be read any more says nothing of the bearing
    }
  return std::nullopt;
}

/// The files are for one load: that of a scene which is given for its dish is not taken unasked.
void warn_of_load(const ExportOptions &options, const scene::Scene &scene, const ExportedRim &rim, Console &console) {
  if (options.scene.empty() || options.load || options.mass) return;
  const double own = scene.load.vertical; // a bearing's file, and a scene that names no load, have the default one
  if (own == scene::Load{}.vertical || std::abs(own / rim.vertical - 1) < 1e-3) return;
  console.warn(fmt::format("{} carries {:.6g} kN, the calibration's bearing {:.6g} kN, for which the files are; --load "
                           "{:.6g} makes them for the scene's",
                           options.scene, own / 1e3, rim.vertical / 1e3, own / 1e3));
}

/// A mass and a load that do not go together, or with the calibration: a slip of the unit.
void warn_of_units(const ExportOptions &options, const ExportedRim &rim, Console &console) {
  constexpr double alike = 20; // a slip of the unit is of hundreds
  const auto odd = [&](double ratio) { return ratio > alike || ratio < 1 / alike; };
  if (options.mass && odd(rim.mass / rim.fitted_mass))
    console.warn(fmt::format("--mass {:.6g} is {:.2g} times the {:.6g} kg of the calibration: is it in kg?", rim.mass,
                             rim.mass / rim.fitted_mass, rim.fitted_mass));
  if (const double ratio = rim.vertical / (rim.mass * rim.gravity); options.load && odd(ratio))
    console.warn(fmt::format("--load {:.6g} kN is {:.2g} times what {:.6g} kg weigh: are the units right?",
                             *options.load, ratio, rim.mass));
}

/// The command without the program's folder, and what made the file.
std::vector<std::string> header(const Console &console) {
  return {console.command(), build_version()};
}

/// The bearing carries what the files are for, with the terms of pad and socket that the calibration has.
void take_answer(scene::Scene &scene, const json &calibration, ExportedRim &rim) {
  scene.load.vertical = rim.vertical, scene.load.mass = rim.mass, scene.load.gravity = rim.gravity;
  calibration::take_stack(scene, calibration["answer"]);
  for (const auto &line : calibration::stack_effect(scene, rim)) rim.statement.push_back(calibration::plain_text(line));
  rim.tuned_to = std::max(rim.to, calibration::fastest_touch(scene, rim));
  if (rim.tuned_to > rim.to)
    rim.statement.push_back(
        fmt::format("DOUBT: pulses of the self-check bring the model to its rim at up to {:.3g} m/s, "
                    "beyond {:.3g} m/s. Springs and links are tuned to the law as far as that.",
                    rim.tuned_to, rim.to));
}

std::string refusal_of(const SelfCheck &check) {
  return fmt::format(
      "The rim only: the whole bearing is refused, for under pulses its peak force differs by {:.0f} % "
      "from the model's, more than {:.0f} %. Its dish is too far from an ellipsoid, or its springs from the law.",
      100 * check.pulses->worst(), 100 * PulseCheck::refused);
}

void export_to(const ExportOptions &options, const json &calibration, Console &console) {
  const auto vertical = options.load ? std::optional(1e3 * *options.load) : std::nullopt;
  ExportedRim rim =
      calibration::exported_rim(calibration, {.law = options.law, .mass = options.mass, .vertical = vertical});
  warn_of_units(options, rim, console);
  std::optional<Dish> dish;
  auto scene = scene_of(options, calibration, rim);
  if (scene) {
    warn_of_load(options, *scene, rim, console);
    constexpr double farthest = 0.2; // a fitted place of the rim is within millimetres
    if (const double own = scene->lateral_capacity(); std::abs(rim.lateral_capacity / own - 1) > farthest)
      throw DataError(fmt::format(
          "calibration.json: lateral_capacity_m of answer.law.element, {:g}, is not that of the bearing, {:g}",
          rim.lateral_capacity, own));
    take_answer(*scene, calibration, rim);
    dish = calibration::dish_of(*scene, rim.lateral_capacity);
    if (!dish->assumed_pad.empty() && (options.opensees || options.sap2000 || options.etabs))
      console.warn("vertical stiffness of the bearing:" + dish->assumed_pad);
  }
  auto head = header(console);
  if (!dish && (options.opensees || options.sap2000 || options.etabs)) {
    head.push_back("The rim only: the bearing's dish is not known here. Give it with --scene SCENE_OR_BEARING.");
    console.warn(head.back());
  }
  std::vector<std::pair<std::string, std::string>> files;
  std::vector<SelfCheck> checks;
  if (options.opensees) {
    auto springs = calibration::opensees_rim(rim);
    auto riding = dish;
    auto own_head = head;
    if (dish) springs.check.pulses = pulse_check(*scene, rim, flown_bearing(rim, springs, *dish));
    if (springs.check.pulses && springs.check.pulses->worst() > PulseCheck::refused) {
      own_head.push_back(refusal_of(springs.check));
      console.warn(own_head.back());
      riding.reset();
    }
    files.emplace_back("impact.tcl", calibration::opensees_tcl(rim, springs, riding, own_head));
    files.emplace_back("impact.py", calibration::opensees_python(rim, springs, riding, own_head));
    checks.push_back(springs.check);
  }
  if (options.sap2000 || options.etabs) {
    auto links = calibration::csi_rim(rim);
    if (dish) links.check.pulses = pulse_check(*scene, rim, flown_bearing(rim, links, *dish));
    if (options.sap2000) files.emplace_back("bearing.s2k", calibration::sap2000(rim, links, dish, head));
    if (options.etabs) files.emplace_back("bearing.e2k", calibration::etabs(rim, links, dish, head));
    files.emplace_back("rim-link.csv", calibration::link_csv(rim, links, dish, head));
    checks.push_back(links.check);
  }
  if (options.csv) files.emplace_back("law.csv", calibration::law_csv(rim, head));
  std::error_code failure;
  fs::create_directories(options.out, failure);
  if (failure) throw IoError(fmt::format("{}: {}", options.out, failure.message()));
  json table = {{"law", rim.law().name},
                {"mass_kg", rim.mass},
                {"from_m_s", rim.from},
                {"to_m_s", rim.to},
                {"whole_bearing", dish.has_value()},
                {"files", json::array()},
                {"self_checks", json::array()}};
  std::string written;
  for (const auto &[name, text] : files) {
    const std::string path = (fs::path(options.out) / name).string();
    write_atomically(text, path);
    written += path + "\n", table["files"].push_back(path);
  }
  for (const auto &check : checks) {
    table["self_checks"].push_back(check.json());
    if (check.serves())
      console.message(check.sentence());
    else
      console.warn(check.sentence());
    for (const auto &doubt : check.doubts()) console.warn(doubt);
  }
  console.data(console.json ? table.dump(2, ' ', false, json::error_handler_t::replace) + "\n" : written);
}

} // namespace

void add_export(CLI::App &app, Console &console) {
  auto options = std::make_shared<ExportOptions>();
  auto *verb = app.add_subcommand("export", "a calibrated bearing for other programs");
  verb->add_option("DIR", options->folder, "folder of a calibration, or of a run of rimpact building (--opensees)")
      ->required();
  verb->add_option("-o,--output", options->out, "folder to write into; default: where calibration.json lies");
  verb->add_flag("--opensees", options->opensees, "impact.tcl and impact.py: friction pendulum and rim");
  verb->add_flag("--sap2000", options->sap2000, "bearing.s2k: link properties, and rim-link.csv to paste");
  verb->add_flag("--etabs", options->etabs, "bearing.e2k: link properties, and rim-link.csv to paste");
  verb->add_flag("--csv", options->csv, "law.csv: force over penetration, loading and unloading from five depths");
  verb->add_option("--law", options->law,
                   "another of the ranked laws, or \"pair\": the constant pair; default: the calibration's answer");
  verb->add_option("--mass", options->mass,
                   "mass that the bearing carries [kg]; default: the calibration's, or W / g of --load");
  verb->add_option("--load", options->load,
                   "dead load W of the bearing [kN]; default: the calibration's, or m g of --mass");
  verb->add_option("--scene", options->scene,
                   "scene or bearing with the dish and its friction; default: that of a fitted run");
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([options, &console] {
    if (!(options->opensees || options->sap2000 || options->etabs || options->csv))
      throw InputError("export: say for what, one or more of --opensees, --sap2000, --etabs, --csv");
    if (is_building_folder(options->folder)) {
      if (options->sap2000 || options->etabs || options->csv || !options->law.empty() || options->mass ||
          options->load || !options->scene.empty())
        throw InputError("export: of a building's run only its bearings for --opensees, under their own weights");
      return export_building_bearings(options->folder, options->out.empty() ? options->folder : options->out,
                                      header(console), console);
    }
    options->folder = calibration_folder(options->folder);
    if (options->out.empty()) options->out = options->folder;
    try {
      export_to(*options, read_calibration(options->folder), console);
    } catch (const DataError &error) {
      throw DataError(options->folder + ": " + error.what());
    }
  });
}

} // namespace rimpact::app
