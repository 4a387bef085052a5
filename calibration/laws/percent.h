/// Shares in words.
#pragma once
#include <optional>
#include <string>

namespace rimpact::calibration {

/// A bound as it was measured, rounded up, so that what is said holds: 0.0312 is "3.2 %", 0.136 is "14 %". share >= 0.
std::string percent_up(double share);
/// As percent_up(); "not known" where there is none.
std::string percent_up(const std::optional<double> &share);
/// One decimal, as measured: 0.0496 is "5.0 %"; "not known" where there is none.
std::string percent_of(const std::optional<double> &share);
/// Empty for NaN, which stands for what is not known.
std::optional<double> known(double value);
/// The larger of two; NaN, which stands for what is not known, where either is.
double larger_of(double a, double b);

} // namespace rimpact::calibration
