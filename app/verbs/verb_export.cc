// rimpact export DIR --opensees|--sap2000|--etabs|--csv|--dxf: a calibrated rim, and its bearing, for other programs.
#include "app/jobs/export_building.h"
#include "app/jobs/export_scene.h"
#include "app/jobs/export_section.h"
#include "app/verbs/catalogue.h"
#include "calibration/export/comment.h"
#include "calibration/export/csi.h"
#include "calibration/export/law_csv.h"
#include "calibration/export/opensees.h"
#include "calibration/export/section_dxf.h"
#include "calibration/export/self_check_text.h"
#include "io/files/file.h"
#include "responses/build_version.h"
#include "responses/response.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <tuple>

namespace rimpact::app {
namespace {

namespace fs = std::filesystem;
using calibration::Dish;
using calibration::ExportedRim;
using calibration::PulseCheck;
using calibration::SelfCheck;
using nlohmann::json;

/// The folder that holds calibration.json: DIR itself, or the one a `main` leaves in it. Empty: neither does.
std::string calibration_folder(const std::string &folder) {
  for (const auto &path : {fs::path(folder), fs::path(folder) / "calibration"})
    if (fs::exists(path / "calibration.json")) return path.string();
  return "";
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

using Head = std::vector<std::string>;

/// What one export is asked for, what it writes, and how far each form is from law and model.
struct Exported {
  const ExportOptions &options;
  const ExportedRim &rim;
  const std::optional<ExportScene> &bearing;
  Head head;
  Console &console;
  std::vector<std::pair<std::string, std::string>> files = {}; ///< name, text
  std::vector<SelfCheck> checks = {};
};

/// The dish for the file, flown with the rim `with`; none, with a line in the head, where its pulses refuse it.
template <class Rim> std::optional<Dish> flown_dish(Exported &out, Rim &with, const char *why, Head &head) {
  if (!out.bearing) return {};
  const Dish &dish = out.bearing->dish;
  PulseCheck &pulses =
      with.check.pulses.emplace(pulse_check(out.bearing->scene, out.rim, flown_bearing(out.rim, with, dish)));
  pulses.written = out.options.anyway || !pulses.refuses();
  if (pulses.written) return dish;
  head.push_back(fmt::format("The rim only: the whole bearing is refused, for under pulses its peak force differs by "
                             "{:.0f} % from the model's, more than {:.0f} %. {} --anyway writes it all the same.",
                             100 * pulses.worst_judged(), 100 * PulseCheck::refused, why));
  out.console.warn(head.back());
  return {};
}

void add_opensees(Exported &out) {
  Head head = out.head;
  auto springs = calibration::opensees_rim(out.rim);
  const auto dish =
      flown_dish(out, springs, "Its dish is too far from an ellipsoid, or its springs from the law.", head);
  out.files.emplace_back("impact.tcl", calibration::opensees_tcl(out.rim, springs, dish, head));
  out.files.emplace_back("impact.py", calibration::opensees_python(out.rim, springs, dish, head));
  out.checks.push_back(springs.check);
}

void add_csi(Exported &out) {
  Head head = out.head;
  auto links = calibration::csi_rim(out.rim);
  const auto dish = flown_dish(out, links,
                               "The slider of links stays in its plane, where the bearing's rises: fly the bearing in "
                               "OpenSees, and take here the rim alone.",
                               head);
  if (out.options.sap2000) out.files.emplace_back("bearing.s2k", calibration::sap2000(out.rim, links, dish, head));
  if (out.options.etabs) out.files.emplace_back("bearing.e2k", calibration::etabs(out.rim, links, dish, head));
  out.files.emplace_back("rim-link.csv", calibration::link_csv(out.rim, links, dish, head));
  out.checks.push_back(links.check);
}

void add_dxf(Exported &out) {
  if (!out.bearing) throw InputError("--dxf: the bearing is not known here. Give it with --scene SCENE_OR_BEARING.");
  out.files.emplace_back("section.dxf", calibration::section_dxf(out.bearing->scene.bearing, out.head));
}

void add_files(Exported &out) {
  if (out.options.opensees) add_opensees(out);
  if (out.options.sap2000 || out.options.etabs) add_csi(out);
  if (out.options.csv) out.files.emplace_back("law.csv", calibration::law_csv(out.rim, out.head));
  if (out.options.dxf) add_dxf(out);
}

void write(const Exported &out, json table) {
  const auto &[options, console] = std::tie(out.options, out.console);
  std::error_code failure;
  fs::create_directories(options.out, failure);
  if (failure) throw IoError(fmt::format("{}: {}", options.out, failure.message()));
  table["files"] = table["self_checks"] = json::array();
  std::string written;
  for (const auto &[name, text] : out.files) {
    const std::string path = (fs::path(options.out) / name).string();
    write_atomically(text, path);
    written += path + "\n", table["files"].push_back(path);
  }
  for (const auto &check : out.checks) {
    table["self_checks"].push_back(to_json(check));
    if (check.serves())
      console.message(sentence_of(check));
    else
      console.warn(sentence_of(check));
    for (const auto &doubt : doubts_of(check)) console.warn(doubt);
  }
  console.data(console.json ? table.dump(2, ' ', false, json::error_handler_t::replace) + "\n" : written);
}

/// The twins' law beside the answer's, which says of which steel each is.
std::string twin_folder(const scene::StoredAnswer &answer) {
  return answer.steel_band ? answer.steel_band->calibration : "";
}

/// The spring of the other steel into a folder beside the answer's files.
void export_twin(ExportOptions options, const std::string &twin, Console &console);

void export_to(const ExportOptions &options, Console &console) {
  const auto calibration = scene::read_calibration(options.folder);
  const auto vertical = options.load ? std::optional(1e3 * *options.load) : std::nullopt;
  ExportedRim rim =
      calibration::exported_rim(calibration, {.law = options.law, .mass = options.mass, .vertical = vertical});
  warn_of_units(options, rim, console);
  const auto bearing = export_scene(options, calibration, rim, console);
  const bool for_programs = options.opensees || options.sap2000 || options.etabs;
  Head head = header(console);
  if (!bearing && for_programs) {
    head.push_back("The rim only: the bearing's dish is not known here. Give it with --scene SCENE_OR_BEARING.");
    console.warn(head.back());
  }
  Exported out{.options = options, .rim = rim, .bearing = bearing, .head = head, .console = console};
  try {
    add_files(out);
  } catch (const DataError &error) {
    throw DataError(calibration.file + ": " + error.what());
  }
  const bool whole = bearing && std::all_of(out.checks.begin(), out.checks.end(),
                                            [](const auto &check) { return check.pulses && check.pulses->written; });
  const json table = {{"law", rim.law().name},
                      {"mass_kg", rim.mass},
                      {"from_m_s", rim.from},
                      {"to_m_s", rim.to},
                      {"whole_bearing", whole}};
  write(out, table);
  if (const std::string twin = twin_folder(*calibration.answer); !twin.empty() && options.law.empty())
    export_twin(options, twin, console);
}

void export_twin(ExportOptions options, const std::string &twin, Console &console) {
  options.folder = (fs::path(options.folder) / twin).string();
  options.out = (fs::path(options.out) / twin).string();
  console.message(
      fmt::format("two springs: {} is of the {} steel; take the static one for the travel, the fast one for "
                  "the force",
                  options.out, twin));
  export_to(options, console);
}

void run_export(ExportOptions options, Console &console) {
  if (!(options.opensees || options.sap2000 || options.etabs || options.csv || options.dxf))
    throw InputError("export: say for what, one or more of --opensees, --sap2000, --etabs, --csv, --dxf");
  if (is_building_folder(options.folder)) {
    if (options.asks_a_calibration() || options.dxf)
      throw InputError("export: of a building's run only its bearings for --opensees, under their own weights");
    return export_building_bearings(options.folder, options.out.empty() ? options.folder : options.out, header(console),
                                    console);
  }
  const std::string calibration = calibration_folder(options.folder);
  if (calibration.empty() && options.dxf) return export_section(options, header(console), console);
  if (calibration.empty())
    throw DataError(options.folder + ": no calibration.json in it; run `rimpact calibrate` first");
  options.folder = calibration;
  if (options.out.empty()) options.out = options.folder;
  export_to(options, console);
}

void add_export(CLI::App &verb, Console &console) {
  auto options = std::make_shared<ExportOptions>();
  verb.add_option("DIR", options->folder,
                  "folder of a calibration, or of a run of rimpact building (--opensees); for --dxf alone a bearing, "
                  "scene or case folder too")
      ->required();
  verb.add_option("-o,--output", options->out, "folder to write into; default: where calibration.json lies");
  verb.add_flag("--opensees", options->opensees, "impact.tcl and impact.py: friction pendulum and rim");
  verb.add_flag("--sap2000", options->sap2000, "bearing.s2k: link properties, and rim-link.csv to paste");
  verb.add_flag("--etabs", options->etabs, "bearing.e2k: link properties, and rim-link.csv to paste");
  verb.add_flag("--csv", options->csv, "law.csv: force over penetration, loading and unloading from five depths");
  verb.add_flag("--dxf", options->dxf, "section.dxf: the bearing's section as drawn, in mm");
  verb.add_option("--law", options->law,
                  "another of the ranked laws, or \"pair\": the constant pair; default: the calibration's answer");
  verb.add_option("--mass", options->mass,
                  "mass that the bearing carries [kg]; default: the calibration's, or W / g of --load");
  verb.add_option("--load", options->load,
                  "dead load W of the bearing [kN]; default: the calibration's, or m g of --mass");
  verb.add_option("--scene", options->scene,
                  "scene or bearing with the dish and its friction; default: that of a fitted run");
  verb.add_flag("--anyway", options->anyway,
                "the whole bearing also where its self-check refuses it, with its differences as doubts");
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([options, &console] { run_export(*options, console); });
}

} // namespace

const Verb export_verb{{.name = "export",
                        .help = "a calibrated bearing for other programs",
                        .examples = "rimpact export results/main/calibration --opensees --csv -o for-opensees\n"
                                    "rimpact export shfps-225 --dxf -o drawing",
                        .next = "check the first analysis against the self-check's table"},
                       add_export};

} // namespace rimpact::app
