/// The wavelet of Daubechies with four vanishing moments.
#pragma once

namespace rimpact {

/// psi(x) on its support 0 <= x <= 7, else 0; its integral is 0, that of its square 1. By the cascade algorithm on a
/// grid of 1/256, straight in between.
double daubechies_wavelet(double x);

inline constexpr double daubechies_support = 7;
/// Of its largest frequency 5/7: a wavelet stretched by s looks like a wave of period 1.4 s.
inline constexpr double daubechies_period = 1.4;

} // namespace rimpact
