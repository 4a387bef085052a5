#include "studies/reliability/level.h"
#include "io/files/error.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::reliability {

double LevelDistribution::exceedance(double limit) const {
  if (!(limit > 0)) throw InputError(fmt::format("limit {} is not > 0", limit));
  const double n = n_collapsed + n_zero + n_positive;
  const double beyond = fit ? n_positive * fit->distribution.exceedance(limit) : 0;
  return (n_collapsed + beyond) / n;
}

LevelDistribution level_distribution(const std::vector<double> &responses, int n_collapsed) {
  if (n_collapsed < 0) throw InputError(fmt::format("{} collapses are fewer than 0", n_collapsed));
  if (responses.empty() && n_collapsed == 0) throw InputError("a level of intensity without runs has no fragility");
  std::vector<double> positive;
  for (const double response : responses) {
    if (!std::isfinite(response) || response < 0)
      throw InputError(fmt::format("a response of {} is not finite and >= 0", response));
    if (response > 0) positive.push_back(response);
  }
  LevelDistribution level{.n_collapsed = n_collapsed,
                          .n_zero = static_cast<int>(responses.size() - positive.size()),
                          .n_positive = static_cast<int>(positive.size()),
                          .fit = std::nullopt};
  if (!positive.empty()) level.fit = fit_lognormal(positive);
  return level;
}

} // namespace rimpact::reliability
