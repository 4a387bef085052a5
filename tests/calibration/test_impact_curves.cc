#include "calibration/fit/impact_curves.h"
#include "synthetic.h"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

FitResult pair(double k_i, double e) {
  FitResult law;
  law.law = "signed";
  law.parameters["k_i"].value = k_i;
  law.parameters["e"].value = e;
  law.names = {"k_i", "e"};
  return law;
}

TEST(ImpactCurves, TheLawThatMadeARunLiesOnIt) {
  const std::vector<StoredRun> fitted = {run_of(window(0.1)), run_of(window(0.5))}, predicted = {run_of(ricker(1.1))};
  const auto curves = impact_curves(fitted, predicted, pair(3e5, 0.4));
  ASSERT_EQ(curves.impacts.size(), 2 + predicted.front().impacts.size());
  for (const auto &c : curves.impacts) {
    EXPECT_EQ(c.source, RunSource::reduced_model);
    EXPECT_EQ(c.fitted, c.run.starts_with("window"));
    for (const auto *curve : {&c.reference, &c.law}) {
      ASSERT_EQ(curve->time.size(), curve->force.size());
      ASSERT_EQ(curve->time.size(), curve->penetration.size());
      EXPECT_TRUE(std::is_sorted(curve->time.begin(), curve->time.end()));
    }
    const double peak = *std::max_element(c.reference.force.begin(), c.reference.force.end()),
                 depth = *std::max_element(c.reference.penetration.begin(), c.reference.penetration.end());
    EXPECT_NEAR(*std::max_element(c.law.force.begin(), c.law.force.end()) / peak, 1, 1e-3);
    EXPECT_NEAR(*std::max_element(c.law.penetration.begin(), c.law.penetration.end()) / depth, 1, 1e-3);
  }
}

TEST(ImpactCurves, AnotherStiffnessDoesNot) {
  const auto curves = impact_curves({run_of(window(0.3))}, {}, pair(6e5, 0.4));
  const auto &c = curves.impacts.front();
  EXPECT_GT(*std::max_element(c.law.force.begin(), c.law.force.end()),
            1.3 * *std::max_element(c.reference.force.begin(), c.reference.force.end()));
  EXPECT_DOUBLE_EQ(curves.scene.reduced.k_i, 6e8);
}

TEST(ImpactCurves, TheFileHoldsSceneAndCurves) {
  TemporaryFolder folder;
  write_curves(impact_curves({run_of(window(0.2))}, {}, pair(3e5, 0.4)), folder.at("."));
  std::ifstream stream(folder.at("curves.json"));
  const auto file = nlohmann::json::parse(stream);
  EXPECT_EQ(file["law"], "signed");
  EXPECT_DOUBLE_EQ(scene::parse_scene(file["scene"], "curves.json").excitation.speed, 0.2);
  const auto &impact = file["impacts"].at(0);
  EXPECT_EQ(impact["run"], "window-0.2");
  for (const char *part : {"reference", "law"})
    for (const char *key : {"time_s", "penetration_m", "force_N"})
      EXPECT_GT(impact[part][key].size(), 8u) << part << key;
  EXPECT_LT(impact["reference"]["time_s"].front().get<double>(), 1e-12);
}

} // namespace
} // namespace rimpact::calibration
