/// What a record's samples say of their errors: how large, how neighbours hang together, what rounding leaves.
#pragma once
#include <cstddef>
#include <vector>

namespace rimpact::calibration {

/// tau = 1 + 2 sum rho_k, the variance of an average of many samples over that of independent ones, by the correlations
/// rho_k of samples k apart that are both `counted`, up to the first that is not sure (three standard errors); 1 to a
/// tenth of their count. The counted samples scatter about a constant.
double correlation_of(const std::vector<double> &values, const std::vector<bool> &counted);

/// Of independent errors on a smooth curve: third differences have 20 times their variance (median, so that jumps do
/// not count). 0: too few.
double noise_of_differences(const std::vector<double> &values);

/// Values less the straight line through them (least squares).
std::vector<double> about_line(std::vector<double> values);
/// Standard deviation of values about 0, by their median, so that a few large ones do not count.
double scatter_of(std::vector<double> values);

/// The step that values are stored in, in their unit; 0 where they have none in common, or one so fine that it tells
/// nothing (below 1e-4 of their range).
double step_of_digits(const std::vector<double> &values);
/// Standard error that such a step leaves, itself over sqrt(12).
double noise_of_digits(const std::vector<double> &values);

} // namespace rimpact::calibration
