// rimpact compare A B [...]: what differs between scenes, then metrics between their responses; with -o, pictures.
#include "app/compare_picture.h"
#include "app/job_runner.h"
#include "app/scene_differences.h"
#include "app/verb.h"
#include "calibration/data/measured_run.h"
#include "calibration/data/metrics.h"
#include "files/digest.h"
#include "files/error.h"
#include "files/file.h"
#include "files/json_text.h"
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace rimpact::app {
namespace {

using nlohmann::json;

/// What is compared: a response, and the scene it is of where that is known.
struct Item {
  std::string path, scene; ///< the scene's text, resolved; empty: not known
  std::string carried;     ///< by how many bearings; empty: not known
  Response response;
};

/// Signals every comparison reads, and the CSV columns that hold them.
void require_signals(const Item &item) {
  constexpr std::array needed{std::pair{"displacement_x", "ux_m"}, std::pair{"displacement_y", "uy_m"},
                              std::pair{"force_x", "Fx_N"},        std::pair{"force_y", "Fy_N"},
                              std::pair{"impact_x", "Ix_N"},       std::pair{"impact_y", "Iy_N"}};
  for (const auto &[signal, column] : needed)
    if (!item.response.has(signal))
      throw DataError(
          fmt::format("{}: no signal {} (CSV column {}); compare needs time_s, ux_m, uy_m, Fx_N, Fy_N, Ix_N and Iy_N",
                      item.path, signal, column));
}

/// With every default written out, so that a scene of an older version differs in what was changed only.
std::string resolved(const std::string &text, const std::string &path) {
  try {
    return scene::to_toml(scene::parse_scene(text, path));
  } catch (const Error &) { // a record that is no longer there: its text tells as much
    return text;
  }
}

/// What the scene's load does not say: a building's bearings carry shares of it.
std::string carried(const std::string &folder) {
  std::error_code ignored;
  if (!std::filesystem::exists(std::filesystem::path(folder) / "summary.json", ignored)) return {};
  const json summary = summary_of(folder);
  const auto building = summary.find("building");
  if (building == summary.end()) return "one bearing";
  double weight = 0;
  for (const auto &bearing : building->at("bearings")) weight += bearing.value("static_normal_force_N", 0.0);
  std::string tables;
  for (const char *name : {"nodes.csv", "elements.csv", "diaphragms.csv"})
    if (const auto path = std::filesystem::path(folder) / name; std::filesystem::exists(path, ignored))
      tables += read_file(path.string());
  constexpr int short_hash = 8; // of the frame: tells two of the same weight apart
  return fmt::format("{} bearings under {:.4g} kN, frame {}", building->at("bearings").size(), weight / 1e3,
                     sha256(tables).substr(0, short_hash));
}

Item read_item(const std::string &path) {
  namespace fs = std::filesystem;
  Item item{.path = path, .scene = {}, .response = {}};
  if (calibration::is_mapping(path)) {
    auto run = calibration::read_measured(path, {});
    item.scene = scene::to_toml(run.scene);
    item.response = std::move(run.response);
  } else {
    item.response = read_response(path);
    const fs::path beside = fs::path(path) / "scene.toml";
    std::error_code ignored;
    if (fs::exists(beside, ignored))
      item.scene = read_file(beside.string());
    else if (const auto kept = item.response.meta.find("scene"); kept != item.response.meta.end())
      item.scene = kept->second;
    if (!item.scene.empty()) item.scene = resolved(item.scene, path);
    item.carried = carried(path);
  }
  require_signals(item);
  return item;
}

/// L_c [m]: as given [mm], else of the first item that knows its scene, else the default bearing's.
double capacity_of(const std::vector<Item> &items, std::optional<double> given) {
  if (given) return 1e-3 * *given;
  for (const auto &item : items)
    if (!item.scene.empty()) return scene::parse_scene(item.scene, item.path).lateral_capacity();
  return scene::builtin_bearing("shfps-225").lateral_capacity();
}

struct Compared {
  std::string path;
  std::vector<Difference> differences;
  calibration::Comparison metrics;
};

/// A figure of the comparison as an engineer reads it.
struct Row {
  const char *title, *meaning;
  std::optional<double> calibration::Comparison::*figure;
  double factor;
  const char *unit;
};
constexpr std::array rows{
    Row{"peak impact force", "of the hardest impact", &calibration::Comparison::peak_force_error, 100, "%"},
    Row{"peak displacement", "horizontal", &calibration::Comparison::peak_displacement_error, 100, "%"},
    Row{"rebound speed", "of the hardest impact", &calibration::Comparison::rebound_error, 100, "%"},
    Row{"first touch", "later than A's", &calibration::Comparison::touch_time_difference, 1e3, "ms"},
    Row{"displacement, rms", "difference over L_c, from first touch to 0.5 s after release",
        &calibration::Comparison::nrmse_displacement, 100, "% of L_c"},
    Row{"impact force, rms", "difference over A's peak, the same span", &calibration::Comparison::nrmse_force, 100,
        "% of peak"},
    Row{"lateral force, rms", "difference over A's peak, the same span", &calibration::Comparison::nrmse_lateral_force,
        100, "% of peak"},
};

/// A for the reference, B, C, ... for the others.
std::string letter(std::size_t k) {
  return std::string(1, static_cast<char>('A' + std::min<std::size_t>(k, 25)));
}

std::string text_of(const std::string &reference, const std::vector<Compared> &all) {
  std::string text = fmt::format("A: {}\n", reference);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string name = letter(k + 1);
    text += fmt::format("{}: {}\n", name, all[k].path);
    for (const auto &d : all[k].differences)
      text += fmt::format("   {:34s} A {:<22s} {} {}{}\n", d.key, d.a, name, d.b, d.comparable ? "" : "   !");
  }
  text += fmt::format("{:20s}", "");
  for (std::size_t k = 0; k < all.size(); ++k) text += fmt::format(" {:>20s}", letter(k + 1) + " against A");
  text += "\n";
  for (const auto &row : rows) {
    text += fmt::format("{:20s}", row.title);
    for (const auto &each : all) {
      const auto value = each.metrics.*row.figure;
      text += fmt::format(" {:>20s}", value ? fmt::format("{:+.2f} {}", row.factor * *value + 0.0, row.unit) : "-");
    }
    text += fmt::format("   {}\n", row.meaning);
  }
  return text;
}

/// Throws InputError naming what makes two runs incomparable.
void refuse_others(const std::string &reference, const Compared &each) {
  std::string keys;
  int more = 0;
  for (const auto &d : each.differences) {
    if (d.comparable) continue;
    constexpr int most = 6;
    if (++more <= most) keys += fmt::format("{}{} ({} against {})", keys.empty() ? "" : ", ", d.key, d.a, d.b);
  }
  if (more == 0) return;
  throw InputError(fmt::format("{} and {} are runs of different things: {}{}; --anyway compares them", reference,
                               each.path, keys, more > 6 ? fmt::format(" and {} more", more - 6) : ""));
}

struct CompareOptions {
  std::vector<std::string> paths;
  std::string folder; ///< of the pictures and the page; empty: none
  std::optional<double> capacity_mm;
  bool anyway = false;
};

std::string draw(const std::string &folder, const std::vector<Item> &items, const std::vector<Compared> &all,
                 double capacity) {
  std::vector<ComparedCurve> curves;
  for (std::size_t k = 0; k < items.size(); ++k) {
    json said{{"path", items[k].path}};
    if (k > 0) {
      said["metrics"] = calibration::to_json(all[k - 1].metrics);
      said["metrics"].erase("notes");
      said["notes"] = all[k - 1].metrics.notes;
      said["differences"] = to_json(all[k - 1].differences);
    }
    curves.push_back({.name = letter(k), .scene = items[k].scene, .said = said, .response = &items[k].response});
  }
  return draw_comparison(folder, curves, capacity);
}

void run_compare(const CompareOptions &options, Console &console) {
  if (options.paths.size() < 2) throw InputError("compare needs two or more: the first is the reference");
  if (options.paths.size() > 26) throw InputError("compare takes 26 responses or fewer");
  constexpr double most = 1e4; // [mm]
  if (const auto given = options.capacity_mm; given && !(*given > 0 && *given <= most))
    throw InputError(fmt::format("--capacity-mm {:g} must be > 0 and <= {:g}", *given, most));
  std::vector<Item> items;
  for (const auto &path : options.paths) items.push_back(read_item(path));
  const double capacity = capacity_of(items, options.capacity_mm);
  const Item &reference = items.front();
  std::vector<Compared> all;
  for (std::size_t k = 1; k < items.size(); ++k) {
    Compared each{.path = items[k].path, .differences = {}, .metrics = {}};
    if (reference.scene.empty() || items[k].scene.empty())
      console.message(fmt::format("{} holds no scene: nothing says that {} and {} are of one bearing, load and motion",
                                  reference.scene.empty() ? reference.path : each.path, reference.path, each.path));
    else
      each.differences = differences(reference.scene, items[k].scene);
    if (!reference.carried.empty() && !items[k].carried.empty() && reference.carried != items[k].carried)
      each.differences.insert(each.differences.begin(), {"building", reference.carried, items[k].carried, false});
    if (!options.anyway) refuse_others(reference.path, each);
    each.metrics = calibration::compare(reference.response, items[k].response, capacity);
    all.push_back(each);
  }
  const std::string page = options.folder.empty() ? "" : draw(options.folder, items, all, capacity);
  if (console.json) {
    json table = calibration::to_json(all.front().metrics);
    table["differences"] = to_json(all.front().differences);
    table["candidates"] = json::array();
    for (const auto &each : all) {
      json candidate = calibration::to_json(each.metrics);
      candidate["path"] = each.path;
      candidate["differences"] = to_json(each.differences);
      table["candidates"].push_back(candidate);
    }
    if (!page.empty()) table["page"] = page;
    return console.data(json_text(table));
  }
  console.data(text_of(reference.path, all));
  if (!page.empty()) console.data(page + "\n");
  for (const auto &each : all)
    for (const auto &note : each.metrics.notes) console.message(each.path + ": " + note);
}

} // namespace

void add_compare(CLI::App &app, Console &console) {
  auto *verb =
      app.add_subcommand("compare", "metrics between responses; what differs between their scenes comes first");
  auto options = std::make_shared<CompareOptions>();
  verb->add_option("RUN", options->paths,
                   "the reference, then what is compared with it: run folders, .h5, .csv or mapping files")
      ->required();
  verb->add_option("-o,--output", options->folder, "a folder for pictures and one HTML page of all curves");
  verb->add_option("--capacity-mm", options->capacity_mm, "L_c, where no scene is known");
  verb->add_flag("--anyway", options->anyway, "compare runs of different bearings, loads or excitations");
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([options, &console] { run_compare(*options, console); });
}

} // namespace rimpact::app
