/// Wavelets of one scale about every sample of a signal, by fast Fourier transforms.
#pragma once
#include <complex>
#include <memory>
#include <vector>

namespace rimpact {

/// A signal in two directions at even instants, the first one real, the second one imaginary.
using PlaneSignal = std::vector<std::complex<double>>;

/// Integral of psi (daubechies.h) over the cell of a sample `offset` samples behind the one about which the wavelet of
/// `scale` samples is centred; 0 beyond its support. From a table of its integral on a grid of 1/1024, the nearest
/// place below each of the cell's ends, as the authors of the pulses' classification have it (MATLAB's cwt).
double wavelet_weight(long offset, long scale);
/// psi at `offset` samples from the centre, straight between values of four cascades, as they draw a pulse.
double wavelet_value(long offset, long scale);

/// Of signals of one length.
class WaveletTransform {
public:
  /// `n` samples; no scale is longer than `longest` samples.
  WaveletTransform(std::size_t n, long longest);
  ~WaveletTransform();

  /// Heights of the wavelet stretched to `scale` samples about each sample, in the signal's unit: the sum of the signal
  /// times wavelet_weight(), the signal at rest before and after. Height times psi is what leaves the least energy.
  PlaneSignal heights(const PlaneSignal &signal, long scale) const;
  /// The same of one signal for many scales: its spectrum() is made once.
  PlaneSignal spectrum(const PlaneSignal &signal) const;
  PlaneSignal heights_of(const PlaneSignal &spectrum, long scale) const;

private:
  struct Plan; ///< of the transforms, with the wavelet it was last asked for
  std::size_t n_, padded_;
  std::unique_ptr<Plan> plan_;
};

} // namespace rimpact
