// rimpact compare A B [...]: what differs between scenes, then metrics between their responses; with -o, pictures.
#include "app/jobs/compare_picture.h"
#include "app/jobs/compared_run.h"
#include "app/verbs/catalogue.h"
#include "app/words/compare_limits.h"
#include "calibration/data/metrics.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "scene/bearing_catalogue.h"
#include "scene/scene.h"
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
  for (const auto &figure : compared_figures()) {
    text += fmt::format("{:20s}", figure.title);
    for (const auto &each : all) text += fmt::format(" {:>20s}", in_words(figure, value_of(figure, each.metrics)));
    text += fmt::format("   {}\n", figure.meaning);
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
  std::vector<std::string> limits; ///< --max
  std::string junit;               ///< a file; empty: none
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

/// Throws InputError where the runs are of different things, unless --anyway.
Compared compared(const ComparedRun &reference, const ComparedRun &item, double capacity, bool anyway,
                  Console &console) {
  Compared each{.path = item.path, .differences = {}, .metrics = {}};
  if (reference.scene.empty() || item.scene.empty())
    console.message(fmt::format("{} holds no scene: nothing says that {} and {} are of one bearing, load and motion",
                                reference.scene.empty() ? reference.path : each.path, reference.path, each.path));
  else
    each.differences = differences_between(reference, item);
  if (!reference.carried.empty() && !item.carried.empty() && reference.carried != item.carried)
    each.differences.insert(each.differences.begin(), {"building", reference.carried, item.carried, false});
  if (!anyway) refuse_others(reference.path, each);
  each.metrics = calibration::compare(reference.response, item.response, capacity);
  return each;
}

/// Of each candidate: a run that is no result, and one that is held against such a run, keep no limit.
std::vector<Judged> judged(const std::vector<FigureLimit> &limits, const std::vector<ComparedRun> &items,
                           const std::vector<Compared> &all) {
  std::vector<Judged> verdicts;
  for (std::size_t k = 1; k < items.size(); ++k) {
    const std::string doubt = items[0].doubt.empty() ? items[k].doubt : "of the reference: " + items[0].doubt;
    verdicts.push_back(judge(limits, all[k - 1].metrics, doubt));
    verdicts.back().name = letter(k), verdicts.back().path = items[k].path;
  }
  return verdicts;
}

json json_of(const Compared &each, const Judged &verdicts) {
  json said = calibration::to_json(each.metrics);
  said["differences"] = to_json(each.differences);
  said["figures"] = figures_json(each.metrics), said["limits"] = to_json(verdicts);
  return said;
}

json json_of(const std::vector<ComparedRun> &items, const std::vector<Compared> &all,
             const std::vector<Judged> &verdicts) {
  json table = json_of(all.front(), verdicts.front());
  table["doubts"] = json::object();
  for (const auto &item : items)
    if (!item.doubt.empty()) table["doubts"][item.path] = item.doubt;
  table["candidates"] = json::array();
  for (std::size_t k = 0; k < all.size(); ++k) {
    json candidate = json_of(all[k], verdicts[k]);
    candidate["path"] = all[k].path;
    table["candidates"].push_back(candidate);
  }
  return table;
}

void require(const CompareOptions &options) {
  if (options.paths.size() < 2) throw InputError("compare needs two or more: the first is the reference");
  if (options.paths.size() > 26) throw InputError("compare takes 26 responses or fewer");
  constexpr double most = 1e4; // [mm]
  if (const auto given = options.capacity_mm; given && !(*given > 0 && *given <= most))
    throw InputError(fmt::format("--capacity-mm {:g} must be > 0 and <= {:g}", *given, most));
  if (!options.junit.empty() && options.limits.empty())
    throw InputError("--junit writes what came of limits: give some, as --max peak=5,rebound=10");
}

void run_compare(const CompareOptions &options, Console &console) {
  require(options);
  const auto limits = limits_of(options.limits);
  std::vector<ComparedRun> items;
  for (const auto &path : options.paths) items.push_back(read_compared(path));
  const double capacity = capacity_of(items, options.capacity_mm, console);
  for (const auto &item : items)
    if (!item.doubt.empty()) console.warn(item.path + ": " + item.doubt);
  std::vector<Compared> all;
  for (std::size_t k = 1; k < items.size(); ++k)
    all.push_back(compared(items.front(), items[k], capacity, options.anyway, console));
  const auto verdicts = judged(limits, items, all);
  const std::string page = options.folder.empty() ? "" : draw(options.folder, items, all, capacity);
  if (!options.junit.empty()) write_atomically(junit_of(items.front().path, verdicts), options.junit);
  if (console.json) {
    json table = json_of(items, all, verdicts);
    table["lateral_capacity_m"] = capacity;
    if (!page.empty()) table["page"] = page;
    console.data(json_text(table));
  } else {
    console.data(text_of(items.front().path, all) + text_of(verdicts));
    if (!page.empty()) console.data(page + "\n");
    for (const auto &each : all)
      for (const auto &note : each.metrics.notes) console.message(each.path + ": " + note);
  }
  require_met(verdicts);
}

void add_compare(CLI::App &verb, Console &console) {
  auto options = std::make_shared<CompareOptions>();
  verb.add_option("RUN", options->paths,
                  "the reference, then what is compared with it: run folders, .h5, .csv or mapping files")
      ->required();
  verb.add_option("-o,--output", options->folder, "a folder for pictures and one HTML page of all curves");
  verb.add_option("--capacity-mm", options->capacity_mm, "L_c, where no scene is known");
  verb.add_option(
          "--max", options->limits,
          "limits as peak=5,rebound=10,time_ms=2 (per cent, but for time): exit code 5 where one is not met; of "
          "peak, displacement, approach, rebound, restitution, time_ms, rms_displacement, rms_force, rms_lateral")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb.add_option("--junit", options->junit, "a file for what came of the limits, as JUnit XML");
  verb.add_flag("--anyway", options->anyway, "compare runs of different bearings, loads or excitations");
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([options, &console] { run_compare(*options, console); });
}

} // namespace

const Verb compare_verb{{.name = "compare",
                         .help = "metrics between responses; what differs between their scenes comes first",
                         .examples =
                             "rimpact compare my-run my-reduced\nrimpact compare my-run test-07.toml --json\n"
                             "rimpact compare reference my-run --max peak=5,rebound=10,time_ms=2 --junit compare.xml",
                         .next = "rimpact report DIR draws one of them"},
                        add_compare};

} // namespace rimpact::app
