#include "calibration/studies/vary_answer.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {
namespace {

constexpr std::size_t strain_output = 3, foot_output = 4;

/// What a rim must not exceed: the targets, and the steel's limit.
std::vector<std::pair<std::size_t, double>> limits_of(const VaryQuestion &question, bool with_steel) {
  std::vector<std::pair<std::size_t, double>> limits;
  for (std::size_t k = 0; k < vary_outputs().size(); ++k)
    if (const auto found = question.targets.find(vary_outputs()[k]); found != question.targets.end())
      limits.emplace_back(k, found->second);
  if (with_steel && question.strain_limit) limits.emplace_back(strain_output, *question.strain_limit);
  if (with_steel) limits.emplace_back(foot_output, 1.0); // known of a joint alone
  return limits;
}

/// Buildable values: a step of 1, 2 or 5 times a power of ten, and some hundred of them.
std::vector<double> round_values(const VariedKey &key) {
  constexpr double wanted = 100;
  const double low = key.values.front(), high = key.values.back(), raw = (high - low) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double digit : {5.0, 2.0, 1.0})
    if (digit * power >= raw) step = digit * power;
  std::vector<double> values = key.values;
  for (double i = std::ceil(low / step); i * step < high; ++i) values.push_back(i * step);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// One rim as it is predicted.
struct Candidate {
  VaryPoint point;
  double force_error;
  bool meets, meets_surely; ///< the limits; so too where they are passed by the errors
};

double worst_excess(const VaryPoint &point, const std::vector<std::pair<std::size_t, double>> &limits, double error) {
  double worst = 0;
  for (const auto &[k, most] : limits) {
    const double value = point.output(k);
    if (std::isnan(value)) continue;
    worst = std::max(worst, value * (k == 0 ? 1 + error : 1) / most);
  }
  return worst;
}

Candidate candidate(const VaryPoint &point, double interpolation, const VaryQuestion &question) {
  const auto limits = limits_of(question, true);
  const double error = std::hypot(CurveAgainstWindows{}.force, interpolation);
  constexpr double most = 1 + 1e-9; // a limit that is met to the last digit is met
  return {point, error, worst_excess(point, limits, 0) <= most, worst_excess(point, limits, error) <= most};
}

VaryPoint between(const std::vector<VaryPoint> &points, double x) {
  constexpr double kilo = 1e3, milli = 1e-3;
  VaryPoint point{};
  point.at = {x};
  point.peak_force = kilo * interpolated(points, 0, x).value, point.depth = milli * interpolated(points, 1, x).value;
  point.rebound = interpolated(points, 2, x).value;
  if (const double strain = interpolated(points, strain_output, x).value; !std::isnan(strain)) point.strain = strain;
  if (const double use = interpolated(points, foot_output, x).value; !std::isnan(use)) point.foot_use = use;
  point.fastest = std::min_element(points.begin(), points.end(), [](const auto &a, const auto &b) {
                    return a.fastest < b.fastest;
                  })->fastest;
  return point;
}

std::vector<Candidate> candidates(const std::vector<VaryPoint> &points, const VaryQuestion &question) {
  std::vector<Candidate> all;
  if (question.keys.size() > 1 || points.size() < 2) {
    for (const auto &point : points) all.push_back(candidate(point, 0, question));
    return all;
  }
  const double low = points.front().at[0], high = points.back().at[0];
  for (const double x : round_values(question.keys[0]))
    if (x >= low && x <= high)
      all.push_back(candidate(between(points, x), interpolated(points, 0, x).error.value_or(0), question));
  return all;
}

std::string limits_in_words(const VaryQuestion &question) {
  std::string text;
  for (const auto &[k, most] : limits_of(question, false))
    text += fmt::format("{}{} at most {:g}", text.empty() ? "" : ", ", vary_outputs()[k], most);
  if (question.strain_limit)
    text += fmt::format("{}the rim's strain at most {:g}", text.empty() ? "" : ", ", *question.strain_limit);
  return text;
}

/// "rim.thickness_mm from 20 to 61.5", or the combinations one by one.
std::string those_that_meet(const std::vector<Candidate> &all, const VaryQuestion &question) {
  std::string text;
  if (question.keys.size() > 1) {
    for (const auto &each : all)
      if (each.meets) text += (text.empty() ? "" : "; ") + in_words(each.point.at, question);
    return text;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].meets) continue;
    std::size_t last = i;
    while (last + 1 < all.size() && all[last + 1].meets) ++last;
    const double from = all[i].point.at[0], to = all[last].point.at[0];
    text += fmt::format("{}{}", text.empty() ? question.keys[0].key + " " : " and ",
                        from == to ? fmt::format("{:g}", from) : fmt::format("from {:g} to {:g}", from, to));
    i = last;
  }
  return text;
}

/// The least strained of those that meet the limits surely, else nominally; else the one nearest to them.
const Candidate &chosen(const std::vector<Candidate> &all, const VaryQuestion &question) {
  const auto limits = limits_of(question, true);
  const auto worse = [&](const Candidate &a, const Candidate &b) {
    if (a.meets_surely != b.meets_surely) return !a.meets_surely;
    if (a.meets != b.meets) return !a.meets;
    if (!a.meets) return worst_excess(a.point, limits, 0) > worst_excess(b.point, limits, 0);
    return a.point.output(strain_output) > b.point.output(strain_output);
  };
  return *std::max_element(all.begin(), all.end(), worse);
}

} // namespace

VaryAnswer vary_answer(const std::vector<VaryPoint> &points, const VaryQuestion &question) {
  VaryAnswer answer;
  if (points.empty()) {
    answer.sentence = "No rim of the range has a result.";
    return answer;
  }
  const auto all = candidates(points, question);
  if (question.keys.size() == 1)
    for (const auto &each : all) answer.between.push_back(each.point);
  const Candidate &best =
      question.targets.empty() ? candidate(points[points.size() / 2], 0, question) : chosen(all, question);
  answer.design = best.point.at, answer.predicted = best.point;
  answer.force_error = best.force_error, answer.reached = best.meets;
  const std::string where = fmt::format("At {:g} m/s under {:.6g} kg", question.speed, question.mass);
  if (!question.targets.empty()) {
    const std::string meeting = those_that_meet(all, question);
    answer.sentence = meeting.empty() ? fmt::format("{}, no rim of the range meets {}; the nearest is {}", where,
                                                    limits_in_words(question), in_words(best.point.at, question))
                                      : fmt::format("{}, {} is met by {}; take {}{}", where, limits_in_words(question),
                                                    meeting, in_words(best.point.at, question),
                                                    best.meets_surely ? "" : ", which meets it by less than the error");
  } else
    answer.sentence = fmt::format("{}, {}", where, in_words(best.point.at, question));
  answer.sentence += fmt::format(
      ": peak force {:.0f} kN (error {:.1f} %{}), {:.2f} mm deep, rebound {:.3f} m/s", best.point.peak_force / 1e3,
      100 * best.force_error,
      points.size() == 2 && question.keys.size() == 1 ? ", and that of interpolation, which two rims do not tell" : "",
      1e3 * best.point.depth, best.point.rebound);
  if (best.point.strain)
    answer.sentence +=
        fmt::format(", strain of the rim {:.3f} ({})", *best.point.strain,
                    question.strain_limit ? fmt::format("limit {:g}", *question.strain_limit) : "no limit is known");
  if (best.point.foot_use)
    answer.sentence += fmt::format(", the joint at the rim's foot used to {:.2f}", *best.point.foot_use);
  answer.sentence += ".";
  return answer;
}

} // namespace rimpact::calibration
