#include "studies/reliability/hit_level.h"
#include "io/files/error.h"
#include "studies/reliability/censored_lognormal.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::reliability {
namespace {

int runs_of(const LevelDistribution &part) {
  return part.n_zero + part.n_positive;
}

/// Of a part without collapses; 0 where it has no run.
double exceedance_of(const LevelDistribution &part, double limit) {
  return runs_of(part) == 0 ? 0 : part.exceedance(limit);
}

CensoredSums censored(const LevelDistribution &free, double n_beyond) {
  const double n = free.n_positive, mean = free.fit->distribution.mean_ln, sigma = free.fit->distribution.sigma_ln;
  return {n, n * mean, n * (mean * mean + sigma * sigma), n_beyond};
}

} // namespace

double HitLevel::counted_share() const {
  const double all = runs_of(hit) + runs_of(free);
  return all > 0 ? runs_of(hit) / all : 0;
}

double HitLevel::exceedance(double limit) const {
  if (!(limit > 0)) throw InputError(fmt::format("limit {} is not > 0", limit));
  const double n = n_collapsed + runs_of(hit) + runs_of(free), collapsed = n_collapsed / n;
  double of_hit = stop ? 0 : exceedance_of(hit, limit), of_free = exceedance_of(free, limit);
  if (stop) {
    of_hit = limit <= *stop ? 1 : exceedance_of(hit, limit - *stop);
    if (limit >= *stop)
      of_free = 0;
    else if (below_stop) {
      const double beyond = below_stop->exceedance(*stop);
      of_free = beyond < 1 ? std::max(0.0, (below_stop->exceedance(limit) - beyond) / (1 - beyond)) : 1;
    }
  }
  return collapsed + (1 - collapsed) * (hit_share * of_hit + (1 - hit_share) * of_free);
}

std::optional<double> stop_between(double most_free, std::vector<double> hits) {
  if (hits.empty()) return std::nullopt;
  std::sort(hits.begin(), hits.end());
  const double least = hits.front(), largest = hits.back(), median = hits[hits.size() / 2];
  if (!(most_free < least)) return std::nullopt;
  const double curvature = least + largest - 2 * median;
  const double threshold = curvature > 0 ? (least * largest - median * median) / curvature : most_free;
  constexpr double nearest = 1e-3; // of the way from the least hit: its logarithm stays finite
  return std::clamp(threshold, most_free, least - nearest * (least - most_free));
}

HitLevel hit_level(int n_collapsed, const LevelDistribution &hit, const LevelDistribution &free,
                   std::optional<double> stop) {
  HitLevel level;
  level.n_collapsed = n_collapsed, level.hit = hit, level.free = free, level.stop = stop;
  if (n_collapsed + runs_of(hit) + runs_of(free) == 0)
    throw InputError("a level of intensity without runs has no fragility");
  level.hit_share = level.counted_share();
  if (stop && free.fit && free.fit->distribution.sigma_ln > 0)
    level.below_stop = fit_censored(censored(free, runs_of(hit)), *stop);
  return level;
}

} // namespace rimpact::reliability
