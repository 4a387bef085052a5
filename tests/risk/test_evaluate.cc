// Fragility, rate and disaggregation of responses made up here.
#include "../scene/expect_error.h"
#include "made_up.h"
#include "studies/reliability/failure_rate.h"
#include "studies/risk/disaggregation.h"
#include "studies/risk/rate_doubts.h"
#include "studies/risk/study_reader.h"
#include <numeric>
#include <random>

using namespace rimpact;
using namespace rimpact::risk;

namespace {

Study study_of(const std::string &values = "[0.1, 0.2, 0.39]") {
  std::string text = made_up::head;
  text.replace(text.find("[0.1, 0.2, 0.39]"), 16, values);
  return parse_study(text, "s.toml");
}

/// Two levels, `n_records` records of `n` runs: lognormal of median level, ln y = ln x + 0.3 z - 0.5 ln(mu / 0.05).
ResponseSet responses(int n_records = 12, int n = 15) {
  std::mt19937 random(3);
  std::normal_distribution<double> z;
  std::uniform_real_distribution<double> mu(0.03, 0.07);
  ResponseSet set;
  set.inputs = {"reduced.mu_fast"};
  for (int r = 0; r < n_records; ++r) set.records.push_back(fmt::format("R{}", r));
  for (const double x : {0.1, 0.3}) {
    ResponseLevel level{.intensity_g = x, .n_records = n_records, .runs = {}, .unfinished = {}};
    for (int r = 0; r < n_records; ++r) {
      const double own = 0.3 * z(random);
      for (int i = 0; i < n; ++i) {
        const double friction = mu(random);
        level.runs.push_back({r, false, {x * std::exp(own - 0.5 * std::log(friction / 0.05))}, {friction}});
      }
    }
    set.levels.push_back(level);
  }
  return set;
}

} // namespace

TEST(Evaluate, RateIsTheConvolutionOfTheFittedFragility) {
  Study study = study_of();
  study.fragility = FragilityRule::thesis;
  const auto set = responses();
  const SystemSample sample(study, set);
  const auto limits = evaluate(study, set, sample);
  ASSERT_EQ(limits.size(), 3u);
  const reliability::HazardCurve hazard(study.hazard);
  for (const auto &limit : limits) {
    const double foot = 0.1 * 0.1 / 0.3;
    const auto fragility =
        reliability::interpolated({{foot, 0}, {0.1, limit.fragility[0].value}, {0.3, limit.fragility[1].value}});
    const auto exact = reliability::failure_rate(hazard, fragility, {foot, 0.1, 0.3});
    EXPECT_NEAR(limit.rate.value / exact.rate, 1, 1e-9);
    EXPECT_NEAR(limit.probability.value, reliability::probability_in(50, exact.rate), 1e-12);
    EXPECT_LE(limit.rate.low, limit.rate.value);
    EXPECT_GE(limit.rate.high, limit.rate.value);
    EXPECT_GE(limit.probability_most, limit.probability.value);
    EXPECT_NEAR(limit.above, limit.fragility[1].value * hazard.rate(0.3), 1e-15);
  }
}

TEST(Evaluate, CollapsesCountAsTotalProbabilitySays) {
  const Study study = study_of("[0.2]");
  auto set = responses();
  for (std::size_t i = 0; i < 45; ++i) set.levels[1].runs[i].beyond = true; // three records of twelve
  const auto limit = evaluate(study, set, SystemSample(study, set)).front();
  EXPECT_GE(limit.fragility[1].value, 0.25);
  EXPECT_GE(limit.counted[1], 0.25);
  for (auto &level : set.levels)
    for (auto &run : level.runs) run.beyond = true;
  const auto all = evaluate(study, set, SystemSample(study, set)).front();
  EXPECT_EQ(all.fragility[0].value, 1);
  EXPECT_EQ(all.fragility[1].low, 1);
}

// 180 runs a level. Of the 20 that stop in the upper one, 8 had passed the limit by then.
TEST(Evaluate, RunsThatStopCountForWhatTheyReachedAndBoundTheRest) {
  const Study study = study_of("[0.2]");
  auto set = responses();
  const auto before = evaluate(study, set, SystemSample(study, set)).front();
  for (int i = 0; i < 20; ++i) set.levels[1].unfinished.push_back({i % 12, false, {i < 8 ? 0.21 : 0.19}, {0.05}});
  set.levels[1].unfinished.back().values[0] = std::nan(""); // refused: nothing is known
  const auto after = evaluate(study, set, SystemSample(study, set)).front();
  const double finished = 180 * before.fragility[1].value;
  EXPECT_EQ(after.n_unknown, 12);
  EXPECT_NEAR(after.fragility[1].value, (finished + 8) / 188, 1e-12);
  EXPECT_NEAR(after.bounds[1].least, (finished + 8) / 200, 1e-12);
  EXPECT_NEAR(after.bounds[1].most, (finished + 20) / 200, 1e-12);
  EXPECT_EQ(after.bounds[0].least, after.bounds[0].most);
  EXPECT_LT(after.if_none, after.probability.value);
  EXPECT_GT(after.if_all, after.probability.value);
  EXPECT_NEAR(before.if_none, before.probability.value, 1e-15);
}

