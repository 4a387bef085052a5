#include "calibration/laws/percent.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

std::string percent_up(double share) {
  if (std::isnan(share)) return "not known";
  constexpr double fine = 0.1, coarse = 1; // [%]: two figures are enough
  const double per_cent = 100 * share, step = per_cent < 10 ? fine : coarse;
  return fmt::format("{:.10g} %", std::max(fine, step * std::ceil(per_cent / step - 1e-9)));
}

std::string percent_up(const std::optional<double> &share) {
  return percent_up(share.value_or(NAN));
}

std::string percent_of(const std::optional<double> &share) {
  return share && !std::isnan(*share) ? fmt::format("{:.1f} %", 100 * *share) : "not known";
}

std::optional<double> known(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

double larger_of(double a, double b) {
  return std::isnan(a) || a > b ? a : b;
}

} // namespace rimpact::calibration
