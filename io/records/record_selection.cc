#include "io/records/record_selection.h"
#include "io/files/error.h"
#include "io/records/record_library.h"
#include "io/records/rotated_spectrum.h"
#include "io/records/scaled_copies.h"
#include "io/records/spectral_acceleration.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact {
namespace {

constexpr std::size_t n_periods = 40;

std::vector<double> periods_of(const SelectionRules &rules) {
  std::vector<double> periods;
  const double low = std::log(rules.from * rules.period), high = std::log(rules.to * rules.period);
  for (std::size_t i = 0; i < n_periods; ++i)
    periods.push_back(std::exp(std::lerp(low, high, static_cast<double>(i) / (n_periods - 1))));
  return periods;
}

double largest_direction(const SampledSignal &x, const SampledSignal &y, double period) {
  const auto along = oscillator_travel(x, period), across = oscillator_travel(y, period);
  double largest = 0;
  for (std::size_t i = 0; i < along.size(); ++i) largest = std::max(largest, std::hypot(along[i], across[i]));
  const double w = 2 * std::numbers::pi / period;
  return w * w * largest;
}

std::vector<double> spectrum_of(const SelectedRecording &recording, const std::vector<double> &periods,
                                bool is_largest) {
  const auto x = shared_record(recording.x), y = recording.y.empty() ? x : shared_record(recording.y);
  const auto [first, second] = together(*x, *y);
  std::vector<double> spectrum;
  for (const double period : periods) {
    const double sa = recording.y.empty() ? spectral_acceleration(first, period)
                      : is_largest
                          ? largest_direction(first, second, period)
                          : std::sqrt(spectral_acceleration(first, period) * spectral_acceleration(second, period));
    spectrum.push_back(sa / standard_gravity);
  }
  return spectrum;
}

/// Sets factor and misfit.
void fit(SelectedRecording &recording, const std::vector<double> &target) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const double off = std::log(target[i] / recording.spectrum[i]);
    sum += off, squares += off * off;
  }
  const double n = static_cast<double>(target.size()), mean = sum / n;
  recording.factor = std::exp(mean);
  recording.misfit = std::sqrt(std::max(0.0, squares / n - mean * mean));
  for (auto &sa : recording.spectrum) sa *= recording.factor;
}

std::vector<SelectedRecording> candidates_of(const RecordFolder &folder) {
  std::vector<SelectedRecording> pairs, alone;
  for (const auto &station : folder.stations) {
    if (station.is_pair())
      pairs.push_back({.station = station.name,
                       .x = folder.records[station.horizontal[0]].path,
                       .y = folder.records[station.horizontal[1]].path});
    else if (!station.horizontal.empty())
      alone.push_back({.station = station.name, .x = folder.records[station.horizontal[0]].path, .y = ""});
  }
  return pairs.empty() ? alone : pairs;
}

/// Recordings that can be read, move, and are no other one scaled.
std::vector<SelectedRecording> usable(std::vector<SelectedRecording> all, std::vector<std::string> &doubts) {
  std::vector<SelectedRecording> good;
  std::vector<std::shared_ptr<const SampledSignal>> signals;
  for (auto &recording : all) {
    try {
      const auto signal = shared_record(recording.x);
      if (!recording.y.empty() && !(peak_of(shared_record(recording.y)->values) > 0)) continue;
      if (!(peak_of(signal->values) > 0)) continue;
      signals.push_back(signal);
      good.push_back(std::move(recording));
    } catch (const DataError &error) {
      doubts.emplace_back(error.what());
    }
  }
  const auto copies = scaled_copies(signals);
  std::vector<SelectedRecording> own;
  for (std::size_t i = 0; i < good.size(); ++i)
    if (copies[i])
      doubts.push_back(fmt::format("{} is {} scaled: it is not taken", good[i].station, good[copies[i]->of].station));
    else
      own.push_back(good[i]);
  return own;
}

/// The mean, and the factor that lifts it to the share that is asked.
void lift(RecordSelection &selection, double least_share) {
  selection.mean.assign(selection.periods.size(), 0);
  for (const auto &recording : selection.recordings)
    for (std::size_t i = 0; i < selection.mean.size(); ++i)
      selection.mean[i] += recording.spectrum[i] / static_cast<double>(selection.recordings.size());
  for (std::size_t i = 0; i < selection.mean.size(); ++i)
    selection.common = std::max(selection.common, least_share * selection.target[i] / selection.mean[i]);
  for (auto &mean : selection.mean) mean *= selection.common;
  for (auto &recording : selection.recordings) {
    recording.factor *= selection.common;
    for (auto &sa : recording.spectrum) sa *= selection.common;
  }
}

} // namespace

RecordSelection select_records(const RecordFolder &folder, const TargetSpectrum &target, const SelectionRules &rules) {
  RecordSelection selection{.periods = periods_of(rules), .target = {}, .mean = {}, .recordings = {}};
  for (const double period : selection.periods) selection.target.push_back(target.at(period));
  std::vector<SelectedRecording> fitting;
  for (auto &recording : usable(candidates_of(folder), selection.doubts)) {
    ++selection.n_candidates;
    recording.spectrum = spectrum_of(recording, selection.periods, target.is_largest_direction());
    fit(recording, selection.target);
    if (recording.factor <= rules.largest_scale && recording.factor >= 1 / rules.largest_scale)
      fitting.push_back(std::move(recording));
  }
  if (fitting.size() < rules.count)
    throw InputError(fmt::format("{}: {} of {} recordings have a factor from {:.3g} to {:g}, {} are asked for; take "
                                 "fewer, more records, or a larger factor",
                                 folder.path, fitting.size(), selection.n_candidates, 1 / rules.largest_scale,
                                 rules.largest_scale, rules.count));
  std::stable_sort(fitting.begin(), fitting.end(), [](const auto &a, const auto &b) { return a.misfit < b.misfit; });
  fitting.resize(rules.count);
  selection.recordings = std::move(fitting);
  lift(selection, rules.least_share);
  return selection;
}

} // namespace rimpact
