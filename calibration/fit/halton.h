/// Points that fill a box evenly.
#pragma once

namespace rimpact::calibration {

/// Radical inverse of `index` in `base`: the Halton sequence, in (0, 1) for index >= 1.
inline double radical_inverse(int index, int base) {
  double value = 0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) value += digit * (index % base);
  return value;
}
inline constexpr int halton_bases[] = {2, 3, 5, 7, 11, 13, 17};

} // namespace rimpact::calibration
