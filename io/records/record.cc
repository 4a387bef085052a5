#include "io/records/record.h"
#include "io/files/error.h"
#include "io/records/near_fault_pulse.h"
#include "io/records/record_corrections.h"
#include "io/records/record_file.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact {
namespace {

/// Trapezoidal rule for int a^2 dt over a sample: what published Arias intensities and durations use.
double square_integral(double a, double b, double dt) {
  return dt * (a * a + b * b) / 2;
}

/// Time between 5 % and 95 % of the growth of int a^2 dt, linear within a sample.
double significant_duration(const SampledSignal &record, double total) {
  double grown = 0, reached[2] = {0, 0};
  const double targets[2] = {0.05 * total, 0.95 * total};
  for (std::size_t i = 0; i + 1 < record.values.size(); ++i) {
    const double more = square_integral(record.values[i], record.values[i + 1], record.dt);
    for (int k = 0; k < 2; ++k)
      if (grown < targets[k] && grown + more >= targets[k])
        reached[k] = record.dt * (static_cast<double>(i) + (targets[k] - grown) / more);
    grown += more;
  }
  return reached[1] - reached[0];
}

} // namespace

void require_plausible(double acceleration, double gravity, const std::string &where) {
  if (std::abs(acceleration) <= largest_acceleration * gravity) return;
  throw DataError(
      fmt::format("{}: an acceleration of {:.4g} m/s^2 is beyond {:g} g, which no ground reaches: is the unit right?",
                  where, acceleration, largest_acceleration));
}

SampledSignal read_record(const std::string &path, double gravity) {
  if (is_builtin_record(path)) return builtin_record(path);
  const RecordName name = record_name(path);
  const auto file = RecordFile::read(name);
  const std::size_t channel = file.chosen(name.channel);
  return file.parse(channel, {gravity, stated_unit(file.name(channel), gravity)});
}

SampledSignal parse_record(const std::string &text, const std::string &path, const ReadAs &as) {
  const RecordFile file(text, path);
  return file.parse(file.chosen(std::nullopt), as);
}

RecordInfo inspect(const SampledSignal &record, double gravity) {
  RecordInfo info{record.values.size(), record.dt, 0, 0, 0, 0, 0};
  double square = 0;
  integrate_from_rest(record, [&](std::size_t i, double v, double u) {
    info.pga_g = std::max(info.pga_g, std::abs(record.values[i]) / gravity);
    info.pgv = std::max(info.pgv, std::abs(v));
    info.pgd = std::max(info.pgd, std::abs(u));
    if (i > 0) square += square_integral(record.values[i - 1], record.values[i], record.dt);
  });
  info.arias = std::numbers::pi / (2 * gravity) * square;
  info.duration = significant_duration(record, square);
  return info;
}

} // namespace rimpact
