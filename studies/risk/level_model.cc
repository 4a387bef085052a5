#include "studies/risk/level_model.h"

namespace rimpact::risk {

double LevelModel::finished_exceedance(double limit) const {
  return apart ? apart->exceedance(limit) : finished.exceedance(limit);
}

LevelModel::Exceedance LevelModel::exceedance(double limit) const {
  const int n = finished.n_collapsed + finished.n_zero + finished.n_positive;
  return exceedance(limit, n * finished_exceedance(limit));
}

LevelModel::Exceedance LevelModel::exceedance(double limit, double n_finished_beyond) const {
  int n_known = finished.n_collapsed + finished.n_zero + finished.n_positive, n_unknown = 0;
  double beyond = n_finished_beyond;
  for (const auto &[reached, times] : unfinished)
    if (reached > limit)
      n_known += times, beyond += times;
    else
      n_unknown += times;
  const double all = n_known + n_unknown;
  return {beyond / n_known, beyond / all, (beyond + n_unknown) / all, n_unknown};
}

} // namespace rimpact::risk
