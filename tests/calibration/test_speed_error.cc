// Speed against error on made-up runs whose forces converge with a known order.
#include "calibration/studies/speed_error.h"
#include "calibration/studies/speed_error_text.h"
#include "io/files/error.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {

/// Half a sine of force between 0.1 and 0.14 s.
Response pulse(double peak) {
  Response r;
  for (int k = 0; k <= 400; ++k) {
    const double t = 1e-3 * k, s = (t - 0.1) / 0.04, force = s > 0 && s < 1 ? -peak * std::sin(M_PI * s) : 0.0;
    r.append("time", t);
    for (const char *axis : {"x", "y"}) {
      const bool x = *axis == 'x';
      r.append(std::string("displacement_") + axis, x ? 0.4 + 1e-9 * peak : 0);
      r.append(std::string("velocity_") + axis, x ? (t < 0.12 ? 0.5 : -0.2) : 0);
      r.append(std::string("force_") + axis, x ? force : 0);
      r.append(std::string("impact_") + axis, x ? force : 0);
    }
  }
  return r;
}

StudyRun run(SolvedBy rung, int mesh, double seconds, double peak) {
  StudyRun result;
  result.name = word(rung) + std::to_string(mesh);
  result.rung = rung;
  result.mesh = mesh;
  result.seconds = seconds;
  result.peak_force = peak;
  result.dissipated = 1e3;
  result.response = pulse(peak);
  return result;
}

double on_mesh(int mesh, double order) {
  return 1e6 * (1 + 0.05 * std::pow(1.5, -order * (mesh - 1)));
}

TEST(SpeedError, ThreeMeshesGiveTheOrderAndTheLimit) {
  for (const double order : {1.0, 2.0, 3.0}) {
    std::vector<StudyRun> runs{run(SolvedBy::reduced, 0, 1e-3, 1.3e6)};
    for (const int mesh : {3, 1, 2}) runs.push_back(run(SolvedBy::rim, mesh, 10.0 * mesh * mesh, on_mesh(mesh, order)));
    const SpeedError study = speed_against_error(runs, 0.4, 0.03);
    ASSERT_TRUE(study.order);
    EXPECT_NEAR(*study.order, order, 1e-6);
    EXPECT_NEAR(*study.extrapolated, 1e6, 1e-3);
    EXPECT_NEAR(study.rows[1].error, 0.05, 1e-9);
    EXPECT_EQ(study.recommended, order == 1 ? "rim3" : "rim2");
    EXPECT_TRUE(study.rows.back().reference);
  }
}

TEST(SpeedError, TheFrontierLeavesOutWhatIsSlowerAndWorse) {
  const SpeedError study =
      speed_against_error({run(SolvedBy::reduced, 0, 1e-3, 1.2e6), run(SolvedBy::rim, 1, 60, 1.01e6),
                           run(SolvedBy::rim, 2, 90, 1.05e6), run(SolvedBy::rigid_dish, 1, 400, 1e6)},
                          0.4, 0.02);
  ASSERT_EQ(study.rows.size(), 4u);
  EXPECT_FALSE(study.extrapolated);
  const bool expected[] = {true, true, false, false}; // the reference's own error is not known
  for (int k = 0; k < 4; ++k) EXPECT_EQ(study.rows[k].on_frontier, expected[k]) << study.rows[k].run.name;
  EXPECT_EQ(study.recommended, "rim1");
  EXPECT_NEAR(*study.rows[0].errors.peak_force_error, 0.2, 1e-3);
  EXPECT_EQ(speed_against_error({run(SolvedBy::reduced, 0, 1e-3, 1.2e6), run(SolvedBy::rim, 1, 60, 1e6)}, 0.4, 0.02)
                .recommended,
            "");
}

