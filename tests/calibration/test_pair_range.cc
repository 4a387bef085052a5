#include "calibration/laws/pair_range.h"
#include "measured_synthetic.h"
#include "reduced_models/simulate.h"
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

std::optional<PairRange> range_of(const std::vector<StoredRun> &runs, const std::string &law = "signed",
                                  const FitOptions &options = {}) {
  std::vector<const StoredRun *> all;
  for (const auto &run : runs) all.push_back(&run);
  return pair_range(all, options, law);
}

TEST(PairRange, IsWhereOnePairMadeTheRuns) {
  const std::vector<StoredRun> runs = {run_of(window(0.8, 6e8)), run_of(window(0.1)), run_of(window(0.4)),
                                       run_of(window(0.2))};
  const auto range = range_of(runs);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->from, 0.1, 1e-9);
  EXPECT_NEAR(range->to, 0.4, 1e-9);
  EXPECT_NEAR(range->result.parameters.at("k_i").value / 3e5, 1, 1e-5);
  EXPECT_EQ(range->left_out.size(), 3u);
  ASSERT_EQ(range->outside.size(), 1u);
  EXPECT_NEAR(range->outside[0].peak_force, std::sqrt(0.5) - 1, 1e-3); // the peak goes with sqrt(k)
  EXPECT_NEAR(range->outside[0].rebound, 0, 1e-3);
  EXPECT_NE(range->sentence.find("Beyond, at 0.8 m/s it understates the peak force by 30 %"), // 29.3 %, rounded up
            std::string::npos)
      << range->sentence;
  EXPECT_NE(range->sentence.find("For a supported mass of 86952 kg and impacts from 0.1 to 0.4 m/s the constant pair "
                                 "k_i = 3e+05 kN/m, e = 0.4000 of law signed"),
            std::string::npos)
      << range->sentence;
}

TEST(PairRange, IsByDefaultOfALawThatCannotPull) {
  std::vector<StoredRun> runs;
  for (const double v : {0.1, 0.2, 0.4}) {
    auto truth = window(v);
    truth.reduced.impact_law = &laws::impact_law("no-tension");
    runs.push_back(run_of(truth));
  }
  std::vector<const StoredRun *> all;
  for (const auto &run : runs) all.push_back(&run);
  const auto range = pair_range(all, {});
  ASSERT_TRUE(range);
  EXPECT_EQ(range->law, "no-tension");
  EXPECT_NEAR(range->result.parameters.at("e").value, 0.4, 1e-4);
  EXPECT_LT(range->worst_rebound, 1e-3);
}

// the answer's fit counts by sample where the law follows the records within their noise; the pair is still one of
// peaks and rebounds
TEST(PairRange, IsFoundInMeasuredRecordsToo) {
  FitOptions by_sample;
  by_sample.counting = SampleWeighting::sample;
  for (const double noise : {0.0, 1e-4, 1e-2}) {
    std::vector<StoredRun> runs;
    for (const double v : {0.15, 0.3, 0.6}) {
      auto truth = window(v);
      truth.reduced.impact_law = &laws::impact_law("no-tension");
      runs.push_back(measured(truth, {.rate = 2000, .displacement = 5e-4 * noise, .force = noise}, 3));
    }
    const auto range = range_of(runs, "no-tension", by_sample);
    ASSERT_TRUE(range) << noise;
    EXPECT_NEAR(range->result.parameters.at("k_i").value / 3e5, 1, 0.01) << noise;
    EXPECT_NEAR(range->result.parameters.at("e").value, 0.4, 0.01) << noise;
  }
}

TEST(PairRange, IsEmptyWhereNoPairServesThreeSpeeds) {
  std::vector<StoredRun> runs;
  for (const double v : {0.1, 0.2, 0.4, 0.8}) runs.push_back(run_of(window(v, 3e8 * std::pow(v, -0.8))));
  EXPECT_FALSE(range_of(runs));
}

TEST(PairRange, DoesNotAskGrazingImpacts) {
  auto graze = ricker(1.0);
  graze.excitation.scale = reduced::critical_scale(graze).value() * 1.0005;
  const auto range = range_of({run_of(graze), run_of(window(0.1)), run_of(window(0.2)), run_of(window(0.4))});
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->from, 0.1, 1e-9);
}

} // namespace
} // namespace rimpact::calibration
