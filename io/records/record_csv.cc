// Tables of time and acceleration as spreadsheets and programs write them.
#include "io/files/digit.h"
#include "io/files/error.h"
#include "io/files/loose_cells.h"
#include "io/files/text.h"
#include "io/records/direction.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include "io/records/record_table.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

/// Says where a step is far from the usual one: a hole, or a time that runs back.
void require_even_steps(const std::vector<double> &time, const std::string &path) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  auto sorted = steps;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (!(std::abs(steps[i] - usual) < 0.5 * std::abs(usual)))
      throw DataError(
          fmt::format("{}: sample {} at {} s comes {:g} s after the one before, where {:g} s is usual: the sampling "
                      "is not uniform",
                      path, i + 2, time[i + 1], steps[i], usual));
}

/// The sampling interval of instants that are uniform to 5 % of it (files round their times).
double uniform_step(const std::vector<double> &time, const std::string &path) {
  if (time.size() < 2) throw DataError(fmt::format("{}: {} samples, at least 2 are needed", path, time.size()));
  const double dt = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  if (!(dt > 0)) throw DataError(fmt::format("{}: time must grow; its mean step is {} s", path, dt));
  if (dt > longest_step)
    throw DataError(
        fmt::format("{}: its samples are {:g} s apart, at most {} s are taken: is its time in milliseconds?", path, dt,
                    longest_step));
  require_even_steps(time, path);
  for (std::size_t i = 0; i < time.size(); ++i)
    if (!(std::abs(time[i] - time.front() - static_cast<double>(i) * dt) < 0.05 * dt))
      throw DataError(
          fmt::format("{}: sample {} at {} s: the sampling is not uniform (mean step {} s)", path, i + 1, time[i], dt));
  return dt;
}

bool is_remark(std::string_view line) {
  const auto text = trim(line);
  return text.empty() || text.front() == '#' || stated_separator(text).has_value();
}

/// The header's columns and the line it stands in; remarks may stand above it.
struct FoundHeader {
  RecordColumns columns;
  std::size_t line = 0;
};
std::optional<FoundHeader> find_header(const std::vector<std::string_view> &lines, double gravity,
                                       const std::string &path) {
  constexpr std::size_t most_remarks = 60;
  for (std::size_t i = 0; i < std::min(lines.size(), most_remarks); ++i) {
    if (is_remark(lines[i])) continue;
    const std::string below(i + 1 < lines.size() ? lines[i + 1] : std::string_view());
    if (const auto columns = record_columns(std::string(lines[i]), below, gravity, fmt::format("{}:{}", path, i + 1)))
      return FoundHeader{*columns, i};
  }
  return std::nullopt;
}

FoundHeader require_header(const std::vector<std::string_view> &lines, double gravity, const std::string &path) {
  if (const auto found = find_header(lines, gravity, path)) return *found;
  const auto first = std::find_if_not(lines.begin(), lines.end(), is_remark);
  if (first == lines.end()) throw DataError(fmt::format("{}: holds no header line", path));
  throw DataError(fmt::format(
      "{}:{}: the header must be \"time_s,acceleration_g\" or \"time_s,acceleration_m_per_s2\", or name a column with "
      "the unit s and one with g, m/s2, cm/s2 or gal, in brackets or in the line below",
      path, first - lines.begin() + 1));
}

/// Reads the rows below a header.
class Rows {
public:
  Rows(RecordColumns columns, std::string path, const ReadAs &as)
      : columns_(std::move(columns)), acceleration_(columns_.accelerations[as.column]),
        unit_(as.unit.value_or(acceleration_.unit)), path_(std::move(path)), gravity_(as.gravity) {}

