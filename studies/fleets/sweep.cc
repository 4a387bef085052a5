#include "studies/fleets/sweep.h"
#include "io/files/file.h"
#include "io/records/record_library.h"
#include "scene/scene.h"
#include "studies/fleets/correlation.h"
#include "studies/fleets/sweep_reader.h"
#include "studies/fleets/sweep_toml.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace rimpact::fleets {
namespace {

using Point = std::map<std::string, Value>;

/// Every combination of the points of `outer` with those of `inner`, the inner ones changing fastest.
std::vector<Point> product(const std::vector<Point> &outer, const std::vector<Point> &inner,
                           const std::string &origin) {
  if (outer.size() > largest_fleet / inner.size())
    throw InputError(fmt::format("{}: more than {} runs; split the sweep", origin, largest_fleet));
  std::vector<Point> points;
  points.reserve(outer.size() * inner.size());
  for (const auto &a : outer)
    for (const auto &b : inner) {
      points.push_back(a);
      for (const auto &[key, value] : b)
        if (!points.back().emplace(key, value).second)
          throw InputError(fmt::format("{}: {} is set in more than one part of the sweep", origin, key));
    }
  return points;
}

std::vector<Point> case_points(const std::vector<std::vector<Axis>> &cases) {
  std::vector<Point> points;
  for (const auto &axes : cases) {
    points.emplace_back();
    for (const auto &axis : axes) points.back()[axis.key] = axis.values.front();
  }
  return points.empty() ? std::vector<Point>{{}} : points;
}

std::vector<Point> sampled_points(const SweepParts &parts) {
  if (parts.sampled.empty()) return {{}};
  std::vector<Point> points(static_cast<std::size_t>(parts.samples));
  auto unit = latin_hypercube(static_cast<int>(parts.sampled.size()), parts.samples, parts.seed);
  if (!parts.correlation.empty()) unit = correlated(std::move(unit), parts.correlation);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t d = 0; d < parts.sampled.size(); ++d)
      points[i][parts.sampled[d].key] = number_value(parts.sampled[d].distribution.quantile(unit[i][d]));
  return points;
}

void add_linked(Point &point, const LinkedKey &linked) {
  const auto number_of = [&](const std::string &name) {
    if (const auto *number = std::get_if<double>(&point.at(name).cell)) return *number;
    throw InputError(fmt::format("{}: {} uses {}, which is no number", linked.place, linked.key, name));
  };
  double value = linked.factor;
  for (const auto &name : linked.factors) value *= number_of(name);
  if (!linked.divisor.empty()) value /= number_of(linked.divisor);
  if (!std::isfinite(value))
    throw InputError(fmt::format("{}: {} comes out not finite; {} is {}", linked.place, linked.key, linked.divisor,
                                 linked.divisor.empty() ? 0.0 : number_of(linked.divisor)));
  const Value result = number_value(value);
  if (!is_variable(linked.key)) scene::check_assignment(linked.key + "=" + result.toml, linked.place);
  if (!point.emplace(linked.key, result).second)
    throw InputError(fmt::format("{}: {} is set in more than one part of the sweep", linked.place, linked.key));
}

/// Columns of the table that are no keys of a scene.
bool is_label(const std::string &key) {
  return key == "case" || key == "device" || key == "record" || is_variable(key);
}

void require_numbers_along(const Sweep &sweep) {
  if (sweep.fractiles_along.empty()) return;
  const auto place = std::find(sweep.keys.begin(), sweep.keys.end(), sweep.fractiles_along) - sweep.keys.begin();
  for (const auto &run : sweep.runs)
    if (!std::holds_alternative<double>(run[static_cast<std::size_t>(place)].cell))
      throw InputError(fmt::format("{}: fractiles.along: \"{}\" has values that are no numbers", sweep.origin,
                                   sweep.fractiles_along));
}

bool is_record(const std::string &key) {
  return key == "excitation.x" || key == "excitation.y" || key == "excitation.z";
}

/// Whether the key's value names a file or, of a calibration, a folder.
bool is_file(const std::string &key) {
  return std::find(file_keys.begin(), file_keys.end(), key) != file_keys.end();
}

} // namespace

std::string assignment_beside(const std::string &origin, const std::string &key, const Value &value) {
  namespace fs = std::filesystem;
  const auto *text = std::get_if<std::string>(&value.cell);
  const bool named = text && !text->empty();
  const fs::path folder = fs::path(origin).parent_path();
  std::string path;
  if (named && is_record(key)) path = find_record(*text, folder.string());
  if (named && is_file(key)) path = fs::absolute(folder / *text).lexically_normal().string();
  return key + "=" + (path.empty() ? value.toml : nlohmann::json(path).dump());
}

std::vector<std::string> Sweep::assignments(std::size_t run) const {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (!is_label(keys[i])) result.push_back(assignment_beside(origin, keys[i], runs[run][i]));
  return result;
}

Sweep combine(const SweepParts &parts, const std::string &origin) {
  auto points = product(case_points(parts.cases), case_points(parts.devices), origin);
  points = product(points, case_points(parts.records.cases), origin);
  for (const auto &axis : parts.grid) {
    std::vector<Point> along;
    along.reserve(axis.values.size());
    for (const auto &value : axis.values) along.push_back({{axis.key, value}});
    points = product(points, along, origin);
  }
  points = product(points, sampled_points(parts), origin);
  Sweep sweep{origin, {}, {}, parts.fractiles_along, parts.fractiles_by, parts.records.left_out, parts.plausible};
  for (auto &point : points) {
    for (const auto &linked : parts.linked) add_linked(point, linked);
    sweep.runs.emplace_back();
    for (auto &[key, value] : point) sweep.runs.back().push_back(std::move(value));
  }
  for (const auto &[key, value] : points.front()) sweep.keys.push_back(key);
  if (sweep.keys.empty())
    throw InputError(
        fmt::format("{}: nothing varies; a sweep has [[case]], [records], [grid] or [latin_hypercube]", origin));
  for (const auto &key : sweep.keys)
    if (key.find('/') != std::string::npos)
      throw InputError(fmt::format("{}: {}: a column of table.h5 cannot have \"/\" in its name", origin, key));
  require_numbers_along(sweep);
  return sweep;
}

Sweep parse_sweep(const std::string &text, const std::string &origin) {
  return combine(read_parts(TomlFile(text, origin), origin), origin);
}

Sweep read_sweep(const std::string &path) {
  return parse_sweep(read_named_file(path), path);
}

} // namespace rimpact::fleets
