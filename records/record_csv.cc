#include "files/error.h"
#include "files/text.h"
#include "records/record.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

struct Columns {
  std::size_t time, acceleration, count;
  double unit; ///< [m/s^2]
};

/// Two columns for the same quantity contradict each other: which one is meant the file does not say.
void claim(std::size_t &column, std::size_t index, std::string_view first, std::string_view name,
           const std::string &where) {
  if (column != std::string::npos)
    throw DataError(fmt::format("{}: column {} \"{}\" gives what column {} \"{}\" gives already; keep one of them",
                                where, index + 1, name, column + 1, first));
  column = index;
}

Columns read_header(std::string_view line, const std::string &where, double gravity) {
  Columns columns{std::string::npos, std::string::npos, 0, 0};
  const auto names = split(line, ',');
  for (const auto &cell : names) {
    const auto name = trim(cell);
    const auto first = [&](std::size_t column) {
      return column < names.size() ? trim(names[column]) : std::string_view();
    };
    if (name == "time_s") claim(columns.time, columns.count, first(columns.time), name, where);
    if (name == "acceleration_g" || name == "acceleration_m_per_s2") {
      claim(columns.acceleration, columns.count, first(columns.acceleration), name, where);
      columns.unit = name == "acceleration_g" ? gravity : 1;
    }
    ++columns.count;
  }
  if (columns.time == std::string::npos || columns.acceleration == std::string::npos)
    throw DataError(fmt::format(
        "{}: the header must be \"time_s,acceleration_g\" or \"time_s,acceleration_m_per_s2\", with commas between "
        "its cells, in ASCII or UTF-8",
        where));
  return columns;
}

double finite(std::string_view cell, const std::string &where) {
  const auto value = to_number(cell);
  if (!value || !std::isfinite(*value))
    throw DataError(fmt::format("{}: \"{}\" is not a finite number", where, trim(cell).substr(0, 40)));
  return *value;
}

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

} // namespace

SampledSignal parse_record_csv(const std::string &text, const std::string &path, double gravity) {
  SampledSignal record;
  std::vector<double> time;
  Columns columns{};
  std::size_t line_number = 0;
  for (const auto line : lines_of(text)) {
    const std::string where = fmt::format("{}:{}", path, ++line_number);
    if (trim(line).empty() || trim(line).front() == '#') continue;
    if (columns.count == 0) {
      columns = read_header(line, where, gravity);
      continue;
    }
    const auto cells = split(line, ',');
    if (cells.size() < columns.count)
      throw DataError(fmt::format("{}: {} of {} columns", where, cells.size(), columns.count));
    if (cells.size() > columns.count)
      throw DataError(
          fmt::format("{}: {} cells for {} columns; commas separate cells, so a decimal comma makes two of one number",
                      where, cells.size(), columns.count));
    time.push_back(finite(cells[columns.time], where));
    record.values.push_back(finite(cells[columns.acceleration], where) * columns.unit);
    require_plausible(record.values.back(), gravity, where);
  }
  if (columns.count == 0) throw DataError(fmt::format("{}: holds no header line", path));
  record.dt = uniform_step(time, path);
  record.start = time.front();
  if (record.start < 0)
    throw DataError(fmt::format(
        "{}: begins at {} s; a run begins at 0 s, so shift all times (of every component alike)", path, record.start));
  return record;
}

} // namespace rimpact
