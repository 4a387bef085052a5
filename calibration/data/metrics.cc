#include "calibration/data/metrics.h"
#include "calibration/data/series.h"
#include "io/files/error.h"
#include "responses/open_impact.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace rimpact::calibration {

namespace {

/// Compared after the last release [s] (docs/interface.md).
constexpr double after_release = 0.5;
/// A record that begins so much after the other's touch misses it [s]: a window's begins at its touch.
constexpr double late = 1e-4;

struct Overlap {
  double begin, end;
};

/// Union of both time bases within the span, its ends included.
std::vector<double> common_times(const std::vector<double> &a, const std::vector<double> &b, Overlap span) {
  std::vector<double> times = {span.begin, span.end};
  for (const auto *base : {&a, &b})
    for (const double t : *base)
      if (t > span.begin && t < span.end) times.push_back(t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Mean over the span of the squared norm of a planar signal's difference; both signals are linear between
/// samples, so the integral of the square is exact.
double mean_square(const Response &reference, const Response &candidate, const std::string &signal, Overlap span) {
  const auto &tr = reference.series("time"), &tc = candidate.series("time");
  const auto times = common_times(tr, tc, span);
  if (span.end <= span.begin) return 0;
  double integral = 0;
  for (const char *axis : {"_x", "_y"}) {
    const auto &r = reference.series(signal + axis), &c = candidate.series(signal + axis);
    double before = linear_at(tc, c, times[0]) - linear_at(tr, r, times[0]);
    for (std::size_t i = 1; i < times.size(); ++i) {
      const double now = linear_at(tc, c, times[i]) - linear_at(tr, r, times[i]);
      integral += (times[i] - times[i - 1]) * (before * before + before * now + now * now) / 3;
      before = now;
    }
  }
  return integral / (span.end - span.begin);
}

/// `response` as it looks at the instants of `times`.
Response sampled_at(const Response &response, const std::vector<double> &times, const std::string &signal) {
  Response result;
  result.series("time") = times;
  for (const char *axis : {"_x", "_y"})
    for (const double t : times)
      result.append(signal + axis, linear_at(response.series("time"), response.series(signal + axis), t));
  return result;
}

/// What straight lines between the samples of one make of the other itself, which is no difference of the two. `found`:
/// the mean square of the displacements' difference [m^2].
void tell_sampling(const Response &reference, const Response &candidate, Overlap span, double found,
                   double lateral_capacity, Comparison &result) {
  constexpr double much = 0.3, worth_telling = 1e-3; // of the difference found, of L_c
  for (const auto &[fine, coarse, name] :
       {std::tuple(&reference, &candidate, "candidate"), std::tuple(&candidate, &reference, "reference")}) {
    const auto &times = coarse->series("time");
    const double own = mean_square(*fine, sampled_at(*fine, times, "displacement"), "displacement", span);
    if (own > much * much * found && own > std::pow(worth_telling * lateral_capacity, 2))
      result.notes.push_back(fmt::format(
          "the {} has a sample every {:.3g} ms on average: straight lines between them make {:.0f} % of the "
          "displacement's difference, and its first touch is known to one of them",
          name, 1e3 * (times.back() - times.front()) / static_cast<double>(times.size() - 1),
          100 * std::min(1.0, std::sqrt(own / found))));
  }
}

Summary summary_of(Response response) {
  for (const char *axis : {"_x", "_y"})
    if (!response.has(std::string("velocity") + axis))
      response.series(std::string("velocity") + axis) =
          differentiate(response.series("time"), response.series(std::string("displacement") + axis));
  Summary summary;
  summarise_response(response, summary);
  if (doubt_of_rebound(response, summary.impacts)) summary.impacts.back() = left_open(summary.impacts.back());
  return summary;
}

std::optional<double> relative(double candidate, double reference) {
  if (reference == 0) return {};
  return (candidate - reference) / reference;
}

const Impact &hardest(const Summary &summary) {
  return *std::max_element(summary.impacts.begin(), summary.impacts.end(),
                           [](const auto &a, const auto &b) { return a.peak_force < b.peak_force; });
}

/// Of the hardest impacts, where both were let go.
void compare_rebounds(const Impact &theirs, const Impact &ours, Comparison &result) {
  if (is_open(theirs) || is_open(ours)) {
    result.notes.push_back(fmt::format("the {} ends while the rim is pressed: no rebound to compare",
                                       is_open(theirs) ? "reference" : "candidate"));
    return;
  }
  result.rebound_error = relative(ours.rebound_speed, theirs.rebound_speed);
  result.restitution_error = relative(ours.restitution(), theirs.restitution());
  if (!result.rebound_error) result.notes.push_back("the reference does not rebound: no rebound to compare");
}

/// `their_begin`, `our_begin`: first instants of reference and candidate [s].
void compare_impacts(const Summary &reference, const Summary &candidate, double their_begin, double our_begin,
                     Comparison &result) {
  if (reference.impacts.empty()) {
    result.notes.push_back(candidate.impacts.empty()
                               ? "neither touches the rim: no impact to compare"
                               : "the reference never touches the rim, the candidate does: no impact to compare");
    return;
  }
  const auto &theirs = hardest(reference);
  if (!is_open(theirs) && our_begin > theirs.release_time) {
    result.notes.push_back(fmt::format("the candidate begins {:.4g} ms after the reference's hardest impact: nothing "
                                       "says how hard it hits, and when",
                                       1e3 * (our_begin - theirs.release_time)));
    return;
  }
  if (candidate.impacts.empty()) {
    result.peak_force_error = -1.0;
    result.notes.push_back("the candidate never touches the rim, the reference does");
    return;
  }
  const auto &ours = hardest(candidate);
  result.peak_force_error = relative(ours.peak_force, theirs.peak_force);
  result.approach_speed_error = relative(ours.approach_speed, theirs.approach_speed);
  compare_rebounds(theirs, ours, result);
  const double touch = reference.impacts.front().touch_time, own_touch = candidate.impacts.front().touch_time;
  if (our_begin > touch + late || their_begin > own_touch + late)
    result.notes.push_back(fmt::format("the {} begins after the other's first touch: no touch to compare",
                                       our_begin > touch + late ? "candidate" : "reference"));
  else
    result.touch_time_difference = own_touch - touch;
  if (candidate.impacts.size() != reference.impacts.size())
    result.notes.push_back(
        fmt::format("{} impacts against {} of the reference", candidate.impacts.size(), reference.impacts.size()));
}

} // namespace

Comparison compare(const Response &reference, const Response &candidate, double lateral_capacity) {
  if (!(lateral_capacity > 0)) throw InputError(fmt::format("lateral capacity {:g} m must be > 0", lateral_capacity));
  if (reference.size() < 2 || candidate.size() < 2)
    throw DataError("a response with fewer than two samples cannot be compared");
  const auto &tr = reference.series("time"), &tc = candidate.series("time");
  const Overlap overlap{std::max(tr.front(), tc.front()), std::min(tr.back(), tc.back())};
  if (!(overlap.begin < overlap.end))
    throw DataError(fmt::format("the responses do not overlap in time: {:g}..{:g} s and {:g}..{:g} s", tr.front(),
                                tr.back(), tc.front(), tc.back()));
  const auto theirs = summary_of(reference), ours = summary_of(candidate);
  Comparison result;
  compare_impacts(theirs, ours, tr.front(), tc.front(), result);
  result.peak_displacement_error = relative(ours.peak_displacement, theirs.peak_displacement);

  Overlap span = overlap;
  if (!theirs.impacts.empty()) {
    span.begin = std::max(span.begin, theirs.impacts.front().touch_time);
    const Impact &last = theirs.impacts.back();
    const double release = is_open(last) ? tr.back() : last.release_time;
    span.end = std::min(span.end, release + after_release);
    if (!(span.begin < span.end)) throw DataError("the candidate ends before the reference's first impact");
    if (tc.back() < release)
      result.notes.push_back("the candidate ends before the reference's last release: compared up to its end");
  }
  const double off = mean_square(reference, candidate, "displacement", span);
  result.nrmse_displacement = std::sqrt(off) / lateral_capacity;
  tell_sampling(reference, candidate, span, off, lateral_capacity, result);
  if (!theirs.impacts.empty())
    result.nrmse_force = std::sqrt(mean_square(reference, candidate, "impact", span)) / hardest(theirs).peak_force;
  if (theirs.peak_lateral_force > 0)
    result.nrmse_lateral_force =
        std::sqrt(mean_square(reference, candidate, "force", span)) / theirs.peak_lateral_force;
  return result;
}

nlohmann::json to_json(const Comparison &c) {
  const auto value = [](const std::optional<double> &v) { return v ? nlohmann::json(*v) : nlohmann::json(nullptr); };
  return {{"peak_force_error", value(c.peak_force_error)},
          {"peak_displacement_error", value(c.peak_displacement_error)},
          {"approach_speed_error", value(c.approach_speed_error)},
          {"rebound_error", value(c.rebound_error)},
          {"restitution_error", value(c.restitution_error)},
          {"nrmse_displacement", value(c.nrmse_displacement)},
          {"nrmse_force", value(c.nrmse_force)},
          {"nrmse_lateral_force", value(c.nrmse_lateral_force)},
          {"touch_time_difference_s", value(c.touch_time_difference)},
          {"notes", c.notes}};
}

} // namespace rimpact::calibration
