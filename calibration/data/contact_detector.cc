#include "calibration/data/contact_detector.h"
#include "calibration/data/quiet_samples.h"
#include "calibration/data/sample_noise.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <optional>

namespace rimpact::calibration {

namespace {

using Values = std::vector<double>;
constexpr double sure = 5;   ///< standard errors that noise does not reach
constexpr double surest = 6; ///< standard errors of a sample that the few differences beside an end do not reach
constexpr std::size_t persistence = 3;
constexpr double same_contact = 0.35; ///< of the earlier contact's length

Values radial_push(const Response &r, double zero_x, double zero_y) {
  const auto &ux = r.series("displacement_x"), &uy = r.series("displacement_y");
  const auto &fx = r.series("impact_x"), &fy = r.series("impact_y");
  Values p(fx.size(), 0.0);
  for (std::size_t i = 0; i < p.size(); ++i)
    if (const double travel = std::hypot(ux[i], uy[i]); travel > 0)
      p[i] = 0 - ((fx[i] - zero_x) * ux[i] + (fy[i] - zero_y) * uy[i]) / travel;
  return p;
}

Values boxcar(const Values &v, std::size_t half) {
  Values smooth(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    const std::size_t h = std::min({half, i, v.size() - 1 - i});
    smooth[i] = std::accumulate(v.begin() + (i - h), v.begin() + (i + h + 1), 0.0) / static_cast<double>(2 * h + 1);
  }
  return smooth;
}

double largest(const Values &v) {
  double top = 0;
  for (const double x : v) top = std::max(top, std::abs(x));
  return top;
}

class Search {
public:
  /// Without `travel` contacts last as long as the force does.
  Search(const Values &times, const Values *travel, ContactRecord &record, double share)
      : t_(times), travel_(travel), r_(record) {
    const std::size_t held = std::count_if(r_.push.begin(), r_.push.end(),
                                           [top = largest(r_.push)](double p) { return std::abs(p) > 0.5 * top; });
    half_ = r_.sigma > 0 ? std::min<std::size_t>(held / 30, 7) : 0;
    r_.smooth = boxcar(r_.push, half_);
    r_.peak = largest(r_.smooth);
    const double m = 2.0 * static_cast<double>(half_) + 1;
    low_ = std::max(sure * r_.sigma * std::sqrt(std::min(1.0, r_.inflation / m)), 1e-9 * r_.peak);
    r_.threshold = std::max(low_, share * r_.peak);
    r_.contacts.clear();
    if (r_.peak > 0) find();
  }

private:
  bool beyond(std::size_t i, double level) const { return i < r_.smooth.size() && std::abs(r_.smooth[i]) > level; }

  void find() {
    const std::size_t needed = r_.sigma > 0 ? persistence : 1;
    for (std::size_t i = 0; i < r_.smooth.size(); ++i) {
      if (!beyond(i, r_.threshold)) continue;
      std::size_t first = i, last = i;
      while (beyond(last + 1, r_.threshold)) ++last;
      const bool holds = last - first + 1 >= needed;
      while (first > 0 && beyond(first - 1, low_)) --first;
      while (beyond(last + 1, low_)) ++last;
      i = last;
      if (holds) add(first, last);
    }
    if (travel_) leave_behind(*travel_);
    for (auto &c : r_.contacts) measure(c);
    std::erase_if(r_.contacts, [&](const Contact &c) { return std::abs(c.impulse) <= sure * c.impulse_error; });
  }

  /// A rim does not follow a slider to clearly inside where it was touched: what reads on there is the cell's.
  void leave_behind(const Values &travel) {
    constexpr double clearly = 0.25; // of how far the slider went in
    const double noise = sure * noise_of_differences(travel);
    for (auto &c : r_.contacts) {
      const double farthest = *std::max_element(travel.begin() + c.first, travel.begin() + c.last + 1),
                   inside = travel[c.first] - clearly * (farthest - travel[c.first]) - noise;
      while (c.last > c.first && travel[c.last] < inside) --c.last;
    }
  }

  void add(std::size_t first, std::size_t last) {
    if (!r_.contacts.empty()) {
      auto &before = r_.contacts.back();
      if (t_[first] - t_[before.last] < same_contact * (t_[before.last] - t_[before.first])) {
        before.last = last;
        return;
      }
    }
    r_.contacts.push_back({first, last, 0, 0, false, 0, 0});
  }

