// The flow stress over the plastic strain rate, and the flow of a step that is implicit in it.
#include "fe_contact/laws/strain_rate.h"

#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

using scene::RateModel;

const RateLaw cowper_symonds{{.model = RateModel::cowper_symonds}}, johnson_cook{{.model = RateModel::johnson_cook}};

FlowStep step_of(double excess, double dt) {
  return {.excess = excess, .stress = 360e6, .slope = 1460e6, .elastic = 231e9, .dt = dt};
}

/// The flow where the law of the rate gives no overstress.
double static_flow(const FlowStep &step) {
  return step.excess / (step.elastic + step.slope);
}

TEST(StrainRate, ConstantsHaveTheirMeaning) {
  EXPECT_DOUBLE_EQ(cowper_symonds.overstress(40.0), 1.0); // twice the static flow stress at the rate D
  EXPECT_NEAR(cowper_symonds.overstress(40.0 / 32), 0.5, 1e-15);
  EXPECT_DOUBLE_EQ(cowper_symonds.overstress(0), 0.0);
  EXPECT_NEAR(johnson_cook.overstress(std::exp(1.0)), 0.022, 1e-15); // C for each e-fold beyond the reference
  EXPECT_EQ(johnson_cook.overstress(1.0), 0.0);
  EXPECT_EQ(johnson_cook.overstress(1e-9), 0.0);
}

TEST(StrainRate, RateIsTheInverseWithItsSlope) {
  for (const RateLaw &law : {cowper_symonds, johnson_cook})
    for (const double rate : {1.5, 8.0, 20.0, 1e3}) {
      const double w = law.overstress(rate), h = 1e-6 * w;
      EXPECT_NEAR(law.rate(w).value / rate, 1, 1e-12);
      const double difference = (law.rate(w + h).value - law.rate(w - h).value) / (2 * h);
      EXPECT_NEAR(law.rate(w).slope / difference, 1, 1e-7) << rate;
    }
}

TEST(StrainRate, FlowBalancesTheStressAtEveryRate) {
  for (const RateLaw &law : {cowper_symonds, johnson_cook})
    for (const double excess : {1.0, 1e5, 1e8, 1e10})
      for (const double dt : {1e-9, 1e-6, 1e-4, 1.0, 1e4}) {
        const FlowStep step = step_of(excess, dt);
        const StepFlow flow = flow_of(law, step);
        const double trial = step.stress + excess, flow_stress = step.stress + step.slope * flow.flow,
                     w = law.overstress(flow.flow / dt); // by the law as it is written
        EXPECT_NEAR((trial - step.elastic * flow.flow) / (flow_stress * (1 + w)), 1, 1e-12) << excess << ' ' << dt;
        EXPECT_NEAR(flow.overstress, w, 1e-10) << excess << ' ' << dt;
        EXPECT_LE(flow.flow, static_flow(step));
      }
}

TEST(StrainRate, ChangeWithTheTrialStressAgreesWithDifferences) {
  for (const RateLaw &law : {cowper_symonds, johnson_cook})
    for (const double excess : {1e6, 1e8, 1e10})
      for (const double dt : {1e-8, 1e-4, 1e4}) {
        const double h = 1e-5 * excess;
        const double difference =
            (flow_of(law, step_of(excess + h, dt)).flow - flow_of(law, step_of(excess - h, dt)).flow) / (2 * h);
        EXPECT_NEAR(flow_of(law, step_of(excess, dt)).by_trial / difference, 1, 1e-6) << excess << ' ' << dt;
      }
}

TEST(StrainRate, SteelThatTakesNoNoticeIsStatic) {
  RateLaw hardly = cowper_symonds, slow = johnson_cook;
  hardly.data.D = 1e90, slow.data.reference = 1e6;
  const FlowStep step = step_of(2e8, 1e-4);
  EXPECT_NEAR(flow_of(hardly, step).flow / static_flow(step), 1, 1e-12);
  EXPECT_NEAR(flow_of(hardly, step).by_trial * (step.elastic + step.slope), 1, 1e-12);
  EXPECT_EQ(flow_of(slow, step).flow, static_flow(step)); // its reference is not passed
  EXPECT_EQ(flow_of(slow, step).overstress, 0);
  slow.data.reference = 1.0, slow.data.C = 1e-14;
  EXPECT_NEAR(flow_of(slow, step).flow / static_flow(step), 1, 1e-10);
}

} // namespace
} // namespace rimpact::fe