TEST(SpeedError, WhatIsDissipatedIsComparedOverTheSameSpan) {
  StudyRun shorter = run(SolvedBy::rim, 1, 60, 1e6);
  Response cut;
  for (const auto &[name, values] : shorter.response.all())
    for (std::size_t i = 0; i < 200; ++i) cut.append(name, values[i]);
  shorter.response = cut;
  const SpeedError study =
      speed_against_error({shorter, run(SolvedBy::rim, 2, 90, 1e6), run(SolvedBy::full, 1, 400, 1e6)}, 0.4, 0.02);
  EXPECT_FALSE(study.rows[0].dissipated_error);
  EXPECT_TRUE(study.rows[1].dissipated_error);
}

TEST(SpeedError, WithoutImpactErrorsAreOfTheDisplacement) {
  const SpeedError touching =
      speed_against_error({run(SolvedBy::reduced, 0, 1e-3, 1e6), run(SolvedBy::rim, 1, 60, 1e6)}, 0.4, 0.02);
  EXPECT_NE(describe(touching).find("an error of the peak force of 2 % or less"), std::string::npos);
  std::vector<StudyRun> runs{run(SolvedBy::reduced, 0, 1e-3, 0), run(SolvedBy::rim, 1, 60, 0)};
  for (auto &each : runs) each.peak_force.reset();
  const SpeedError passing = speed_against_error(runs, 0.4, 0.02);
  EXPECT_EQ(to_json(passing)["error_of"], "peak_displacement");
  EXPECT_NE(describe(passing).find("does not touch the rim"), std::string::npos);
  EXPECT_NE(describe(passing).find("an error of the peak displacement of 2 % or less: reduced0"), std::string::npos);
}

TEST(SpeedError, TheCheapestHasTheLeastProcessorTime) {
  auto waiting = run(SolvedBy::rim, 1, 90, 1.01e6), hurried = run(SolvedBy::rim, 2, 60, 1.001e6);
  waiting.processor = 30, hurried.processor = 58; // the first one shared its core
  const SpeedError study = speed_against_error({hurried, waiting, run(SolvedBy::rigid_dish, 1, 400, 1e6)}, 0.4, 0.02);
  EXPECT_EQ(study.rows[0].run.name, "rim1");
  EXPECT_EQ(study.recommended, "rim1");
}

TEST(SpeedError, ScatteredMeshesAreNotExtrapolated) {
  const SpeedError study = speed_against_error(
      {run(SolvedBy::rim, 1, 10, 1.00e6), run(SolvedBy::rim, 2, 40, 1.02e6), run(SolvedBy::rim, 3, 90, 1.01e6)}, 0.4,
      0.02);
  EXPECT_FALSE(study.order);
  EXPECT_FALSE(study.extrapolated);
}

TEST(SpeedError, ReadsASummaryAndSaysWhatIsMissing) {
  const nlohmann::json summary{
      {"rung", "rim"},
      {"mesh", 2},
      {"wall_time_s", 30.0},
      {"peak_memory_bytes", 4e8},
      {"n_dofs", 42000},
      {"peak_impact_force_N", nullptr},
      {"energy", {{"imbalance_relative", 1e-4}, {"friction_J", 10.0}, {"plastic_J", 5.0}, {"impact_J", 1.0}}}};
  const StudyRun read = study_run("a", summary, pulse(1));
  EXPECT_EQ(read.dissipated, 16);
  EXPECT_FALSE(read.processor);
  auto timed = summary;
  timed["processor_time_s"] = 21.0;
  EXPECT_EQ(study_run("a", timed, pulse(1)).cost(), 21);
  EXPECT_FALSE(read.peak_force);
  auto broken = summary;
  broken.erase("energy");
  EXPECT_THROW(study_run("a", broken, pulse(1)), DataError);
  EXPECT_THROW(speed_against_error({run(SolvedBy::rim, 1, 10, 1e6)}, 0.4, 0.02), InputError);
  EXPECT_THROW(speed_against_error({run(SolvedBy::rim, 1, 10, 1e6), run(SolvedBy::rim, 2, 10, 1e6)}, 0.4, 0),
               InputError);
}

} // namespace
} // namespace rimpact::calibration
