#include "app/jobs/bounds_runs.h"
#include "app/console/child_process.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "io/files/key_list.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::app {
namespace {

using scene::Bound;

struct BoundRun {
  Bound bound;
  double factor;
  std::string folder;
  Summary summary;
};

/// A number of the table; none: the run has no such thing.
using BoundsValue = std::optional<double>;
struct BoundsRow {
  std::string quantity, unit;
  double factor; ///< from SI to the unit
  std::vector<BoundsValue> values;
};

/// The bounds that words ask for, the nominal run first.
std::vector<Bound> bounds_asked(const std::vector<std::string> &words) {
  std::vector<Bound> bounds{Bound::nominal};
  for (const auto &given : words) {
    const auto bound = parse<Bound>(given);
    if (!bound)
      throw InputError(fmt::format("--bounds {} is none of {}", given, fmt::join(rimpact::words<Bound>(), ", ")));
    if (std::find(bounds.begin(), bounds.end(), *bound) == bounds.end()) bounds.push_back(*bound);
  }
  return bounds;
}

double fastest_rebound_of(const Summary &s) {
  double fastest = 0;
  for (const auto &impact : s.impacts) fastest = std::max(fastest, impact.rebound_speed);
  return fastest;
}

/// Largest of a number over the parts of a building.
BoundsValue largest_of_parts(const Summary &s, const char *parts, const char *key) {
  if (!s.extra.contains("building") || s.extra["building"][parts].empty()) return std::nullopt;
  double most = 0;
  for (const auto &part : s.extra["building"][parts])
    if (part.contains(key) && part[key].is_number()) most = std::max(most, part[key].get<double>());
  return most;
}

BoundsValue number_of(const Summary &s, const char *table, const char *key) {
  if (!s.extra.contains(table) || !s.extra[table].contains(key) || !s.extra[table][key].is_number())
    return std::nullopt;
  return s.extra[table][key].get<double>();
}

std::vector<BoundsRow> bounds_rows(const std::vector<BoundRun> &runs) {
  struct BoundsQuantity {
    const char *name, *unit;
    double factor;
    BoundsValue (*of)(const Summary &s);
  };
  static const BoundsQuantity quantities[] = {
      {"peak displacement", "mm", 1e3, [](const Summary &s) -> BoundsValue { return s.peak_displacement; }},
      {"residual displacement", "mm", 1e3, [](const Summary &s) -> BoundsValue { return s.residual_displacement; }},
      {"peak lateral force", "kN", 1e-3, [](const Summary &s) -> BoundsValue { return s.peak_lateral_force; }},
      {"impacts", "", 1, [](const Summary &s) -> BoundsValue { return static_cast<double>(s.impacts.size()); }},
      {"peak impact force", "kN", 1e-3, [](const Summary &s) { return s.peak_impact_force; }},
      {"fastest rebound", "m/s", 1, [](const Summary &s) -> BoundsValue { return fastest_rebound_of(s); }},
      {"least normal force", "kN", 1e-3, [](const Summary &s) { return s.min_normal_force; }},
      {"overturning moment", "kN m", 1e-3,
       [](const Summary &s) { return number_of(s, "building", "peak_overturning_N_m"); }},
      {"travel of a bearing", "mm", 1e3,
       [](const Summary &s) { return largest_of_parts(s, "bearings", "peak_displacement_m"); }},
      {"uplift of a bearing", "mm", 1e3,
       [](const Summary &s) { return largest_of_parts(s, "bearings", "peak_uplift_m"); }},
      {"storey drift", "mm", 1e3, [](const Summary &s) { return largest_of_parts(s, "floors", "peak_drift_m"); }},
      {"floor acceleration", "m/s2", 1,
       [](const Summary &s) { return largest_of_parts(s, "floors", "peak_acceleration_m_s2"); }},
      {"temperature of the steel", "degC", 1,
       [](const Summary &s) { return number_of(s, "friction", "peak_temperature_C"); }}};
  std::vector<BoundsRow> rows;
  for (const auto &quantity : quantities) {
    BoundsRow row{quantity.name, quantity.unit, quantity.factor, {}};
    for (const auto &run : runs) row.values.push_back(quantity.of(run.summary));
    if (std::any_of(row.values.begin(), row.values.end(), [](const BoundsValue &v) { return v.has_value(); }))
      rows.push_back(std::move(row));
  }
  return rows;
}

std::string bounds_text(const std::vector<BoundRun> &runs, const std::vector<BoundsRow> &rows) {
  std::string text = fmt::format("{:28s}", "friction");
  for (const auto &run : runs)
    text += fmt::format("  {:>14s}", fmt::format("{} x {:.3g}", word(run.bound), run.factor));
  text += "\n";
  for (const auto &row : rows) {
    text += fmt::format("{:28s}", row.unit.empty() ? row.quantity : row.quantity + " [" + row.unit + "]");
    for (const auto &value : row.values)
      text += value ? fmt::format("  {:14.5g}", *value * row.factor) : fmt::format("  {:>14s}", "-");
    text += "\n";
  }
  return text;
}

/// Every key of [bounds] that counts, by its name there; null: not given.
nlohmann::json factors_json(scene::FrictionBounds bounds) {
  nlohmann::json factors{{"standard", word(bounds.standard)}, {"assumed", bounds.assumed()}};
  KeyList list;
  visit(list, bounds);
  for (const KeyEntry &entry : list.entries)
    if (entry.is_number)
      factors[entry.key.name] = entry.value == "inf" ? nlohmann::json() : nlohmann::json::parse(entry.value);
  return factors;
}

nlohmann::json bounds_json(const scene::Scene &scene, const std::vector<BoundRun> &runs,
                           const std::vector<BoundsRow> &rows) {
  nlohmann::json table{{"scene", scene.name}, {"runs", nlohmann::json::array()}, {"rows", nlohmann::json::array()}};
  for (const auto &run : runs)
    table["runs"].push_back({{"bound", word(run.bound)},
                             {"lambda", run.factor},
                             {"folder", run.folder},
                             {"status", word(run.summary.status)},
                             {"reason", run.summary.reason}});
  for (const auto &row : rows) {
    nlohmann::json values = nlohmann::json::object();
    for (std::size_t i = 0; i < runs.size(); ++i)
      values[word(runs[i].bound)] = row.values[i] ? nlohmann::json(*row.values[i] * row.factor) : nlohmann::json();
    table["rows"].push_back({{"quantity", row.quantity}, {"unit", row.unit}, {"values", values}});
  }
  table["factors"] = factors_json(scene.bounds);
  return table;
}

std::string bounds_csv(const std::vector<BoundRun> &runs, const std::vector<BoundsRow> &rows) {
  std::string text = "quantity,unit";
  for (const auto &run : runs) text += "," + std::string(word(run.bound));
  text += "\n";
  for (const auto &row : rows) {
    text += row.quantity + "," + row.unit;
    for (const auto &value : row.values) text += value ? fmt::format(",{:.12g}", *value * row.factor) : ",";
    text += "\n";
  }
  return text;
}

std::string origin_of_bounds(const scene::FrictionBounds &bounds) {
  if (bounds.assumed())
    return "lambda factors of ASCE 7-22, 17.2.8.4, with its commentary's values for unlubricated interfaces of a "
           "manufacturer who is not known: an assumption; give your own in [bounds]";
  return bounds.standard == scene::BoundsStandard::en ? "lambda factors of EN 15129, annex J, as [bounds] gives them"
                                                      : "lambda factors of [bounds]";
}

} // namespace

