/// The strongest wavelets of a motion in two directions.
#pragma once
#include "io/records/wavelet_transform.h"

namespace rimpact {

/// Even scales in samples, >= 1.
struct WaveletScales {
  long shortest, step;
  int count;
  long at(int k) const { return shortest + step * k; }
  long longest() const { return at(count - 1); }
};

struct WaveletCandidate {
  long scale;        ///< in samples
  std::size_t place; ///< sample about which it is centred
};

/// The wavelets of all scales about every sample of a signal; the strength of one is its share of the energy,
/// scale |height|^2.
class WaveletCandidates {
public:
  /// `signal` is kept by its owner.
  WaveletCandidates(const PlaneSignal &signal, const WaveletScales &scales);
  /// The strongest one. Later ones lie farther from it than `reach` times its scale.
  WaveletCandidate take(double reach);
  /// Height of one wavelet, as WaveletTransform::heights.
  std::complex<double> height(const WaveletCandidate &wavelet) const;

private:
  const PlaneSignal &signal_;
  WaveletScales scales_;
  std::vector<std::vector<double>> strengths_; ///< by scale and sample
};

} // namespace rimpact
