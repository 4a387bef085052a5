// The mass follows from the weight, and the weight from the mass, where only one is given.
#include "scene/scene.h"
#include "temporary_folder.h"
#include <gtest/gtest.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

Scene parse(const std::string &text, const std::vector<std::string> &overrides = {}) {
  return parse_scene("[excitation]\nkind = 'window'\n" + text, "my.toml", overrides);
}

TEST(Load, OneKeyIsEnough) {
  EXPECT_DOUBLE_EQ(parse("[load]\nvertical_kN = 2000\n").load.mass, 2000e3 / 9.81);
  EXPECT_DOUBLE_EQ(parse("", {"load.vertical_kN=2000", "load.gravity_m_per_s2=9.8"}).load.mass, 2000e3 / 9.8);
  EXPECT_DOUBLE_EQ(parse("[load]\nmass_kg = 2e5\n").load.vertical, 2e5 * 9.81);
  const Load both = parse("[load]\nmass_kg = 2e5\nvertical_kN = 853\n").load;
  EXPECT_DOUBLE_EQ(both.mass, 2e5);
  EXPECT_DOUBLE_EQ(both.vertical, 853e3);
  const Load none = parse("").load;
  EXPECT_DOUBLE_EQ(none.mass, 86952);
  EXPECT_DOUBLE_EQ(none.vertical, 853e3);
  EXPECT_DOUBLE_EQ(parse("[load]\nvertical_kN = 0\n").load.mass, 86952) << "no weight says nothing of the mass";
}

TEST(Load, AnotherBearingWithoutALoadIsRemarkedUpon) {
  const TemporaryFolder folder;
  folder.write("own.toml", "name = 'acme'\n[rim]\nheight_mm = 70\n");
  const auto remarks = [&](const std::string &more, const std::vector<std::string> &overrides = {}) {
    return load_scene(folder.write("s.toml", "[bearing]\nfile = 'own.toml'\n[excitation]\nkind = 'window'\n" + more),
                      overrides)
        .remarks;
  };
  ASSERT_EQ(remarks("").size(), 1u);
  for (const char *words : {"load.vertical_kN", "load.mass_kg", "acme", "853 kN", "86952 kg"})
    EXPECT_NE(remarks("")[0].find(words), std::string::npos) << words;
  EXPECT_TRUE(remarks("[load]\nmass_kg = 2e5\n").empty());
  EXPECT_TRUE(remarks("", {"load.vertical_kN=2000"}).empty());
  EXPECT_TRUE(load_scene("impact-window").remarks.empty());
  EXPECT_TRUE(load_scene("impact-window", {"bearing.rim.height_mm=70"}).remarks.empty())
      << "the same bearing, tried with another rim";
  EXPECT_EQ(load_scene("impact-window", {"bearing.surface.R0_m=3"}).remarks.size(), 1u);
}

TEST(Load, HalfALoadOfASceneThatHasBothIsRemarkedUpon) {
  const auto remarks = load_scene("ricker-0.78g-1.0s", {"load.vertical_kN=1500"}).remarks;
  ASSERT_EQ(remarks.size(), 1u);
  for (const char *words : {"load.mass_kg = 86952 stays", "1.76 m g", "set both"})
    EXPECT_NE(remarks[0].find(words), std::string::npos) << remarks[0];
  EXPECT_TRUE(load_scene("ricker-0.78g-1.0s", {"load.vertical_kN=1500", "load.mass_kg=152905"}).remarks.empty());
  EXPECT_TRUE(load_scene("ricker-0.78g-1.0s", {"load.vertical_kN=853"}).remarks.empty());
  EXPECT_TRUE(load_scene("impact-window", {"load.vertical_kN=1500"}).remarks.empty()) << "its mass follows";
}

TEST(Load, ASceneWithoutAMotionSaysWhichItRuns) {
  const auto remarks = parse_scene("", "empty.toml").remarks;
  ASSERT_EQ(remarks.size(), 1u);
  for (const char *words : {"empty.toml", "excitation.kind", "0.78 g", "shfps-225"})
    EXPECT_NE(remarks[0].find(words), std::string::npos) << remarks[0];
}

} // namespace
