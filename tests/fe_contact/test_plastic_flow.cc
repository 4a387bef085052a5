// The flow of a step, implicit in hardening and rate: it balances the stress as the laws are written, and its change
// with the trial stress is that of differences.
#include "fe_contact/laws/plastic_flow.h"

#include "steels.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

using scene::RateModel;

const RateLaw static_steel{}, mild_steel{{.model = RateModel::cowper_symonds}},
    steel_1006{{.model = RateModel::johnson_cook}};
constexpr double three_mu = 231e9;

FlowStep flow_step(double excess, double dt, double alpha = 0.003) {
  return {.excess = excess, .alpha = alpha, .elastic = three_mu, .dt = dt};
}

/// The flow without a law of the rate, by halving.
double halved_flow(const Hardening &curve, const FlowStep &step) {
  double low = 0, high = step.excess / step.elastic;
  for (int k = 0; k < 200; ++k) {
    const double middle = (low + high) / 2;
    const double left =
        step.excess - step.elastic * middle - curve.stress(step.alpha + middle) + curve.stress(step.alpha);
    (left > 0 ? low : high) = middle;
  }
  return high;
}

TEST(PlasticFlow, BalancesTheStressAtEveryRate) {
  for (const auto &[name, material] : test::steels())
    for (const RateLaw &law : {static_steel, mild_steel, steel_1006})
      for (const double alpha : {0.0, 0.003, 0.019999, 0.3})
        for (const double excess : {1.0, 1e5, 1e8, 1e10})
          for (const double dt : {1e-9, 1e-6, 1e-4, 1.0, 1e4}) {
            const Hardening curve(material);
            const FlowStep step = flow_step(excess, dt, alpha);
            const StepFlow flow = flow_of(curve, law, step);
            const double w = law.none() ? 0 : law.overstress(flow.flow / dt); // by the law as it is written
            const double trial = curve.stress(alpha) + excess, left = trial - three_mu * flow.flow;
            EXPECT_NEAR(left / (curve.stress(alpha + flow.flow) * (1 + w)), 1, 1e-12)
                << name << ' ' << excess << ' ' << dt;
            EXPECT_NEAR(flow.overstress, w, 1e-10) << name << ' ' << excess << ' ' << dt;
            const double rounding = 1e-15 * trial / three_mu;
            EXPECT_LE(flow.flow, halved_flow(curve, step) * (1 + 1e-12) + rounding) << name;
          }
}

TEST(PlasticFlow, ChangeWithTheTrialStressAgreesWithDifferences) {
  for (const auto &[name, material] : test::steels())
    for (const RateLaw &law : {static_steel, mild_steel, steel_1006})
      for (const double excess : {1e6, 1e8, 1e10})
        for (const double dt : {1e-8, 1e-4, 1e4}) {
          const Hardening curve(material);
          const double h = 1e-5 * excess;
          const auto at = [&](double e) { return flow_of(curve, law, flow_step(e, dt)); };
          const double difference = (at(excess + h).flow - at(excess - h).flow) / (2 * h);
          EXPECT_NEAR(at(excess).by_trial / difference, 1, 1e-5) << name << ' ' << excess << ' ' << dt;
        }
}

TEST(PlasticFlow, SteelThatTakesNoNoticeIsStatic) {
  for (const auto &[name, material] : test::steels()) {
    const Hardening curve(material);
    RateLaw hardly = mild_steel, slow = steel_1006;
    hardly.data.D = 1e90, slow.data.reference = 1e6;
    const FlowStep step = flow_step(2e8, 1e-4);
    const double flow = halved_flow(curve, step);
    EXPECT_NEAR(flow_of(curve, static_steel, step).flow / flow, 1, 1e-12) << name;
    EXPECT_NEAR(flow_of(curve, hardly, step).flow / flow, 1, 1e-12) << name;
    EXPECT_NEAR(flow_of(curve, hardly, step).by_trial * (three_mu + curve.slope(step.alpha + flow)), 1, 1e-12) << name;
    EXPECT_NEAR(flow_of(curve, slow, step).flow / flow, 1, 1e-12) << name; // its reference is not passed
    EXPECT_EQ(flow_of(curve, slow, step).overstress, 0) << name;
    slow.data.reference = 1.0, slow.data.C = 1e-14;
    EXPECT_NEAR(flow_of(curve, slow, step).flow / flow, 1, 1e-10) << name;
  }
}

} // namespace
} // namespace rimpact::fe
