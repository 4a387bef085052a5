#include "io/records/record_doubts.h"
#include "io/records/record.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

/// Root of the mean square of the signal's rate over that of the signal [rad/s]; 0 for a signal of nothing.
double mean_rate(const SampledSignal &record) {
  double squares = 0, rates = 0;
  for (std::size_t i = 0; i + 1 < record.values.size(); ++i) {
    const double a = record.values[i], rate = (record.values[i + 1] - a) / record.dt;
    squares += a * a, rates += rate * rate;
  }
  return squares > 0 ? std::sqrt(rates / squares) : 0;
}

void doubt_drift(const SampledSignal &record, std::vector<std::string> &found) {
  const BaselineDrift drift = baseline_drift(record);
  constexpr double share = 0.1, least = 0.03, farthest = 10; // [-], [m/s], [m]
  if (std::abs(drift.end_velocity) > std::max(least, share * drift.peak_velocity))
    found.push_back(
        fmt::format("it ends at {:.3g} m/s (peak {:.3g}) and {:.3g} m: an offset of {:.3g} m/s^2 explains it; "
                    "`rimpact motion FILE --baseline DIR` takes it off",
                    drift.end_velocity, drift.peak_velocity, drift.end_travel, drift.end_velocity / record.duration()));
  else if (drift.peak_travel > farthest)
    found.push_back(fmt::format("the ground moves by {:.3g} m, beyond {:g} m", drift.peak_travel, farthest));
}

SampledSignal derivative(const SampledSignal &record) {
  SampledSignal rate{record.dt, {}};
  for (std::size_t i = 0; i + 1 < record.values.size(); ++i)
    rate.values.push_back((record.values[i + 1] - record.values[i]) / record.dt);
  return rate;
}

/// A signal slower than any acceleration whose derivative, or that of it, is as fast as one. Of smooth pulses made up
/// the derivatives are slow, too.
void doubt_rate(const SampledSignal &record, std::vector<std::string> &found) {
  constexpr double slowest = 6, usual_low = 8, usual_high = 107; // [rad/s], of 307 records of PEER
  const double rate = mean_rate(record);
  if (!(rate < slowest)) return;
  const SampledSignal once = derivative(record);
  const double of_first = mean_rate(once), of_second = mean_rate(derivative(once));
  if (of_first >= usual_low || of_second >= usual_low)
    found.push_back(fmt::format("it turns at {:.2g} rad/s on average, where accelerations turn at {:g} to {:g}; its {} "
                                "derivative does so: is it a {}?",
                                rate, usual_low, usual_high, of_first >= usual_low ? "first" : "second",
                                of_first >= usual_low ? "velocity" : "displacement"));
}

void doubt_kind(const SampledSignal &record, std::vector<std::string> &found) {
  std::size_t positive = 0, negative = 0;
  for (const double a : record.values) positive += a > 0, negative += a < 0;
  constexpr std::size_t enough = 20;
  if (positive + negative >= enough && std::min(positive, negative) * 50 < positive + negative)
    return found.push_back(fmt::format("{} of its {} values have one sign: is it a spectrum, not a record?",
                                       std::max(positive, negative), record.values.size()));
  if (positive + negative >= enough) doubt_rate(record, found);
}

void doubt_size(const SampledSignal &record, double gravity, std::vector<std::string> &found) {
  const double largest = peak_of(record.values);
  constexpr double strongest = 2, weakest = 0.003; // [g]
  if (largest > strongest * gravity)
    found.push_back(fmt::format("its peak is {:.3g} g, where {:g} g is rare: is the unit right, is it scaled twice?",
                                largest / gravity, strongest));
  if (largest < weakest * gravity)
    found.push_back(fmt::format("its peak is {:.2g} g: are values in g taken for m/s^2 or cm/s^2?", largest / gravity));
  const auto at_peak = std::count_if(record.values.begin(), record.values.end(),
                                     [&](double a) { return largest > 0 && std::abs(a) >= largest * (1 - 1e-9); });
  constexpr int held = 3;
  if (at_peak >= held)
    found.push_back(fmt::format("{} values stand at its peak of {:.4g} g: was the instrument saturated?", at_peak,
                                largest / gravity));
}

} // namespace

BaselineDrift baseline_drift(const SampledSignal &record) {
  BaselineDrift drift{};
  integrate_from_rest(record, [&](std::size_t, double v, double u) {
    drift.peak_velocity = std::max(drift.peak_velocity, std::abs(v));
    drift.peak_travel = std::max(drift.peak_travel, std::abs(u));
    drift.end_velocity = v, drift.end_travel = u;
  });
  return drift;
}

std::vector<std::string> record_doubts(const SampledSignal &record, double gravity) {
  std::vector<std::string> found;
  doubt_drift(record, found);
  doubt_kind(record, found);
  doubt_size(record, gravity, found);
  return found;
}

SampledSignal baseline_corrected(const SampledSignal &record) {
  // v(t) = b t + c t^2 by least squares; sums over the samples of t and of the velocity.
  double t2 = 0, t3 = 0, t4 = 0, vt = 0, vt2 = 0;
  integrate_from_rest(record, [&](std::size_t i, double v, double) {
    const double t = record.dt * static_cast<double>(i);
    t2 += t * t, t3 += t * t * t, t4 += t * t * t * t, vt += v * t, vt2 += v * t * t;
  });
  const double determinant = t2 * t4 - t3 * t3;
  if (!(determinant > 0)) return record;
  const double b = (vt * t4 - vt2 * t3) / determinant, c = (vt2 * t2 - vt * t3) / determinant;
  SampledSignal corrected = record;
  for (std::size_t i = 0; i < record.values.size(); ++i)
    corrected.values[i] -= b + 2 * c * record.dt * static_cast<double>(i);
  return corrected;
}

} // namespace rimpact
