// Fragilities and rates of a made-up bearing whose rim stops it, and whose truth is known.
#include "made_up.h"
#include "studies/reliability/failure_rate.h"
#include "studies/reliability/normal.h"
#include "studies/risk/evaluate.h"
#include "studies/risk/study_reader.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

using namespace rimpact;
using namespace rimpact::risk;

namespace {

constexpr double stop = 0.4, scatter = 0.4, own_scatter = 0.2;
const std::vector<double> levels{0.05, 0.1, 0.15, 0.2, 0.3, 0.4};

/// Travel wanted at an intensity [m]: lognormal of median stop x / 0.3 and deviation `scatter`. Beyond the stop the rim
/// yields by 2 mm (wanted / stop)^3 e^(own_scatter z).
ResponseSet runs(int n_records, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> z;
  ResponseSet set;
  for (int r = 0; r < n_records; ++r) set.records.push_back(fmt::format("R{}", r));
  std::vector<double> own(set.records.size());
  for (double &each : own) each = z(random);
  for (const double x : levels) {
    ResponseLevel level{.intensity_g = x, .n_records = n_records, .runs = {}, .unfinished = {}};
    for (int r = 0; r < n_records; ++r) {
      const double wanted = stop * x / 0.3 * std::exp(scatter * z(random)), pressed = own_scatter * z(random);
      const bool hit = wanted >= stop;
      const double travel = hit ? stop + 0.002 * std::pow(wanted / stop, 3) * std::exp(pressed) : wanted;
      level.runs.push_back({r, false, {travel}, {}, hit});
    }
    set.levels.push_back(level);
  }
  return set;
}

/// P(travel > limit) at an intensity.
double truth(double limit, double x) {
  const double median = std::log(x / 0.3); // of ln(wanted / stop)
  if (limit <= stop) return reliability::normal_probability((median - std::log(limit / stop)) / scatter);
  double sum = 0; // over the share of the rim's own scatter
  constexpr int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double z = -8 + 16 * (i + 0.5) / n, density = std::exp(-z * z / 2) / std::sqrt(2 * std::acos(-1.0));
    const double needed = std::max(0.0, (std::log((limit - stop) / 0.002) - own_scatter * z) / 3);
    sum += 16.0 / n * density * reliability::normal_probability((median - needed) / scatter);
  }
  return sum;
}

Study study_with_a_stop(const std::string &values) {
  std::string text = made_up::head;
  text.replace(text.find("[0.1, 0.2, 0.39]"), 16, values);
  text.replace(text.find("levels_g = [0.1, 0.3]"), 21, "levels_g = [0.05, 0.1, 0.15, 0.2, 0.3, 0.4]");
  text.replace(text.find("replicates = 60"), 15, "replicates = 300");
  return parse_study(text, "s.toml");
}

double true_rate(const Study &study, double limit) {
  std::vector<double> edges;
  for (double x = 0.01; x < 20; x *= 1.5) edges.push_back(x);
  const auto fragility = [&](double x) { return truth(limit, x); };
  return reliability::failure_rate(reliability::HazardCurve(study.hazard), fragility, edges).rate;
}

} // namespace

TEST(HitsApart, ATrueFragilityWithAStopIsRecoveredWithinItsBand) {
  const Study study = study_with_a_stop("[0.2, 0.35, 0.401, 0.404]");
  std::size_t n = 0, n_within = 0;
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    const auto set = runs(60, seed);
    for (const auto &limit : evaluate(study, set, SystemSample(study, set))) {
      const double exact = true_rate(study, limit.limit);
      SCOPED_TRACE(fmt::format("seed {} limit {}: {:.3e}, true {:.3e}", seed, limit.limit, limit.rate.value, exact));
      ++n, n_within += limit.rate.low <= exact && exact <= limit.rate.high;
      EXPECT_NEAR(std::log(limit.rate.value / exact), 0, 0.5);
      for (std::size_t i = 0; i < levels.size(); ++i)
        EXPECT_NEAR(limit.fragility[i].value, truth(limit.limit, levels[i]), 0.17) << levels[i];
      EXPECT_NEAR(std::accumulate(limit.of_levels.begin(), limit.of_levels.end(), 0.0) / limit.rate.value, 1, 1e-12);
    }
  }
  EXPECT_GE(n_within, n - n / 5) << "of bands that hold nine of ten";
}

// The thesis's rule lets the lognormal run through the stop and holds P flat above the last level.
TEST(HitsApart, TheThesissRuleStays) {
  Study study = study_with_a_stop("[0.35, 0.45]");
  const auto set = runs(60, 1);
  const auto apart = evaluate(study, set, SystemSample(study, set));
  study.fragility = FragilityRule::thesis;
  const SystemSample sample(study, set);
  const auto thesis = evaluate(study, set, sample);
  EXPECT_GT(thesis[1].rate_fitted, 1.1 * thesis[1].rate_checked);
  EXPECT_NEAR(apart[1].fitted.back(), truth(0.45, levels.back()), 0.03);
  EXPECT_GT(thesis[1].fitted.back(), truth(0.45, levels.back()) + 0.1) << "runs through the stop";
  for (const auto &limit : thesis) {
    EXPECT_FALSE(limit.across);
    EXPECT_DOUBLE_EQ(limit.rate.value, limit.rate_flat);
    EXPECT_DOUBLE_EQ(limit.rate.value, limit.rate_fitted) << "counts do not replace it, they are said";
    std::vector<double> p;
    for (const auto &level : limit.fragility) p.push_back(level.value);
    EXPECT_DOUBLE_EQ(limit.rate.value, sample.weights().rate(p));
  }
}

TEST(HitsApart, RecordsTwiceOrInAnotherOrderMoveNoRate) {
  const Study study = study_with_a_stop("[0.1, 0.35, 0.4022, 0.404]");
  const auto set = runs(30, 7);
  auto twice = set, turned = set;
  for (int r = 0; r < 30; ++r) twice.records.push_back(fmt::format("again {}", r));
  for (auto &level : twice.levels) { // what `collect` counts as trials: records of different responses
    const auto once = level.runs;
    for (auto run : once) run.record += 30, level.runs.push_back(run);
  }
  std::mt19937 random(1);
  for (auto &level : turned.levels) {
    std::shuffle(level.runs.begin(), level.runs.end(), random);
    for (auto &run : level.runs) run.record = 29 - run.record;
  }
  const auto rates = evaluate(study, set, SystemSample(study, set));
  for (const auto &other : {twice, turned}) {
    const auto same = evaluate(study, other, SystemSample(study, other));
    for (std::size_t i = 0; i < rates.size(); ++i) {
      ASSERT_GT(rates[i].rate.value, 0);
      EXPECT_NEAR(same[i].rate.value / rates[i].rate.value, 1, 1e-12) << rates[i].limit;
    }
  }
}
