#include "laws/friction/friction_table.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/table_lines.h"
#include "io/files/text.h"
#include "laws/friction/friction_law.h"
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <set>

namespace rimpact::friction {

namespace {

/// Where a value lies among growing places: the lower of two and the share of the way to the upper one.
struct Place {
  std::size_t low = 0, high = 0;
  double share = 0, slope = 0; ///< slope: of the share by the value; 0 beyond the ends
};
Place place(const std::vector<double> &at, double value) {
  if (value <= at.front()) return {};
  if (value >= at.back()) return {at.size() - 1, at.size() - 1, 0, 0};
  const auto high = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), value) - at.begin());
  const double width = at[high] - at[high - 1];
  return {high - 1, high, (value - at[high - 1]) / width, 1 / width};
}

struct Column {
  const char *name;
  int quantity; ///< 0 speed, 1 pressure, 2 mu
  double factor, most;
};
constexpr Column known[] = {
    {"speed_m_per_s", 0, 1, 100}, {"speed_mm_per_s", 0, 1e-3, 100}, {"pressure_MPa", 1, 1e6, 1e10}, {"mu", 2, 1, 2}};
using Columns = std::array<const Column *, 3>;

/// The column of each cell.
std::vector<const Column *> read_header(std::string_view line, const std::string &where) {
  std::vector<const Column *> columns;
  std::set<int> seen;
  for (const auto &cell : split(line, ',')) {
    const auto *found =
        std::find_if(std::begin(known), std::end(known), [&](const Column &k) { return trim(cell) == k.name; });
    if (found == std::end(known) || !seen.insert(found->quantity).second)
      throw DataError(
          fmt::format("{}: column \"{}\" is {}; a table of friction has speed_m_per_s or speed_mm_per_s, mu, "
                      "and may have pressure_MPa",
                      where, trim(cell).substr(0, 40), found == std::end(known) ? "not known" : "given twice"));
    columns.push_back(found);
  }
  for (const int needed : {0, 2})
    if (seen.count(needed) == 0)
      throw DataError(fmt::format("{}: the header has no column {}", where, needed == 0 ? "speed_m_per_s" : "mu"));
  return columns;
}

} // namespace

FrictionTable::FrictionTable(std::vector<double> speeds, std::vector<double> pressures, std::vector<double> values)
    : speeds_(std::move(speeds)), pressures_(std::move(pressures)), values_(std::move(values)) {}

Coefficient FrictionTable::at(double speed, double pressure) const {
  const Place v = place(speeds_, speed), p = place(pressures_, pressure);
  const auto value = [&](std::size_t i, std::size_t j) { return values_[i * pressures_.size() + j]; };
  const double at_low = value(v.low, p.low) + p.share * (value(v.low, p.high) - value(v.low, p.low));
  const double at_high = value(v.high, p.low) + p.share * (value(v.high, p.high) - value(v.high, p.low));
  const double low_slope = value(v.low, p.high) - value(v.low, p.low),
               high_slope = value(v.high, p.high) - value(v.high, p.low);
  return {at_low + v.share * (at_high - at_low), v.slope * (at_high - at_low),
          p.slope * (low_slope + v.share * (high_slope - low_slope))};
}

FrictionTable read_friction_table(const std::string &file) {
  constexpr std::size_t most = 100000;
  std::vector<const Column *> columns;
  std::map<std::pair<double, double>, double> rows;
  std::set<double> speeds, pressures;
  const std::string text = read_file(file);
  for (const auto &[line, where] : table_lines(text, file)) {
    if (columns.empty()) {
      columns = read_header(line, where);
      continue;
    }
    const auto cells = split(line, ',');
    if (cells.size() != columns.size())
      throw DataError(fmt::format("{}: {} of {} columns", where, cells.size(), columns.size()));
    double row[3] = {};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double &value = row[columns[i]->quantity];
      value = finite_number(cells[i], where) * columns[i]->factor;
      if (!(value >= 0 && value <= columns[i]->most))
        throw DataError(fmt::format("{}: {} {} must be in 0..{:g}", where, columns[i]->name, trim(cells[i]),
                                    columns[i]->most / columns[i]->factor));
    }
    speeds.insert(row[0]), pressures.insert(row[1]);
    if (!rows.insert({{row[0], row[1]}, row[2]}).second)
      throw DataError(
          fmt::format("{}: speed {:g} m/s at {:g} MPa stands in an earlier row", where, row[0], row[1] / 1e6));
    if (rows.size() > most) throw DataError(fmt::format("{}: a table of friction has at most {} rows", where, most));
  }
  if (rows.empty()) throw DataError(fmt::format("{}: no row; a table of friction needs at least one", file));
  std::vector<double> values;
  for (const double v : speeds)
    for (const double p : pressures) {
      const auto found = rows.find({v, p});
      if (found == rows.end())
        throw DataError(fmt::format("{}: no row for speed {:g} m/s at {:g} MPa; every speed needs every pressure", file,
                                    v, p / 1e6));
      values.push_back(found->second);
    }
  return {{speeds.begin(), speeds.end()}, {pressures.begin(), pressures.end()}, std::move(values)};
}

} // namespace rimpact::friction
