/// A product of powers through a table of results, with the error it makes on rows it has not seen.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace rimpact::calibration {

/// y = coefficient prod (x_j / centre_j)^exponent_j, least squares on ln y.
struct Surrogate {
  std::vector<double> centre;    ///< geometric mean of each input
  std::vector<double> exponents; ///< [-]
  std::vector<double> low, high; ///< of each input: the range it was fitted to
  double coefficient = 0;        ///< y at the centre
  /// Each row predicted from all others, relative (exp of the difference of the logarithms, minus 1).
  double left_out_rms = 0, left_out_largest = 0;
  int n_rows = 0;

  double at(const std::vector<double> &x) const;
  bool covers(const std::vector<double> &x) const; ///< within low..high
};

/// `x`: one row of inputs each, all > 0; rows whose y is not > 0 are left out. Empty when fewer than two rows
/// more than inputs + 1 remain, or an input does not vary by itself.
std::optional<Surrogate> power_surrogate(const std::vector<std::vector<double>> &x, const std::vector<double> &y);

} // namespace rimpact::calibration
