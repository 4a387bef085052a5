// The flow stress over the plastic strain rate.
#include "fe_contact/laws/strain_rate.h"

#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

using scene::RateModel;

const RateLaw cowper_symonds{{.model = RateModel::cowper_symonds}}, johnson_cook{{.model = RateModel::johnson_cook}};

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

} // namespace
} // namespace rimpact::fe