TEST(Evaluate, OneRunALevelIsAStepAndALimitNeverReachedIsNever) {
  const Study study = study_of("[0.2, 100.0]");
  const auto set = responses(1, 1);
  const auto limits = evaluate(study, set, SystemSample(study, set));
  EXPECT_EQ(limits[0].fragility[0].value, 0);
  EXPECT_EQ(limits[1].rate.value, 0);
  const auto why = disaggregate(set, SystemSample(study, set), limits[1]);
  EXPECT_EQ(std::accumulate(why.levels.begin(), why.levels.end(), 0.0), 0);
}

namespace {

/// A rim stops every run at 0.21 m: the pressed ones lie within a millimetre of it.
ResponseSet stopped(ResponseSet set) {
  int n = 0;
  for (auto &level : set.levels)
    for (auto &run : level.runs)
      if (double &value = run.values[0]; value > 0.21) value = 0.21 + 1e-5 * (++n % 100);
  return set;
}

} // namespace

// The lognormals run through the rim, where no run goes: they are refused, and the counts and their interval stand.
TEST(Evaluate, WhereTheRunsRefuseTheLognormalTheCountedShareStands) {
  const Study study = study_of("[0.2, 0.22]");
  const auto set = stopped(responses(60, 1));
  const SystemSample sample(study, set);
  const auto limits = evaluate(study, set, sample);
  const auto &beyond = limits[1];
  EXPECT_GT(beyond.fitted[1], 0.05) << "the tail";
  EXPECT_EQ(beyond.counted[1], 0);
  EXPECT_TRUE(beyond.checks[1].refused);
  EXPECT_EQ(beyond.fragility[1].value, 0);
  EXPECT_NEAR(beyond.fragility[1].high, 1 - std::pow(0.025, 1 / 60.0), 1e-9) << "none of sixty";
  EXPECT_GT(beyond.rate_fitted, 0);
  EXPECT_EQ(beyond.rate.value, 0);
  EXPECT_FALSE(is_settled(beyond));
  EXPECT_EQ(beyond.range.least, 0);
  EXPECT_GT(*beyond.range.most, beyond.rate_fitted);
  for (const auto &limit : limits)
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(limit.fragility[i].value, limit.is_counted[i] ? limit.counted[i] : limit.fitted[i]);
  RateDoubts doubts;
  doubts.add(0, "peak_displacement_m", beyond, 0);
  std::string said;
  for (const auto &sentence : doubts.sentences({0.1, 0.3})) said += sentence + "\n";
  EXPECT_NE(said.find("peak_displacement_m > 0.22 (system 1): the runs refuse the lognormal"), std::string::npos)
      << said;
  EXPECT_NE(said.find("the levels do not reach"), std::string::npos) << said;
}

TEST(Evaluate, ARateThatItsLevelsDoNotSettleIsARangeAndADoubt) {
  const Study study = study_of("[0.15, 0.6]");
  const auto set = responses(60, 5);
  const auto limits = evaluate(study, set, SystemSample(study, set));
  for (const auto &limit : limits) {
    EXPECT_LE(limit.probability_least, limit.probability.value);
    EXPECT_GE(limit.probability_range_most, limit.probability_most * (1 - 1e-12));
  }
  EXPECT_FALSE(is_settled(limits[1])) << "1 % exceed at the last level";
  EXPECT_GT(limits[1].range.above, limits[1].rate.value);
  RateDoubts doubts;
  for (const auto &limit : limits) doubts.add(4, "peak_displacement_m", limit, limit.limit > 0.5 ? 0.9 : 0);
  std::string said;
  for (const auto &sentence : doubts.sentences({0.1, 0.3})) said += sentence + "\n";
  EXPECT_NE(said.find("Above the last, 0.3 g"), std::string::npos) << said;
  EXPECT_NE(said.find("> 0.6 (system 5): up to 90 % of the rate is from levels at which no run"), std::string::npos)
      << said;
}

TEST(Evaluate, TheSameSystemReducesNothing) {
  const Study study = study_of();
  const auto set = responses();
  const SystemSample sample(study, set);
  for (const auto &reduction : reductions(study, sample, sample)) {
    EXPECT_EQ(reduction.value, 0);
    EXPECT_EQ(reduction.low, 0);
    EXPECT_EQ(reduction.high, 0); // drawn alike
  }
}

TEST(Disaggregation, SharesAddUpAndElasticityIsTheDerivative) {
  const Study study = study_of();
  const auto set = responses();
  const SystemSample sample(study, set);
  const auto limits = evaluate(study, set, sample);
  // Every friction one per cent larger: by the law made up above every response is 0.5 ln(1.01) lower in the logarithm.
  auto shifted = set;
  for (auto &level : shifted.levels)
    for (auto &run : level.runs) run.values[0] *= std::pow(1.01, -0.5);
  const auto after = evaluate(study, shifted, SystemSample(study, shifted));
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto why = disaggregate(set, sample, limits[i]);
    EXPECT_NEAR(std::accumulate(why.levels.begin(), why.levels.end(), 0.0), 1, 1e-12);
    EXPECT_NEAR(std::accumulate(why.records.begin(), why.records.end(), why.tail), 1, 1e-12);
    const double slope = std::log(after[i].rate.value / limits[i].rate.value) / std::log(1.01);
    EXPECT_NEAR(why.elasticities[0], slope, 0.02 * std::abs(slope) + 1e-3);
  }
}
