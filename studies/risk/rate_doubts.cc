#include "studies/risk/rate_doubts.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

/// Whether counts fall from one level to a higher one by more than chance.
bool falls(const LimitResult &limit) {
  for (std::size_t i = 0; i < limit.counted.size(); ++i)
    for (std::size_t j = i + 1; j < limit.counted.size(); ++j)
      if (limit.fragility[i].value > limit.checks[j].high && limit.fragility[j].value < limit.checks[i].low)
        return true;
  return false;
}

/// Share of the larger of two rates by which they differ.
double difference(double a, double b) {
  const double larger = std::max(a, b);
  return larger > 0 ? std::abs(a - b) / larger : 0;
}

} // namespace

void RateDoubts::add(std::size_t system, const std::string &quantity, const LimitResult &limit, double tail) {
  const auto &range = limit.range;
  const double rate = limit.rate.value, most = std::max(rate, range.most.value_or(rate)), bound = settled_share * rate;
  const auto say = [&](Cause cause, double share) { add(cause, system, quantity, limit.limit, share); };
  if (range.above > bound) say(Cause::above, range.above / (range.least + range.above));
  const double beyond = rate > 0 ? (limit.above + limit.below) / rate : 0;
  constexpr double unlikely = 0.05;
  if (limit.across && limit.test_across < unlikely && beyond > settled_share) say(Cause::across, beyond);
  if (!range.below || *range.below > bound) say(Cause::below, range.below ? *range.below / most : 1);
  if (range.between > bound) say(Cause::between, range.between / most);
  if (const double change = difference(limit.rate_checked, limit.rate_fitted); change > settled_share)
    say(Cause::refused, change);
  if (falls(limit)) say(Cause::falls, 0);
  if (tail > 0.5) say(Cause::tail, tail);
}

void RateDoubts::add(Cause cause, std::size_t system, const std::string &quantity, double limit, double share) {
  Where &where = causes_[{quantity, cause}];
  if (where.n == 0) where = {.first_system = system, .least_limit = limit, .largest_limit = limit};
  ++where.n;
  where.least_limit = std::min(where.least_limit, limit), where.largest_limit = std::max(where.largest_limit, limit);
  where.worst = std::max(where.worst, share);
}

std::string RateDoubts::sentence(Cause cause, double worst, const std::vector<double> &levels_g) {
  const double share = 100 * worst;
  switch (cause) {
  case Cause::above:
    return fmt::format("the levels do not reach. Above the last, {:.4g} g, could lie up to {:.0f} % of the rate: its "
                       "probability is a range (probability_range_low and _high)",
                       levels_g.back(), share);
  case Cause::below:
    return fmt::format("the levels begin too high. Below the first, {:.4g} g, could lie up to {:.0f} % of the rate: "
                       "its probability is a range (probability_range_low and _high)",
                       levels_g.front(), share);
  case Cause::across:
    return fmt::format(
        "the curve across levels misses them by more than chance, and up to {:.0f} % of the rate rests on "
        "it beyond them (reliability.csv, curve_test)",
        share);
  case Cause::between:
    return fmt::format(
        "up to {:.0f} % of the rate is open between levels, which are far apart or have few records; its "
        "probability is a range (probability_range_low and _high)",
        share);
  case Cause::refused:
    return fmt::format(
        "the runs refuse the lognormal at some levels (fragility.csv: counted, fitted, and by source what "
        "stands). By the fits alone the rate differs by up to {:.0f} % from that with the counted share "
        "there",
        share);
  case Cause::falls:
    return "the fragility falls with intensity by more than chance: motions of a higher level are milder, or the limit "
           "is not one that grows";
  case Cause::tail:
    return fmt::format(
        "up to {:.0f} % of the rate is from levels at which no run exceeds the limit: from a lognormal's "
        "tail, which no run bears out",
        share);
  }
  return {};
}

std::vector<std::string> RateDoubts::sentences(const std::vector<double> &levels_g) const {
  std::vector<std::string> found;
  for (const auto &[key, where] : causes_) {
    const auto &[quantity, cause] = key;
    const std::string limits = where.least_limit == where.largest_limit
                                   ? fmt::format("{:g}", where.least_limit)
                                   : fmt::format("{:g} to {:g}", where.least_limit, where.largest_limit),
                      results = where.n == 1 ? fmt::format("system {}", where.first_system + 1)
                                             : fmt::format("{} results, the first of system {}", where.n,
                                                           where.first_system + 1);
    found.push_back(fmt::format("{} > {} ({}): {}", quantity, limits, results, sentence(cause, where.worst, levels_g)));
  }
  return found;
}

} // namespace rimpact::risk
