#include "calibration/laws/speed_law.h"
#include <algorithm>
#include <cmath>

namespace rimpact::calibration {

namespace {

std::optional<SpeedLaw> law_of(const WindowsTable &table, const std::string &name) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto &row : table.rows) {
    const auto &estimate = row.own.parameters.at(name);
    if (!(estimate.value > 0) || !estimate.identifiable) return {};
    const double lx = std::log(row.speed), ly = std::log(estimate.value);
    n += 1, x += lx, y += ly, xx += lx * lx, xy += lx * ly;
  }
  const double spread = n * xx - x * x;
  if (n < 3 || !(spread > 1e-9)) return {};
  SpeedLaw law{};
  law.name = name, law.unit = parameter(name).unit;
  law.exponent = (n * xy - x * y) / spread;
  law.coefficient = std::exp((y - law.exponent * x) / n);
  law.from = table.rows.front().speed, law.to = table.rows.back().speed;
  law.largest_error = 0;
  for (const auto &row : table.rows)
    law.largest_error =
        std::max(law.largest_error,
                 std::abs(law.coefficient * std::pow(row.speed, law.exponent) / row.own.parameters.at(name).value - 1));
  return law;
}

} // namespace

std::vector<SpeedLaw> speed_laws(const WindowsTable &table) {
  std::vector<SpeedLaw> laws;
  if (table.rows.empty()) return laws;
  for (const auto &name : table.rows.front().own.names)
    if (auto law = law_of(table, name)) laws.push_back(*law);
  return laws;
}

} // namespace rimpact::calibration
