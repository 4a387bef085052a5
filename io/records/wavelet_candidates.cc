#include "io/records/wavelet_candidates.h"
#include "io/records/daubechies.h"
#include <algorithm>
#include <cmath>

namespace rimpact {

WaveletCandidates::WaveletCandidates(const PlaneSignal &signal, const WaveletScales &scales)
    : signal_(signal), scales_(scales) {
  const WaveletTransform transform(signal.size(), scales.longest());
  const PlaneSignal spectrum = transform.spectrum(signal);
  for (int k = 0; k < scales.count; ++k) {
    const auto scale = static_cast<double>(scales.at(k));
    auto &of_scale = strengths_.emplace_back();
    for (const auto &height : transform.heights_of(spectrum, scales.at(k)))
      of_scale.push_back(scale * std::norm(height));
  }
}

WaveletCandidate WaveletCandidates::take(double reach) {
  std::size_t best = 0, place = 0;
  for (std::size_t k = 0; k < strengths_.size(); ++k) {
    const auto at = std::max_element(strengths_[k].begin(), strengths_[k].end()) - strengths_[k].begin();
    if (strengths_[k][static_cast<std::size_t>(at)] > strengths_[best][place])
      best = k, place = static_cast<std::size_t>(at);
  }
  const long scale = scales_.at(static_cast<int>(best));
  for (auto &of_scale : strengths_)
    for (std::size_t i = 0; i < of_scale.size(); ++i)
      if (std::abs(static_cast<double>(i) - static_cast<double>(place)) < reach * static_cast<double>(scale))
        of_scale[i] = 0;
  return {scale, place};
}

std::complex<double> WaveletCandidates::height(const WaveletCandidate &wavelet) const {
  const auto half = static_cast<std::size_t>(daubechies_support * wavelet.scale / 2 + 1);
  const std::size_t end = std::min(signal_.size(), wavelet.place + half + 1);
  std::complex<double> sum = 0;
  for (std::size_t i = wavelet.place > half ? wavelet.place - half : 0; i < end; ++i)
    sum += signal_[i] * wavelet_weight(static_cast<long>(i) - static_cast<long>(wavelet.place), wavelet.scale);
  return sum;
}

} // namespace rimpact