CLI::Option *add_bounds_option(CLI::App &verb, std::vector<std::string> &words) {
  return verb
      .add_option(
          "--bounds", words,
          "lower,upper: also with friction at the ends of its range ([bounds]), a table of all; -o then holds a "
          "run folder for each")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void run_bounds(const BoundsOrder &order, const scene::Scene &scene, const RunOne &run, Console &console) {
  const auto bounds = bounds_asked(order.words);
  make_folder(order.folder);
  std::vector<BoundRun> runs;
  for (const Bound bound : bounds) {
    BoundRun one{bound, scene.bounds.factor(bound), order.folder + "/" + word(bound), {}};
    scene::Scene moved = at_bound(scene, bound);
    moved.name = scene.name + ", " + word(bound);
    one.summary = run(moved, one.folder);
    runs.push_back(std::move(one));
  }
  const auto rows = bounds_rows(runs);
  auto table = bounds_json(scene, runs, rows);
  table["origin"] = origin_of_bounds(scene.bounds);
  write_atomically(json_text(table), order.folder + "/bounds.json");
  write_atomically(bounds_csv(runs, rows), order.folder + "/bounds.csv");
  if (order.picture && python({"report.quick", "bounds", order.folder}) != 0)
    throw IoError("the picture in " + order.folder + " was not made");
  console.data(console.json ? json_text(table)
                            : bounds_text(runs, rows) + origin_of_bounds(scene.bounds) + "\n" + order.folder + "\n");
  for (const auto &one : runs)
    if (one.summary.status == RunStatus::stopped)
      throw SolverStopped(fmt::format("{} bound: {}; what is before it is kept", word(one.bound), one.summary.reason));
}

} // namespace rimpact::app
