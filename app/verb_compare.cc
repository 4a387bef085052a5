// rimpact compare A B [...]: what differs between scenes, then metrics between their responses; with -o, pictures.
#include "app/compare_picture.h"
#include "app/compared_run.h"
#include "app/verb.h"
#include "calibration/data/metrics.h"
#include "files/error.h"
#include "files/json_text.h"
#include "scene/scene.h"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace rimpact::app {
namespace {

using nlohmann::json;

/// L_c [m]: as given [mm], else of the first item that knows its scene, else the default bearing's, which is said.
double capacity_of(const std::vector<ComparedRun> &items, std::optional<double> given, Console &console) {
  if (given) return 1e-3 * *given;
  for (const auto &item : items)
    if (!item.scene.empty()) return scene::parse_scene(item.scene, item.path).lateral_capacity();
  const double usual = scene::builtin_bearing("shfps-225").lateral_capacity();
  console.warn(
      fmt::format("no scene says how large the bearing is: L_c = {:g} mm, that of shfps-225, is assumed; --capacity-mm "
                  "gives yours",
                  1e3 * usual));
  return usual;
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
    Row{"approach speed", "of the hardest impact, at its touch", &calibration::Comparison::approach_speed_error, 100,
        "%"},
    Row{"rebound speed", "of the hardest impact, at its release", &calibration::Comparison::rebound_error, 100, "%"},
    Row{"restitution", "rebound over approach speed, of the hardest impact",
        &calibration::Comparison::restitution_error, 100, "%"},
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

std::string draw(const std::string &folder, const std::vector<ComparedRun> &items, const std::vector<Compared> &all,
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
  std::vector<ComparedRun> items;
  for (const auto &path : options.paths) items.push_back(read_compared(path));
  const double capacity = capacity_of(items, options.capacity_mm, console);
  for (const auto &item : items)
    if (!item.doubt.empty()) console.warn(item.path + ": " + item.doubt);
  const ComparedRun &reference = items.front();
  std::vector<Compared> all;
  for (std::size_t k = 1; k < items.size(); ++k) {
    Compared each{.path = items[k].path, .differences = {}, .metrics = {}};
    if (reference.scene.empty() || items[k].scene.empty())
      console.message(fmt::format("{} holds no scene: nothing says that {} and {} are of one bearing, load and motion",
                                  reference.scene.empty() ? reference.path : each.path, reference.path, each.path));
    else
      each.differences = differences_between(reference, items[k]);
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
    table["lateral_capacity_m"] = capacity;
    table["doubts"] = json::object();
    for (const auto &item : items)
      if (!item.doubt.empty()) table["doubts"][item.path] = item.doubt;
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
