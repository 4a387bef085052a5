/// The wavelet of Daubechies with four vanishing moments.
#pragma once
#include <vector>

namespace rimpact {

/// psi(x) at x = 0, 2^-steps, ..., 7, its support: by `steps` >= 1 steps of the cascade algorithm, begun with its
/// filter (Daubechies, Ten Lectures on Wavelets, 1992, section 6.5); 0 in front of it and behind. The integral of the
/// values is 0, that of their squares 1, to rounding.
std::vector<double> daubechies_wavelet(int steps);

inline constexpr int daubechies_support = 7;
/// Of its largest frequency 5/7: a wavelet stretched by s looks like a wave of period 1.4 s.
inline constexpr double daubechies_period = 1.4;

} // namespace rimpact
