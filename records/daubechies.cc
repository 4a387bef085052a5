#include "records/daubechies.h"
#include <array>
#include <cmath>
#include <vector>

namespace rimpact {
namespace {

constexpr int resolution = 256, support = 7;
/// Low-pass filter (Daubechies, Ten Lectures on Wavelets, 1992, table 6.1, N = 4); its sum is the root of 2.
constexpr std::array filter{0.23037781330885523,  0.7148465705525415,   0.6308807679295904,   -0.02798376941698385,
                            -0.18703481171888114, 0.030841381835986965, 0.032883011666982945, -0.010597401784997278};

/// Root of 2 times the sum of weights_k f(2 x - k), at the grid's points.
std::vector<double> refined(const std::vector<double> &f, const std::array<double, 8> &weights) {
  std::vector<double> next(f.size(), 0.0);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const auto at = 2 * static_cast<long>(i) - static_cast<long>(k) * resolution;
      if (at >= 0 && at < static_cast<long>(f.size()))
        next[i] += std::sqrt(2.0) * weights[k] * f[static_cast<std::size_t>(at)];
    }
  return next;
}

std::vector<double> wavelet_on_grid() {
  std::vector<double> scaling(support * resolution + 1, 0.0);
  for (int i = 0; i < resolution; ++i) scaling[static_cast<std::size_t>(i)] = 1;
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i) scaling = refined(scaling, filter);
  std::array<double, 8> high_pass{};
  for (std::size_t k = 0; k < filter.size(); ++k) high_pass[k] = (k % 2 == 0 ? 1 : -1) * filter[filter.size() - 1 - k];
  return refined(scaling, high_pass);
}

} // namespace

double daubechies_wavelet(double x) {
  static const std::vector<double> grid = wavelet_on_grid();
  if (!(x >= 0 && x < support)) return 0;
  const double place = x * resolution;
  const auto i = static_cast<std::size_t>(place);
  return std::lerp(grid[i], grid[i + 1], place - static_cast<double>(i));
}

} // namespace rimpact
