#include "../scene/temporary_folder.h"
#include "calibration/studies/stored_study.h"
#include "scene/bearing_catalogue.h"
#include "scene/rim_identity.h"
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace {
using namespace rimpact;
using namespace rimpact::calibration;

nlohmann::json row(int mesh, double error, bool reference) {
  return {{"rung", "rim"},
          {"mesh", mesh},
          {"name", "rim-mesh" + std::to_string(mesh)},
          {"error", error},
          {"rebound_error", 2 * error},
          {"peak_displacement_error", -error},
          {"reference", reference}};
}

StoredStudy study(const std::string &name, double speed, double error, bool extrapolated) {
  const scene::Bearing bearing;
  return {name,
          scene::rim_identity(bearing),
          scene::bearing_identity(bearing),
          86952,
          speed,
          {{"rows", {row(1, error, false), row(2, error / 2, true)}},
           {"extrapolated_peak_force_N", extrapolated ? nlohmann::json(1e6) : nlohmann::json()},
           {"observed_order", extrapolated ? nlohmann::json(2.0) : nlohmann::json()}}};
}

struct ErrorEstimate : ::testing::Test {
  scene::Scene scene = scene::load_scene("impact-window", {});
  Summary summary;
  std::vector<StoredStudy> studies{study("slow", 0.1, 0.002, true), study("fast", 0.5, 0.02, false)};
  ErrorEstimate() { summary.impacts.push_back({0, 0.1, 0, 0.4, -0.1, 0, 0}); }
};

TEST_F(ErrorEstimate, IsBetweenThoseOfTheEnclosingSpeeds) {
  const auto estimate = error_estimate(scene, summary, studies);
  EXPECT_EQ(estimate["from"], "slow and fast");
  const double share = std::log(4) / std::log(5);
  EXPECT_NEAR(estimate["peak_force_relative"], 0.002 + share * 0.018, 1e-12);
  EXPECT_NEAR(estimate["rebound_relative"], 2 * (0.002 + share * 0.018), 1e-12);
}

TEST_F(ErrorEstimate, CountsTheMassInTheSeverity) {
  scene.load.mass = 86952 * 1.5625; // 0.4 m/s of it is as severe as 0.5 m/s of the studies' mass
  EXPECT_NEAR(error_estimate(scene, summary, studies)["peak_force_relative"], 0.02, 1e-12);
}

TEST_F(ErrorEstimate, BeyondThemIsThatOfTheNearestSpeed) {
  summary.impacts[0].approach_speed = 0.6;
  const auto estimate = error_estimate(scene, summary, studies);
  EXPECT_EQ(estimate["from"], "fast");
  EXPECT_DOUBLE_EQ(estimate["peak_force_relative"], 0.02);
  EXPECT_DOUBLE_EQ(estimate["rebound_relative"], 0.04);
  const std::string sentence = estimate["sentence"];
  EXPECT_NE(sentence.find("2.0 % of its finest run, rim-mesh2"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("far from it"), std::string::npos);
}

TEST_F(ErrorEstimate, IsNotTakenFromAStudyAgainstAnotherRung) {
  StoredStudy rungs = study("rungs", 0.4, 0.05, false);
  rungs.json["rows"][1]["rung"] = "full";
  studies.push_back(rungs);
  EXPECT_EQ(error_estimate(scene, summary, studies)["from"], "slow and fast");
}

TEST_F(ErrorEstimate, SaysWhenTheNearestIsFar) {
  summary.impacts[0].approach_speed = 0.02;
  const auto estimate = error_estimate(scene, summary, studies);
  EXPECT_EQ(estimate["from"], "slow");
  const std::string sentence = estimate["sentence"];
  EXPECT_NE(sentence.find("far from it"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("the limit of three meshes (observed order 2)"), std::string::npos) << sentence;
}

TEST_F(ErrorEstimate, IsNoneForAReferenceWithoutLimitAnotherRungBearingOrNoImpact) {
  scene.model.mesh = 2;
  EXPECT_EQ(error_estimate(scene, summary, studies)["from"], "slow"); // fast's mesh 2 is its reference
  EXPECT_TRUE(error_estimate(scene, summary, {studies[1]}).contains("none"));
  scene.model.rung = scene::Rung::full;
  EXPECT_TRUE(error_estimate(scene, summary, studies).contains("none"));
  scene.model.rung = scene::Rung::rim;
  scene.bearing.rim.thickness = 0.05; // and still called shfps-225
  const auto none = error_estimate(scene, summary, studies, {"results/w", 60});
  EXPECT_EQ(none["none"], "unknown: no stored study has rung rim, mesh 2 of this bearing. This command finds it: "
                          "rimpact study results/w/scene.toml --axes mesh "
                          "--meshes 1,2,3 -o results/study-w (about 7 min)"); // 60 s (1 / 6.2 + 1 + 6.2)
  scene.bearing = {};
  scene.bearing.name = "mine"; // a name is no dimension
  EXPECT_FALSE(error_estimate(scene, summary, studies).contains("none"));
  scene.bearing.pad.thickness = 0.05; // nor is the pad the rim's
  EXPECT_FALSE(error_estimate(scene, summary, studies).contains("none"));
  scene.bearing = {};
  summary.impacts.clear();
  EXPECT_TRUE(error_estimate(scene, summary, studies).contains("none"));
}

TEST(StoredStudies, AreReadFromBesideTheRunAndOthersPassedOver) {
  const TemporaryFolder kept;
  const std::filesystem::path folder = kept.path();
  std::filesystem::create_directories(folder / "study-a");
  std::filesystem::create_directories(folder / "study-b");
  auto json = study("", 0.3, 0.01, true).json;
  scene::Scene mine;
  mine.bearing.rim.thickness = 0.05;
  json["scene"] = studied_scene(mine, 0.3);
  std::ofstream(folder / "study-a/study.json") << json;
  std::ofstream(folder / "study-b/study.json") << "{ broken";
  int own = 0;
  for (const auto &found : stored_studies(folder)) own += found.rim_identity == scene::rim_identity(mine.bearing);
  EXPECT_EQ(own, 1);
}

TEST(StoredStudies, OfTheProgramKnowTheDefaultBearing) {
  const auto studies = stored_studies("");
  ASSERT_FALSE(studies.empty());
  for (const auto &study : studies) {
    EXPECT_EQ(study.rim_identity, scene::rim_identity(scene::builtin_bearing("shfps-225"))) << study.name;
    EXPECT_EQ(study.bearing_identity, scene::bearing_identity(scene::builtin_bearing("shfps-225"))) << study.name;
    EXPECT_EQ(study.mass, 86952);
    EXPECT_GT(study.approach_speed.value_or(0), 0);
  }
}

} // namespace
