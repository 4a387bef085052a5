/// Weighted sums of samples that read a peak or a slope from a noisy curve. The same sum is taken of the model's curve,
/// so what a polynomial cannot follow is in both and cancels, and no selection by a noisy sample enters.
#pragma once
#include "calibration/data/impact_window.h"

namespace rimpact::calibration {

/// The value, at the instant where it is largest, of a quartic (a parabola for fewer than 10 samples) through the
/// samples around the peak of `smooth` that exceed 0.8 of it. Empty for fewer than 3.
Functional peak_functional(const std::vector<double> &times, const std::vector<double> &values,
                           const std::vector<double> &smooth);
/// Slope of a straight line through samples first..last, times `sign`. Empty for fewer than `shortest_flight`.
Functional slope_functional(const std::vector<double> &times, std::size_t first, std::size_t last, double sign);
/// d values / dt of noisy samples first..last: at each the slope of a straight line through its neighbours within 2.5
/// ms (three on each side at least, fewer at the ends).
void smooth_rates(const std::vector<double> &times, const std::vector<double> &values, std::size_t first,
                  std::size_t last, std::vector<double> &rates);
/// Sum of squared weights: its noise over that of one sample, squared.
double variance_gain(const Functional &functional);

} // namespace rimpact::calibration
