/// Hazard curve: annual rate at which an intensity is exceeded.
#pragma once
#include <vector>

namespace rimpact::reliability {

/// One point: intensity (S_a(T), any unit, > 0) and its mean return period [years], > 0.
struct HazardPoint {
  double intensity, return_period_years;
};

/// Straight lines between the points in the logarithms of intensity and rate; a rate is 1 / return period.
/// Beyond both ends the end's line goes on: a power law there is extrapolated, and a result that rests on it
/// says so (FailureRate). Between two points the rate is k_0 x^-slope.
class HazardCurve {
public:
  /// At least two points of growing intensity and growing return period. Throws InputError naming the two
  /// points where one does not grow, or a value that is not finite and > 0.
  explicit HazardCurve(std::vector<HazardPoint> points);
  /// Annual rate of exceeding `intensity` > 0.
  double rate(double intensity) const;
  /// -d ln(rate) / d ln(intensity) >  0; at a point, of the line above it.
  double slope(double intensity) const;
  const std::vector<HazardPoint> &points() const { return points_; }

private:
  std::size_t line_of(double intensity) const;
  std::vector<HazardPoint> points_;
  std::vector<double> slopes_; ///< one per line
};

} // namespace rimpact::reliability