  /// The middle of the step by which the samples themselves jump at the contact's first (last) one, where no noise
  /// makes such a step: nothing of the force is hidden there.
  std::optional<double> jump(std::size_t at, int inwards) const {
    const std::size_t from = at - std::min(at, half_ + 1), to = std::min(at + half_ + 1, t_.size() - 1);
    double largest = surest * r_.sigma;
    std::optional<double> middle;
    for (std::size_t i = from; i < to; ++i)
      if (const double step = inwards * (std::abs(r_.push[i + 1]) - std::abs(r_.push[i])); step > largest)
        largest = step, middle = 0.5 * (t_[i] + t_[i + 1]);
    return middle;
  }

  /// Where the force is zero: in the middle of the step it jumps by, else as long before its first sample (after its
  /// last) as it takes to rise by what the threshold hides.
  double followed_to_zero(std::size_t at, int inwards) const {
    const double step = inwards > 0 ? t_[at] - t_[at - 1] : t_[at + 1] - t_[at];
    if (const auto middle = jump(at, inwards)) return *middle;
    const std::size_t reach = half_ + 3,
                      other = inwards > 0 ? std::min(at + reach, t_.size() - 1) : at - std::min(at, reach);
    const double force = std::abs(r_.smooth[at]),
                 slope = (std::abs(r_.smooth[other]) - force) / std::abs(t_[other] - t_[at]);
    const double hidden = slope > 0 ? std::min(force, low_) / slope : 0, limit = 5 * std::abs(t_[other] - t_[at]);
    return t_[at] - inwards * std::max(0.5 * step, std::min(hidden, limit));
  }

  void measure(Contact &c) const {
    c.jumps = c.first == 0 || jump(c.first, 1).has_value();
    c.touch_time = c.first > 0 ? std::max(t_.front(), followed_to_zero(c.first, 1)) : t_.front();
    c.release_time = c.last + 1 < t_.size() ? std::min(t_.back(), followed_to_zero(c.last, -1)) : t_.back();
    double square = 0;
    for (std::size_t i = std::max<std::size_t>(c.first, 1); i <= c.last; ++i) {
      const double dt = t_[i] - t_[i - 1];
      c.impulse += 0.5 * dt * (r_.push[i] + r_.push[i - 1]);
      square += dt * dt;
    }
    c.impulse_error = r_.sigma * std::sqrt(r_.inflation * square);
  }

  const Values &t_;
  const Values *travel_;
  ContactRecord &r_;
  std::size_t half_ = 0; ///< the mean reaches so far on both sides
  double low_ = 0;
};

} // namespace

ContactRecord find_contacts(const Response &response, double share) {
  const auto &x = response.series("impact_x"), &y = response.series("impact_y"), &times = response.series("time");
  ContactRecord record;
  Values travel;
  for (std::size_t i = 0; i < times.size(); ++i)
    travel.push_back(std::hypot(response.series("displacement_x")[i], response.series("displacement_y")[i]));
  const std::size_t n = quiet_beginning(x, y);
  if (n >= few_quiet) record.zero_x = mean_of(x, n), record.zero_y = mean_of(y, n);
  record.push = radial_push(response, record.zero_x, record.zero_y);
  const double digits = std::max(noise_of_digits(x), noise_of_digits(y));
  first_noise(record, n);
  record.sigma = std::max(record.sigma, digits);
  for (int pass = 0; pass < 2; ++pass) { // the second against what is quiet beside the contacts of the first
    Search(times, pass == 0 ? nullptr : &travel, record, share); // a zero that is guessed makes a tail of its own
    record.zero_x = record.zero_y = 0;
    record.push = radial_push(response, 0, 0);
    measure_quiet(record, x, y);
    record.sigma = std::max(record.sigma, digits);
    record.push = radial_push(response, record.zero_x, record.zero_y);
  }
  Search(times, &travel, record, share);
  if (record.zero_x != 0 || record.zero_y != 0)
    record.notes.push_back(fmt::format("the force reads {:.4g} kN where the rim is not touched: taken off",
                                       1e-3 * std::hypot(record.zero_x, record.zero_y)));
  return record;
}

} // namespace rimpact::calibration
