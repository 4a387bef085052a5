#include "calibration/data/measured_record.h"
#include "calibration/data/sample_noise.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

constexpr double flight_time = 0.05; ///< of a flight before touch, at most [s]

} // namespace

MeasuredRecord::MeasuredRecord(const StoredRun &run, const WindowOptions &options)
    : run_(run), r_(run.response), times_(run.response.series("time")), options_(options),
      force_(find_contacts(run.response, options.force_threshold)) {
  for (const double y : r_.series("displacement_y")) planar_ = planar_ || y != 0;
  for (std::size_t i = 0; i < contacts().size(); ++i) flights_.push_back(flights_of(i));
  measure_noise();
}

Span MeasuredRecord::between(double from, double to) const {
  const auto first = std::lower_bound(times_.begin(), times_.end(), from),
             end = std::upper_bound(times_.begin(), times_.end(), to);
  if (end <= first) return {};
  return {static_cast<std::size_t>(first - times_.begin()), static_cast<std::size_t>(end - times_.begin()) - 1};
}

bool MeasuredRecord::inside(std::size_t i) const {
  const auto &x = r_.series("displacement_x"), &y = r_.series("displacement_y");
  const std::size_t h = std::min({std::size_t(2), i, times_.size() - 1 - i});
  double travel = 0;
  for (std::size_t j = i - h; j <= i + h; ++j) travel += std::hypot(x[j], y[j]);
  return travel < static_cast<double>(2 * h + 1) * run_.scene.bearing.lateral_capacity();
}

/// As far again before touch as the force was followed back to zero; or, where the rim's place is not in question,
/// until L_c is passed.
double MeasuredRecord::free_until(const Contact &c) const {
  const double by_force = c.touch_time - std::max(0.0, times_[c.first] - c.touch_time);
  std::size_t i = c.first;
  while (i > 0 && times_[i] > by_force && !inside(i - 1)) --i;
  return options_.touch == TouchReference::gap || i < 2
             ? by_force
             : std::max(by_force, std::min(times_[i - 1], c.jumps ? c.touch_time : times_[i - 1]));
}
double MeasuredRecord::free_from(const Contact &c) const {
  const double by_force = c.release_time + std::max(0.0, c.release_time - times_[c.last]);
  std::size_t i = c.last;
  while (i + 1 < times_.size() && times_[i] < by_force && !inside(i)) ++i;
  return options_.touch == TouchReference::gap ? by_force : std::min(by_force, times_[i]);
}

Flights MeasuredRecord::flights_of(std::size_t i) const {
  const auto &all = contacts();
  const double to = free_until(all[i]), from = free_from(all[i]);
  const double begin = i > 0 ? free_from(all[i - 1]) : times_.front();
  const double end = i + 1 < all.size() ? free_until(all[i + 1]) : times_.back();
  Flights f{between(std::max(begin, to - flight_time), to), between(from, std::min(end, from + options_.tail))};
  if (f.before.size() > 0 && f.before.last >= all[i].first) // the first sample that bears force is not of the flight
    f.before = all[i].first > f.before.first ? Span{f.before.first, all[i].first - 1} : Span{};
  if (f.after.size() > 0 && f.after.first <= all[i].last) f.after.first = all[i].last + 1;
  return f;
}

FlightFit MeasuredRecord::state(const Span &flight, double t_ref) const {
  return fit_flight(run_.scene, r_, flight.first, flight.last, t_ref, sigma_, planar_);
}

void MeasuredRecord::measure_noise() {
  const auto &ux = r_.series("displacement_x");
  std::vector<Span> spans;
  for (const auto &f : flights_)
    for (const Span &s : {f.before, f.after})
      if (s.size() >= shortest_flight) spans.push_back(s);
  if (spans.empty()) sigma_ = displacement_noise(ux, 0, ux.size() - 1);
  for (const Span &s : spans) sigma_ = std::max(sigma_, displacement_noise(ux, s.first, s.last));
  double square = 0, lag = 0, n = 0;
  for (const Span &s : spans) {
    const auto fit = state(s, times_[s.first]);
    square += fit.square, freedom_ += fit.freedom;
    lag += fit.lag * static_cast<double>(s.size()), n += static_cast<double>(s.size());
  }
  if (freedom_ > 1) sigma_ = std::sqrt(square / freedom_);
  sigma_ = std::max(sigma_, noise_of_digits(ux));
  if (n > 0 && lag / n > 3 / std::sqrt(n)) inflation_ = (1 + lag / n) / std::max(1 - lag / n, 0.02);
}

std::string MeasuredRecord::sentence() const {
  const double share = force_.peak > 0 ? force_.sigma / force_.peak : 0,
               wanted = force_.peak > 0 ? force_.threshold / force_.peak : 0;
  std::string text =
      fmt::format("noise found in the record: displacement {:.2g} mm, force {:.3g} kN ({:.2g} % of the peak)",
                  1e3 * sigma_, 1e-3 * force_.sigma, 100 * share);
  if (inflation_ > 1)
    text += fmt::format(
        "; errors of neighbouring displacement samples hang together, which widens what is said of speeds {:.2g} times",
        std::sqrt(inflation_));
  if (force_.inflation > 1)
    text +=
        fmt::format("; errors of neighbouring force samples hang together (a filter?): an average of them is {:.2g} "
                    "times less certain than of independent ones",
                    std::sqrt(force_.inflation));
  if (!(force_.sigma > 0) || wanted <= 1.001 * options_.force_threshold) return text;
  text += fmt::format("; contacts are looked for above {:.2g} % of the peak: ", 100 * wanted);
  if (options_.force_threshold > 0)
    return text + fmt::format("force_noise = {:g} is too small for this noise, which asks for {:.2g}",
                              options_.force_threshold, wanted);
  return text + fmt::format("force_noise = {:.2g} says the same", wanted);
}

} // namespace rimpact::calibration
