// What the signals say beside one another: accelerations are forces over masses, an impulse is a change of momentum.
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;

namespace {

double largest(const Response &r, const std::string &name) {
  const auto &x = r.series(name + "_x"), &y = r.series(name + "_y");
  double peak = 0;
  for (std::size_t i = 0; i < x.size(); ++i) peak = std::max(peak, std::hypot(x[i], y[i]));
  return peak;
}

} // namespace

TEST(Signals, AbsoluteAccelerationIsTheForceOverTheMass) {
  for (const char *model : {"physical", "dcfp"}) {
    const auto scene = scene::load_scene("ricker-0.78g-1.0s", {std::string("reduced.model=\"") + model + "\""});
    const auto run = reduced::simulate(scene);
    const auto &a = run.response.series("acceleration_x"), &f = run.response.series("force_x"),
               &ground = run.response.series("ground_acceleration_x"), &time = run.response.series("time");
    const double peak = largest(run.response, "force");
    const scene::GroundMotion motion(scene.excitation, scene.load.gravity);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(scene.load.mass * a[i], f[i], 1e-5 * peak) << model << " at " << time[i];
      EXPECT_EQ(ground[i], motion.acceleration(time[i]).x());
    }
  }
}

TEST(Signals, AnImpulseIsTheChangeOfMomentum) {
  for (const char *law : {"signed", "hunt-crossley", "elastoplastic"}) {
    const auto scene = scene::load_scene("impact-window", {std::string("reduced.impact_law=\"") + law + "\""});
    const auto impact = reduced::simulate(scene).summary.impacts.at(0);
    const double momentum = scene.load.mass * (impact.approach_speed + impact.rebound_speed);
    EXPECT_NEAR(*impact.impulse, momentum, 1e-6 * momentum) << law;
  }
}

/// The summary's are found between the samples, so that none is below theirs.
TEST(Signals, PeaksOfSignalsAreTheSummarys) {
  for (const char *scale : {"0.9", "1.05"}) {
    const auto run = reduced::simulate(
        scene::load_scene("ricker-0.78g-1.0s", {std::string("excitation.scale=") + scale, "reduced.output_step_ms=1"}));
    const double travel = largest(run.response, "displacement"), force = largest(run.response, "force"),
                 rim = largest(run.response, "impact");
    EXPECT_LE(travel, run.summary.peak_displacement);
    EXPECT_NEAR(travel, run.summary.peak_displacement, 1e-4 * travel);
    EXPECT_LE(force, run.summary.peak_lateral_force * (1 + 1e-9));
    EXPECT_NEAR(force, run.summary.peak_lateral_force, 2e-3 * force);
    EXPECT_LE(rim, *run.summary.peak_impact_force * (1 + 1e-9));
    EXPECT_NEAR(rim, *run.summary.peak_impact_force, 1e-3 * rim);
  }
}
