// The unilateral constraint against a gap element of finite stiffness, integrated by fixed steps in x, y, z.
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

namespace {

struct Penalised {
  double peak_displacement = 0, peak_impact = 0, largest_clearance = 0;
};

/// The whole bearing as a mass in space on a stiff, damped normal spring; friction smoothed at 1e-5 m/s.
/// Its error falls as the root of the stiffness: clearance at x 1.2 is 2.36, 2.195, 2.179 mm for 2e10, 2e11,
/// 2e12 N/m, 2.171 mm with the exact constraint.
Penalised penalised(const scene::Scene &s, double t_end) {
  const Ellipse e;
  const double m = s.load.mass, W = s.load.vertical, k = 2e11, c = 2 * std::sqrt(k * m);
  const double xi = 0.135850, ki = s.reduced.k_i, ci = 2 * xi * std::sqrt(ki * m), h = 2e-6;
  using V = Eigen::Matrix<double, 4, 1>; // x, z and rates: the pulse acts along x
  Penalised out;
  double impact = 0;
  const auto f = [&](double t, const V &y) -> V {
    const double x = y[0], slope = e.slope(std::abs(x)) * (x < 0 ? -1 : 1), S = std::sqrt(1 + slope * slope);
    const double depth = (e.height(std::abs(x)) - y[1]) / S, rate = (slope * y[2] - y[3]) / S;
    const double N = depth > 0 ? std::max(0.0, k * depth + c * rate) : 0.0;
    const double v = (y[2] + slope * y[3]) / S, friction = -0.07 * N * v / std::sqrt(v * v + 1e-10);
    const double d = std::abs(x) - 0.4, side = x < 0 ? -1 : 1;
    impact = d > 0 ? ki * d + ci * y[2] * side : 0.0;
    const double ag = s.excitation.scale * 0.78 * 9.81 * scene::ricker_shape(t, 2, 1);
    return {y[2], y[3], -ag + (-N * slope / S + friction / S - side * impact) / m,
            (-W + N / S + friction * slope / S) / m};
  };
  V y(0, -W / k, 0, 0);
  for (double t = 0; t < t_end; t += h) {
    const V k1 = f(t, y);
    out.peak_impact = std::max(out.peak_impact, impact);
    const V k2 = f(t + h / 2, y + h / 2 * k1), k3 = f(t + h / 2, y + h / 2 * k2), k4 = f(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    out.peak_displacement = std::max(out.peak_displacement, std::abs(y[0]));
    out.largest_clearance = std::max(out.largest_clearance, y[1] - e.height(std::abs(y[0])));
  }
  return out;
}

} // namespace

TEST(Uplift, AgreesWithAStiffGapElement) {
  for (const double scale : {1.05, 1.2}) {
    const scene::Scene s = ricker(scale, 2.8);
    const auto run = simulate(s);
    const Penalised other = penalised(s, 2.8);
    EXPECT_NEAR(run.summary.peak_displacement, other.peak_displacement, 5e-6) << scale;
    EXPECT_NEAR(*run.summary.peak_impact_force / other.peak_impact, 1, 1e-3) << scale;
    double clearance = 0;
    const Ellipse e;
    for (std::size_t i = 0; i < run.response.size(); ++i)
      clearance = std::max(clearance, run.response.series("displacement_z")[i] -
                                          e.height(std::abs(run.response.series("displacement_x")[i])));
    EXPECT_NEAR(clearance, std::max(0.0, other.largest_clearance), 2e-6 + 0.015 * clearance) << scale;
    if (scale > 1.1) {
      EXPECT_GT(clearance, 1e-5);
      EXPECT_EQ(*run.summary.min_normal_force, 0);
    } else {
      EXPECT_GT(*run.summary.min_normal_force, 0);
    }
  }
}

TEST(Uplift, NormalForceIsNeverNegativeAndTheMassNeverBelowTheDish) {
  const auto run = simulate(ricker(1.6, 12));
  const Ellipse e;
  for (std::size_t i = 0; i < run.response.size(); ++i) {
    ASSERT_GE(run.response.series("normal_force")[i], -1e-3);
    const double r = std::hypot(run.response.series("displacement_x")[i], run.response.series("displacement_y")[i]);
    ASSERT_GE(run.response.series("displacement_z")[i], e.height(r) - 1e-9);
  }
  EXPECT_GT(run.summary.energy->contact, 0);
}

TEST(Uplift, StartsWhereTheNotesPutIt) {
  // N = W cos - z' I cos + ...: lift-off first seen between I = 3 and 3.6 MN (amplitude x 1.1)
  EXPECT_GT(*simulate_summary(ricker(1.08)).min_normal_force, 0);
  const auto lifted = simulate_summary(ricker(1.11));
  EXPECT_EQ(*lifted.min_normal_force, 0);
  EXPECT_NEAR(lifted.impacts.at(0).peak_force, 3.4e6, 2e5);
}

/// Thrown upwards by 2 g for 0.3 s, then free: the largest height is (0.045 + 0.045) g, between two steps.
TEST(Uplift, TheLargestHeightInFlightIsNotThatOfAStepsEnd) {
  for (const double end : {0.3, 0.307, 0.311}) {
    scene::Scene s;
    s.excitation.kind = ExcitationKind::record;
    s.excitation.z = {end, {-2 * 9.81, -2 * 9.81}};
    s.excitation.duration = 1.0;
    s.load.vertical = 9.81 * s.load.mass; // the default's weight is rounded: its W/m is 2e-6 above g
    const double expected = end * end * 9.81;
    EXPECT_NEAR(simulate(s).summary.peak_vertical_displacement, expected, 1e-7 * expected)
        << end; // a step's end errs by 6e-5; what is left is where the record ends, to 1e-8 s
  }
}
