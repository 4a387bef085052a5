#include "io/records/velocity_pulse.h"
#include "io/records/daubechies.h"
#include "io/records/wavelet_candidates.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace rimpact {
namespace {

constexpr double shortest_period = 0.25, longest_period = 15; // [s]
constexpr int n_scales = 51, n_candidates = 5, n_wavelets = 10;
constexpr double reach = 0.4; // of a scale: how far wavelets of one pulse lie apart

/// As the authors space them.
WaveletScales scales_of(double dt) {
  const auto first = std::max(1L, static_cast<long>(shortest_period / daubechies_period / dt));
  const double range = longest_period / daubechies_period / dt - static_cast<double>(first);
  return {
      .shortest = first, .step = std::max(1L, static_cast<long>(std::ceil(range / (n_scales - 1)))), .count = n_scales};
}

/// Velocities [cm/s] of both components: sums of the accelerations before and at each sample, as the authors take them.
PlaneSignal velocity_of(const SampledSignal &first, const SampledSignal &second) {
  PlaneSignal v;
  std::complex<double> sum = 0;
  constexpr double centimetres = 100; // in a metre
  for (std::size_t i = 0; i < std::min(first.values.size(), second.values.size()); ++i)
    v.push_back(sum += centimetres * first.dt * std::complex(first.values[i], second.values[i]));
  return v;
}

double energy(const std::vector<double> &v) {
  double sum = 0;
  for (const double value : v) sum += value * value;
  return sum;
}

/// Of the scales beside a candidate's, a sample apart, the one whose wavelet along `direction` is the strongest there.
long refined_scale(const WaveletCandidates &wavelets, const WaveletCandidate &candidate, const WaveletScales &scales,
                   const std::complex<double> &direction) {
  long best = candidate.scale;
  double strongest = 0;
  const long last = std::min(scales.longest(), candidate.scale + scales.step);
  for (long scale = std::max(scales.shortest, candidate.scale - scales.step); scale <= last; ++scale) {
    const auto height = wavelets.height({scale, candidate.place}) * std::conj(direction);
    const double strength = std::sqrt(static_cast<double>(scale)) * std::abs(height.real());
    if (strength > strongest) strongest = strength, best = scale;
  }
  return best;
}

/// Ten wavelets of one scale about a place, taken off one after the other.
std::vector<double> extracted(const std::vector<double> &v, const WaveletCandidate &about) {
  const auto far = static_cast<std::size_t>(std::ceil(reach * static_cast<double>(about.scale))),
             half = static_cast<std::size_t>(daubechies_support * about.scale / 2 + 1);
  const auto before = [](std::size_t place, std::size_t by) { return place > by ? place - by : 0; };
  // What none of the wavelets touches stays out of it.
  const std::size_t begin = before(about.place, far + half), end = std::min(v.size(), about.place + far + half + 1);
  const std::size_t first = before(about.place, far), last = std::min(v.size() - 1, about.place + far);
  const WaveletTransform transform(end - begin, about.scale);
  PlaneSignal rest(v.begin() + static_cast<std::ptrdiff_t>(begin), v.begin() + static_cast<std::ptrdiff_t>(end));
  std::vector<double> pulse(v.size(), 0.0);
  for (int n = 0; n < n_wavelets; ++n) {
    const auto heights = transform.heights(rest, about.scale);
    std::size_t place = first;
    for (std::size_t i = first; i <= last; ++i)
      if (std::abs(heights[i - begin].real()) > std::abs(heights[place - begin].real())) place = i;
    for (std::size_t i = begin; i < end; ++i) {
      pulse[i] +=
          heights[place - begin].real() * wavelet_value(static_cast<long>(i) - static_cast<long>(place), about.scale);
      rest[i - begin] = v[i] - pulse[i];
    }
  }
  return pulse;
}

/// Where the pulse has a twentieth of its energy the whole motion must not yet have 17 % of its own.
bool is_late(const std::vector<double> &v, const std::vector<double> &pulse) {
  const double begins = 0.05 * energy(pulse), all = energy(v);
  double of_pulse = 0, of_all = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    of_pulse += pulse[i] * pulse[i];
    if (of_pulse > begins) break;
    of_all += v[i] * v[i];
  }
  return of_all >= 0.17 * all;
}

/// Equation (8) of the paper: velocities in cm/s.
double indicator_of(const std::vector<double> &v, const std::vector<double> &pulse) {
  std::vector<double> rest(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) rest[i] = v[i] - pulse[i];
  const double component = 0.63 * peak_of(rest) / peak_of(v) + 0.777 * energy(rest) / energy(v);
  const double p = (component - 1.208421) / 0.2462717, g = (peak_of(v) - 11.58861) / 18.88015;
  return -7.817 - 0.5679 * p * p - 0.1516 * g * g - 3.0253 * p - 1.7396 * g - 2.7156 * p * g;
}

} // namespace

std::optional<ClassifiedPulse> velocity_pulse(const SampledSignal &first, const SampledSignal &second) {
  if (std::abs(first.dt - second.dt) > 1e-9 * first.dt) return std::nullopt;
  const PlaneSignal v = velocity_of(first, second);
  if (std::all_of(v.begin(), v.end(), [](const auto &value) { return std::norm(value) == 0; })) return std::nullopt;
  const WaveletScales scales = scales_of(first.dt);
  WaveletCandidates wavelets(v, scales);
  std::optional<ClassifiedPulse> largest;
  for (int k = 0; k < n_candidates; ++k) {
    const auto best = wavelets.take(reach);
    const double angle = std::arg(wavelets.height(best));
    const std::complex<double> direction = std::polar(1.0, angle);
    std::vector<double> rotated;
    for (const auto &value : v) rotated.push_back((value * std::conj(direction)).real());
    const long scale = refined_scale(wavelets, best, scales, direction);
    const auto pulse = extracted(rotated, {scale, best.place});
    ClassifiedPulse found{indicator_of(rotated, pulse), std::nullopt, angle * 180 / std::numbers::pi};
    if (found.indicator > 0 && !is_late(rotated, pulse)) {
      found.period = daubechies_period * static_cast<double>(scale) * first.dt;
      return found;
    }
    if (!largest) largest = found;
  }
  return largest;
}

} // namespace rimpact
