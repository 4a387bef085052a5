#include "io/records/wavelet_transform.h"
#include "io/records/daubechies.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <unsupported/Eigen/FFT>

namespace rimpact {
namespace {

constexpr int integral_steps = 10, drawn_steps = 4;

std::vector<double> integral_of_wavelet() {
  std::vector<double> integral = daubechies_wavelet(integral_steps);
  double sum = 0;
  for (double &value : integral) value = sum += std::ldexp(value, -integral_steps);
  return integral;
}

/// Cells of a wavelet before the one of its centre.
long cells_before(long scale) {
  return daubechies_support * scale / 2; // the half of 7 scale - 1, rounded up
}

/// The least of 2^k, 3/4 and 5/8 of it that is not below n: lengths that transform quickly.
std::size_t quick_length(std::size_t n) {
  const std::size_t power = std::max<std::size_t>(8, std::bit_ceil(n));
  for (const std::size_t eighths : {5, 6})
    if (power / 8 * eighths >= n) return power / 8 * eighths;
  return power;
}

} // namespace

double wavelet_weight(long offset, long scale) {
  static const std::vector<double> integral = integral_of_wavelet();
  const long cell = offset + cells_before(scale);
  if (cell < 0 || cell >= daubechies_support * scale) return 0;
  const auto at = [&](long node) { return integral[static_cast<std::size_t>((node << integral_steps) / scale)]; };
  return at(cell + 1) - at(cell);
}

double wavelet_value(long offset, long scale) {
  static const std::vector<double> values = daubechies_wavelet(drawn_steps);
  const double place =
      std::ldexp(static_cast<double>(offset) / static_cast<double>(scale) + daubechies_support / 2.0, drawn_steps);
  if (!(place >= 0 && place < static_cast<double>(values.size() - 1))) return 0;
  const auto i = static_cast<std::size_t>(place);
  return std::lerp(values[i], values[i + 1], place - static_cast<double>(i));
}

struct WaveletTransform::Plan {
  Eigen::FFT<double> fft;
  long scale = 0; ///< of `wavelet`; 0: none yet
  PlaneSignal wavelet, product, heights;
};

WaveletTransform::WaveletTransform(std::size_t n, long longest)
    : n_(n), padded_(quick_length(n + static_cast<std::size_t>(cells_before(longest)) + 1)),
      plan_(std::make_unique<Plan>()) {}

WaveletTransform::~WaveletTransform() = default;

PlaneSignal WaveletTransform::spectrum(const PlaneSignal &signal) const {
  PlaneSignal padded = signal, result;
  padded.resize(padded_);
  plan_->fft.fwd(result, padded);
  return result;
}

PlaneSignal WaveletTransform::heights_of(const PlaneSignal &spectrum, long scale) const {
  if (plan_->scale != scale) {
    PlaneSignal turned(padded_); // turned round, so that the product of the spectra is the correlation
    const long first = -cells_before(scale);
    for (long m = first; m < first + daubechies_support * scale; ++m)
      turned[static_cast<std::size_t>(m <= 0 ? -m : static_cast<long>(padded_) - m)] = wavelet_weight(m, scale);
    plan_->fft.fwd(plan_->wavelet, turned);
    plan_->scale = scale;
  }
  plan_->product.resize(padded_);
  for (std::size_t k = 0; k < padded_; ++k) {
    const auto &a = spectrum[k], &b = plan_->wavelet[k]; // written out: operator* looks for infinities
    plan_->product[k] = {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }
  plan_->fft.inv(plan_->heights, plan_->product);
  return {plan_->heights.begin(), plan_->heights.begin() + static_cast<std::ptrdiff_t>(n_)};
}

PlaneSignal WaveletTransform::heights(const PlaneSignal &signal, long scale) const {
  return heights_of(spectrum(signal), scale);
}

} // namespace rimpact
