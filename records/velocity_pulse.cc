#include "records/velocity_pulse.h"
#include "records/daubechies.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace rimpact {
namespace {

constexpr double shortest_period = 0.25, longest_period = 15; // [s]
constexpr int n_scales = 51, n_candidates = 5, n_wavelets = 10;
constexpr double reach = 0.4;    // of a scale: how far wavelets of one pulse lie apart
constexpr double samples = 16.0; // of a wavelet's scale, at least as many as the record has

/// Velocity [cm/s] at even instants.
struct Velocity {
  double dt;
  std::vector<double> values;
};

Velocity velocity_of(const SampledSignal &record, std::size_t n) {
  Velocity v{record.dt, std::vector<double>(n, 0.0)};
  constexpr double centimetres = 100; // in a metre
  integrate_from_rest(record, [&](std::size_t i, double speed, double) { v.values[i] = centimetres * speed; });
  for (std::size_t i = record.values.size(); i < n; ++i) v.values[i] = v.values[i - 1];
  return v;
}

/// Means of `stride` samples each.
Velocity thinned(const Velocity &v, std::size_t stride) {
  Velocity result{v.dt * static_cast<double>(stride), {}};
  for (std::size_t i = 0; i + stride <= v.values.size(); i += stride) {
    double sum = 0;
    for (std::size_t k = 0; k < stride; ++k) sum += v.values[i + k];
    result.values.push_back(sum / static_cast<double>(stride));
  }
  return result;
}

double wavelet_at(double t, double centre, double scale) {
  return daubechies_wavelet((t - centre) / scale + daubechies_support / 2);
}

/// Height of the wavelet of `scale` [s] about `centre` [s]: int v psi dt / scale. The first mean of v lies at `origin`.
double coefficient(const Velocity &v, double origin, double centre, double scale) {
  const double half = daubechies_support / 2 * scale;
  const double first = std::max(0.0, std::ceil((centre - half - origin) / v.dt));
  double sum = 0;
  for (auto i = static_cast<std::size_t>(first); i < v.values.size(); ++i) {
    const double t = origin + v.dt * static_cast<double>(i);
    if (t > centre + half) break;
    sum += v.values[i] * wavelet_at(t, centre, scale);
  }
  return sum * v.dt / scale;
}

/// A velocity at the spacing that a scale asks for.
struct AtScale {
  AtScale(const Velocity &v, double scale)
      : scale(scale), thin(thinned(v, static_cast<std::size_t>(std::max(1.0, std::floor(scale / samples / v.dt))))),
        origin((thin.dt - v.dt) / 2) {}
  double at(double centre) const { return coefficient(thin, origin, centre, scale); }
  double scale;
  Velocity thin;
  double origin;
};

struct Candidate {
  double scale, centre, along, across; ///< heights in both components
  double strength() const { return scale * (along * along + across * across); }
};

std::vector<Candidate> all_wavelets(const Velocity &first, const Velocity &second) {
  std::vector<Candidate> all;
  const double low = shortest_period / daubechies_period, high = longest_period / daubechies_period;
  for (int k = 0; k < n_scales; ++k) {
    const AtScale one(first, low + (high - low) * k / (n_scales - 1)), two(second, one.scale);
    for (std::size_t i = 0; i < one.thin.values.size(); ++i) {
      const double centre = one.origin + one.thin.dt * static_cast<double>(i);
      all.push_back({one.scale, centre, one.at(centre), two.at(centre)});
    }
  }
  return all;
}

/// Of the scales beside the candidate's the one whose wavelet is the strongest there.
double refined_scale(const Velocity &v, const Candidate &candidate) {
  const double step = (longest_period - shortest_period) / daubechies_period / (n_scales - 1);
  double best = candidate.scale, strongest = 0;
  constexpr int parts = 20;
  for (int k = -parts; k <= parts; ++k) {
    const double scale = candidate.scale + step * k / parts;
    if (scale < shortest_period / daubechies_period || scale > longest_period / daubechies_period) continue;
    const double strength = std::sqrt(scale) * std::abs(AtScale(v, scale).at(candidate.centre));
    if (strength > strongest) strongest = strength, best = scale;
  }
  return best;
}

double energy(const std::vector<double> &v) {
  double sum = 0;
  for (const double value : v) sum += value * value;
  return sum;
}

/// Ten wavelets of one scale about a place, taken off one after the other.
std::vector<double> extracted(const Velocity &v, double scale, double centre) {
  Velocity rest = v;
  for (int n = 0; n < n_wavelets; ++n) {
    const AtScale at(rest, scale);
    double place = centre, height = 0;
    for (double b = centre - reach * scale; b <= centre + reach * scale; b += at.thin.dt)
      if (const double c = at.at(b); std::abs(c) > std::abs(height)) place = b, height = c;
    for (std::size_t i = 0; i < rest.values.size(); ++i)
      rest.values[i] -= height * wavelet_at(v.dt * static_cast<double>(i), place, scale);
  }
  std::vector<double> pulse(v.values.size());
  for (std::size_t i = 0; i < pulse.size(); ++i) pulse[i] = v.values[i] - rest.values[i];
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
  const std::size_t n = std::max(first.values.size(), second.values.size());
  const Velocity one = velocity_of(first, n), two = velocity_of(second, n);
  if (!(peak_of(one.values) + peak_of(two.values) > 0)) return std::nullopt;
  auto wavelets = all_wavelets(one, two);
  std::optional<ClassifiedPulse> largest;
  for (int k = 0; k < n_candidates && !wavelets.empty(); ++k) {
    const Candidate best = *std::max_element(wavelets.begin(), wavelets.end(),
                                             [](const auto &a, const auto &b) { return a.strength() < b.strength(); });
    const double angle = std::atan2(best.across, best.along), c = std::cos(angle), s = std::sin(angle);
    Velocity rotated = one;
    for (std::size_t i = 0; i < n; ++i) rotated.values[i] = c * one.values[i] + s * two.values[i];
    const double scale = refined_scale(rotated, best);
    const auto pulse = extracted(rotated, scale, best.centre);
    ClassifiedPulse found{indicator_of(rotated.values, pulse), std::nullopt, angle * 180 / std::numbers::pi};
    if (found.indicator > 0 && !is_late(rotated.values, pulse)) {
      found.period = daubechies_period * scale;
      return found;
    }
    if (!largest) largest = found;
    std::erase_if(wavelets, [&](const auto &w) { return std::abs(w.centre - best.centre) < reach * best.scale; });
  }
  return largest;
}

} // namespace rimpact
