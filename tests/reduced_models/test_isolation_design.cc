#include "io/files/error.h"
#include "reduced_models/isolation_design.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace rimpact::reduced {
namespace {

IsolationDesignInput pendulum(double period, double displacement, double gamma, double structure) {
  IsolationDesignInput in;
  in.radius = in.gravity * std::pow(period / (2 * M_PI), 2);
  in.displacement = displacement, in.mass_ratio = gamma, in.superstructure_period = structure;
  return in;
}

/// Tables 2-3 and 4-1 of the thesis: yield displacements [cm] of structures on isolators of 3 s and 5 s.
TEST(IsolationDesign, GivesTheYieldDisplacementsOfTheThesis) {
  struct Row {
    double period, capacity, structure, at_0_7, at_0_9;
  };
  for (const Row &row : {Row{3, 0.41, 0.3, 0.46, 0.53},
                         {3, 0.41, 0.6, 1.86, 2.13},
                         {3, 0.41, 0.9, 4.18, 4.79},
                         {5, 0.54, 0.3, 0.31, 0.34},
                         {5, 0.54, 0.6, 1.27, 1.37},
                         {5, 0.54, 0.9, 2.84, 3.06}})
    for (const auto &[gamma, printed] : {std::pair{0.7, row.at_0_7}, {0.9, row.at_0_9}}) {
      const double u_y =
          100 * *design_isolation(pendulum(row.period, row.capacity, gamma, row.structure)).yield_displacement;
      EXPECT_LT(std::abs(u_y - printed), std::max(0.0075 * printed, 0.0065))
          << row.period << " " << row.structure << " " << gamma << ": " << u_y;
    }
}

/// 2.5.1: R = 2.25 m, mu = 0.07, S_1 = 0.62 g on site class C (F_v = 1.4); four equal floors, one of them the base.
TEST(IsolationDesign, GivesTheFrameOfTheThesis) {
  IsolationDesignInput in;
  in.displacement = 0.35, in.mass_ratio = 0.75, in.reduction = 9.0 / 8;
  const auto d = design_isolation(in);
  EXPECT_NEAR(d.effective_period, 2.49, 0.01);
  EXPECT_NEAR(d.damping, 0.20, 0.005);
  EXPECT_NEAR(d.base_shear, 0.23, 0.005);
  EXPECT_NEAR(d.design_shear, 0.17, 0.005);
  EXPECT_NEAR(d.total_displacement, 0.40, 0.005);
  in.displacement.reset(), in.spectral_acceleration = 1.4 * 0.62;
  // The printed 0.35 m is no fixed point: from it one pass gives 0.361 m, the equation's solution is 0.370 m, 5.6 %
  // above what is printed.
  EXPECT_NEAR(9.81 * 1.4 * 0.62 * d.effective_period / (4 * M_PI * M_PI * damping_coefficient_of(d.damping)), 0.35,
              0.035 * 0.35);
  EXPECT_NEAR(design_isolation(in).displacement, 0.35, 0.06 * 0.35);
}

TEST(IsolationDesign, TheDisplacementMeetsItsEquation) {
  IsolationDesignInput in;
  for (const double friction : {0.0, 0.03, 0.07, 0.12}) {
    in.friction = friction, in.displacement.reset(), in.spectral_acceleration = 0.9;
    const auto d = design_isolation(in);
    EXPECT_NEAR(d.displacement, 9.81 * 0.9 * d.effective_period / (4 * M_PI * M_PI * damping_coefficient_of(d.damping)),
                1e-9)
        << friction;
  }
  in.friction = 0; // a pendulum alone: T = 2 pi sqrt(R/g), B = 0.8 below 2 % of damping
  EXPECT_NEAR(design_isolation(in).displacement,
              9.81 * 0.9 * 2 * M_PI * std::sqrt(2.25 / 9.81) / (4 * M_PI * M_PI * 0.8), 1e-9);
}

TEST(IsolationDesign, TheCoefficientOfDampingIsLinearBetweenRows) {
  EXPECT_DOUBLE_EQ(damping_coefficient_of(0.01), 0.8);
  EXPECT_DOUBLE_EQ(damping_coefficient_of(0.05), 1.0);
  EXPECT_DOUBLE_EQ(damping_coefficient_of(0.15), 1.35);
  EXPECT_DOUBLE_EQ(damping_coefficient_of(0.60), 2.0);
}

TEST(IsolationDesign, RefusesWhatHasNoAnswer) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  IsolationDesignInput in;
  EXPECT_THROW(design_isolation(in), InputError); // neither displacement nor spectrum
  in.displacement = 0.3, in.spectral_acceleration = 0.9;
  EXPECT_THROW(design_isolation(in), InputError);
  in.spectral_acceleration.reset();
  for (const double bad : {0.0, -1.0, nan, 3.0}) {
    in.displacement = bad;
    EXPECT_THROW(design_isolation(in), InputError) << bad;
  }
  in.displacement.reset(), in.spectral_acceleration = 0.001; // held by its friction
  EXPECT_THROW(design_isolation(in), InputError);
  in.spectral_acceleration = 9; // beyond the dish
  EXPECT_THROW(design_isolation(in), InputError);
}

TEST(IsolationDesign, SaysWhereTheProcedureEnds) {
  EXPECT_TRUE(design_isolation(pendulum(3, 0.41, 0.7, 0.3)).remarks.empty());
  EXPECT_EQ(design_isolation(pendulum(3, 0.05, 0.7, 0.9)).remarks.size(), 4u); // damping, T_s, restoring force, shear
  auto light = pendulum(3, 0.41, 0.7, 0.3);
  light.reduction = 6; // more than R_I may be, and a shear below what sets the bearings sliding
  const auto remarks = design_isolation(light).remarks;
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_NE(remarks[0].find("R_I = 6 exceeds 2"), std::string::npos) << remarks[0];
  EXPECT_NE(remarks[1].find("below 1.5 mu W"), std::string::npos) << remarks[1];
}

} // namespace
} // namespace rimpact::reduced