  void read(std::string_view line, std::size_t number) {
    if (is_remark(line)) return;
    const std::string where = fmt::format("{}:{}", path_, number);
    const auto cells = cells_of(line, columns_.separator);
    const bool is_row =
        columns_.time < cells.size() && !cells[columns_.time].empty() && starts_number(cells[columns_.time]);
    if (!is_row && !time.empty()) return void(footer_ = footer_ == 0 ? number : footer_); // perhaps the table's end
    if (footer_ > 0)
      throw DataError(fmt::format("{}:{}: no row of the table, and rows go on behind it", path_, footer_));
    require_width(cells, where);
    time.push_back(finite(cells[columns_.time], where));
    values.push_back(finite(cells[acceleration_.index], where) * unit_);
    require_plausible(values.back(), gravity_, where);
  }

  std::vector<double> time, values;

private:
  static bool starts_number(const std::string &cell) {
    return is_digit(cell.front()) || std::string_view("+-.,").find(cell.front()) != std::string_view::npos;
  }
  void require_width(const std::vector<std::string> &cells, const std::string &where) const {
    if (cells.size() < columns_.count)
      throw DataError(fmt::format("{}: {} of {} columns", where, cells.size(), columns_.count));
    if (cells.size() > columns_.count)
      throw DataError(
          fmt::format("{}: {} cells for {} columns; commas separate cells, so a decimal comma makes two of one number",
                      where, cells.size(), columns_.count));
  }
  double finite(const std::string &cell, const std::string &where) {
    const auto value = decimals_.number(cell, where);
    if (!value) throw DataError(fmt::format("{}: \"{}\" is not a finite number", where, cell.substr(0, 40)));
    return *value;
  }

  RecordColumns columns_;
  AccelerationColumn acceleration_;
  double unit_; ///< [m/s^2]
  std::string path_;
  double gravity_;
  DecimalReader decimals_;
  std::size_t footer_ = 0; ///< line of the first text below the rows; 0: none
};

} // namespace

namespace {

/// Of the beginning of a table, which holds its header; none: it has none, or one that contradicts itself.
std::optional<RecordColumns> columns_of(std::string_view bytes) {
  try {
    constexpr std::size_t beginning = 20'000; // even, so that no character of UTF-16 is cut
    const std::string text = utf8_text(std::string(bytes.substr(0, beginning)), "");
    const auto found = find_header(lines_of(text), standard_gravity, "");
    return found ? std::optional(found->columns) : std::nullopt;
  } catch (const DataError &) {
    return std::nullopt;
  }
}

} // namespace

bool has_record_header(const std::string &text, double gravity) {
  try {
    return find_header(lines_of(utf8_text(text, "")), gravity, "").has_value();
  } catch (const DataError &) {
    return true; // a header that contradicts itself
  }
}

std::vector<Channel> channels_of_csv(std::string_view text) {
  const auto columns = columns_of(text);
  if (!columns || columns->accelerations.size() < 2) return {{text}};
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < columns->accelerations.size(); ++i) channels.push_back({text, i});
  return channels;
}

RecordHead head_of_csv(const Channel &channel) {
  const auto columns = columns_of(channel.text);
  if (!columns) return {};
  const std::string &direction = columns->accelerations[channel.column].direction;
  return {"", direction_written(direction).kind == DirectionKind::unknown ? "" : direction};
}

SampledSignal parse_record_csv(const std::string &bytes, const std::string &path, const ReadAs &as) {
  const std::string text = utf8_text(bytes, path);
  const auto lines = lines_of(text);
  const auto [columns, header] = require_header(lines, as.gravity, path);
  Rows rows(columns, path, as);
  for (std::size_t i = header + columns.lines; i < lines.size(); ++i) rows.read(lines[i], i + 1);
  SampledSignal record{.dt = uniform_step(rows.time, path), .values = std::move(rows.values)};
  record.start = rows.time.front();
  if (record.start < 0)
    throw DataError(fmt::format(
        "{}: begins at {} s; a run begins at 0 s, so shift all times (of every component alike)", path, record.start));
  return record;
}

} // namespace rimpact
