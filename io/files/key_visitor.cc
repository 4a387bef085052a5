#include "io/files/key_visitor.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact {

std::string Range::text() const {
  const bool no_low = low <= -huge, no_high = high >= huge;
  if (no_low && no_high) return "a finite number";
  if (no_high) return fmt::format("{} {}", low_open ? ">" : ">=", low);
  if (no_low) return fmt::format("{} {}", high_open ? "<" : "<=", high);
  return fmt::format("{} {} and {} {}", low_open ? ">" : ">=", low, high_open ? "<" : "<=", high);
}

std::string Range::text_for(double value) const {
  const bool passes_huge = value > 0 ? value > huge && high >= huge : value < -huge && low <= -huge;
  return passes_huge ? fmt::format("of a magnitude of {:g} at most", huge) : text();
}

std::string file_number(double value, Unit unit) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  const double raw = unit.from_si(value);
  std::string best;
  // The product itself may carry a rounding (0.07019 m * 1000 = 70.19000000000001): its neighbours are tried
  // too.
  for (const double candidate : {raw, std::nextafter(raw, -huge), std::nextafter(raw, huge)}) {
    std::string text = fmt::format("{}", candidate);
    if (unit.to_si(candidate) == value && (best.empty() || text.size() < best.size())) best = text;
  }
  if (best.empty()) best = fmt::format("{}", raw);
  if (best.find_first_of(".e") == std::string::npos) best += ".0";
  return best;
}

} // namespace rimpact
