#include "calibration/laws/percent.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

std::string percent_up(double share) {
  constexpr double fine = 0.1, coarse = 1; // [%]: two figures are enough
  const double per_cent = 100 * share, step = per_cent < 10 ? fine : coarse;
  return fmt::format("{:.10g} %", std::max(fine, step * std::ceil(per_cent / step - 1e-9)));
}

} // namespace rimpact::calibration
