#include "io/records/daubechies.h"
#include <array>
#include <cmath>

namespace rimpact {
namespace {

/// Low-pass filter (table 6.1, N = 4); its sum is the root of 2.
constexpr std::array filter{0.23037781330885523,  0.7148465705525415,   0.6308807679295904,   -0.02798376941698385,
                            -0.18703481171888114, 0.030841381835986965, 0.032883011666982945, -0.010597401784997278};

/// A zero behind every value, then the filter.
std::vector<double> refined(const std::vector<double> &f) {
  std::vector<double> next(2 * f.size() + filter.size() - 2, 0.0);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t k = 0; k < filter.size(); ++k) next[2 * i + k] += filter[k] * f[i];
  return next;
}

} // namespace

std::vector<double> daubechies_wavelet(int steps) {
  std::vector<double> values; // of the high-pass filter
  for (std::size_t k = 0; k < filter.size(); ++k)
    values.push_back((k % 2 == 0 ? 1 : -1) * filter[filter.size() - 1 - k]);
  for (int i = 1; i < steps; ++i) values = refined(values);
  const double scale = std::sqrt(std::ldexp(1.0, steps));
  for (double &value : values) value *= scale;
  values.insert(values.begin(), 0.0);
  values.resize((static_cast<std::size_t>(daubechies_support) << steps) + 1);
  return values;
}

} // namespace rimpact
