#include "scene/path_table.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/table_lines.h"
#include "io/files/text.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace rimpact::scene {
namespace {

constexpr double farthest = 1e3, latest = 1e9; // [m], [s]

struct PathColumn {
  std::size_t index;
  double factor; ///< to SI
};
/// time, x, y.
using Columns = std::array<std::optional<PathColumn>, 3>;

Columns read_header(std::string_view line, const std::string &where) {
  struct Name {
    const char *name;
    std::size_t quantity;
    double factor;
  };
  constexpr Name known[] = {{"time_s", 0, 1},  {"time_ms", 0, 1e-3}, {"x_m", 1, 1},
                            {"x_mm", 1, 1e-3}, {"y_m", 2, 1},        {"y_mm", 2, 1e-3}};
  Columns columns;
  const auto names = split(line, ',');
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto *found =
        std::find_if(std::begin(known), std::end(known), [&](const Name &k) { return trim(names[i]) == k.name; });
    if (found == std::end(known))
      throw DataError(fmt::format("{}: column \"{}\" is not known; a path has x_m or x_mm, and may have y_m or y_mm, "
                                  "time_s or time_ms",
                                  where, trim(names[i]).substr(0, 40)));
    if (columns[found->quantity])
      throw DataError(fmt::format("{}: column {} \"{}\" gives what another one gives already; keep one of them", where,
                                  i + 1, found->name));
    columns[found->quantity] = {i, found->factor};
  }
  if (!columns[1]) throw DataError(fmt::format("{}: the header has no column x_m or x_mm", where));
  return columns;
}

double number(std::string_view cell, double factor, double most, const char *unit, const std::string &where) {
  const double value = finite_number(cell, where) * factor;
  if (std::abs(value) > most)
    throw DataError(fmt::format("{}: {:g} {} is beyond {:g} {}", where, value, unit, most, unit));
  return value;
}

/// Adds a corner; one at the same place as the last adds nothing but its time.
void add(PathTable &path, const Eigen::Vector2d &u, std::optional<double> t, const std::string &where) {
  if (path.at.empty() && u.norm() > 1e-9)
    throw DataError(fmt::format("{}: the path starts at ({:g}, {:g}) m; it must start at 0, where the bearing rests",
                                where, u.x(), u.y()));
  if (t && !path.time.empty() && !(*t > path.time.back()))
    throw DataError(fmt::format("{}: time {:g} s does not lie after {:g} s", where, *t, path.time.back()));
  const bool halts = !path.at.empty() && u == path.at.back();
  if (halts && !path.time.empty()) path.time.back() = *t;
  if (halts) return;
  path.share.push_back(path.at.empty() ? 0.0 : path.share.back() + (u - path.at.back()).norm());
  path.at.push_back(u);
  if (t) path.time.push_back(*t);
}

/// Linear in a list's values over the shares.
template <class Value> Value between(const std::vector<double> &share, const std::vector<Value> &values, double s) {
  const auto above = std::upper_bound(share.begin() + 1, share.end() - 1, s);
  const auto i = static_cast<std::size_t>(above - share.begin() - 1);
  const double part = std::clamp((s - share[i]) / (share[i + 1] - share[i]), 0.0, 1.0);
  return values[i] + part * (values[i + 1] - values[i]);
}

} // namespace

double PathTable::length() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) sum += (at[i + 1] - at[i]).norm();
  return sum;
}

double PathTable::reach() const {
  double most = 0;
  for (const auto &u : at) most = std::max(most, u.norm());
  return most;
}

bool PathTable::stays_on_x() const {
  return std::all_of(at.begin(), at.end(), [](const auto &u) { return u.y() == 0; });
}

Eigen::Vector2d PathTable::displacement(double s) const {
  return between(share, at, s);
}

double PathTable::instant(double s) const {
  return between(share, time, s);
}

std::vector<double> PathTable::turns() const {
  constexpr double smallest = 0.01745; // [rad]
  std::vector<double> result;
  for (std::size_t i = 1; i + 1 < at.size(); ++i) {
    const Eigen::Vector2d before = at[i] - at[i - 1], after = at[i + 1] - at[i];
    const double turn = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
    if (std::abs(turn) > smallest) result.push_back(share[i]);
  }
  return result;
}

PathTable read_path_table(const std::string &file) {
  constexpr std::size_t most = 100000;
  PathTable path;
  std::optional<Columns> columns;
  std::size_t width = 0;
  const std::string text = read_file(file);
  for (const auto &[line, where] : table_lines(text, file)) {
    const auto cells = split(line, ',');
    if (!columns) {
      columns = read_header(line, where), width = cells.size();
      continue;
    }
    if (cells.size() != width) throw DataError(fmt::format("{}: {} of {} columns", where, cells.size(), width));
    const auto read = [&](std::size_t quantity, double bound, const char *unit) -> std::optional<double> {
      const auto &column = (*columns)[quantity];
      if (!column) return std::nullopt;
      return number(cells[column->index], column->factor, bound, unit, where);
    };
    const auto t = read(0, latest, "s");
    const double x = read(1, farthest, "m").value(), y = read(2, farthest, "m").value_or(0.0);
    add(path, {x, y}, t, where);
    if (path.at.size() > most) throw DataError(fmt::format("{}: a path has at most {} corners", where, most));
  }
  if (path.at.size() < 2) throw DataError(fmt::format("{}: {} places; a path needs at least 2", file, path.at.size()));
  const double length = path.share.back();
  for (double &share : path.share) share /= length;
  path.share.back() = 1;
  return path;
}

} // namespace rimpact::scene
