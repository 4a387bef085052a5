#include "scene/published_pair.h"
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {
using namespace rimpact::scene;

TEST(PublishedPair, TheSolidsImpactsAreThoseOfTheKeptRuns) {
  for (const auto &impact : solid_impacts) {
    std::ifstream file(fmt::format("{}/window-{:.2f}/summary.json", RIMPACT_REFERENCES, impact.speed));
    ASSERT_TRUE(file) << impact.speed;
    const auto kept = nlohmann::json::parse(file)["impacts"][0];
    EXPECT_NEAR(kept["approach_speed_m_s"].get<double>(), impact.speed, 2e-3 * impact.speed);
    EXPECT_NEAR(kept["peak_force_N"].get<double>(), impact.peak_force, 1e-3 * impact.peak_force);
    EXPECT_NEAR(kept["restitution"].get<double>(), impact.restitution, 1e-3);
  }
}

TEST(PublishedPair, IsDoubtedAtSpeedsItDoesNotHoldFor) {
  Scene s;
  EXPECT_EQ(doubt_of_published_pair(s, 0.01), "");
  EXPECT_EQ(doubt_of_published_pair(s, 0.1), "");
  EXPECT_EQ(doubt_of_published_pair(s, 0.2), ""); // 15 % off
  const auto fast = doubt_of_published_pair(s, 1.0);
  EXPECT_NE(fast.find("at 1 m/s finite elements (rung rigid-dish) give this rim 0.42 of the pair's peak force and a "
                      "rebound of 0.14"),
            std::string::npos)
      << fast;
  EXPECT_NE(doubt_of_published_pair(s, 2.5).find("at 1.2 m/s, short of the 2.5 m/s here,"), std::string::npos)
      << doubt_of_published_pair(s, 2.5);
  s.reduced.k_i *= 0.9; // somebody's own
  EXPECT_EQ(doubt_of_published_pair(s, 1.0), "");
}

// The fastest speed the pair is known for is where the doubt begins.
TEST(PublishedPair, IsKnownUpToWhereItIsDoubted) {
  Scene s;
  const double mass = s.load.mass, fastest = *fastest_of_pair(s, mass);
  EXPECT_GT(fastest, 0.2);
  EXPECT_EQ(doubt_of_published_pair(s, fastest), "");
  EXPECT_NE(doubt_of_published_pair(s, 1.01 * fastest), "");
  EXPECT_EQ(*fastest_of_pair(s, 2 * mass), 0) << "published for another mass";
  s.reduced.k_i *= 0.9;
  EXPECT_FALSE(fastest_of_pair(s, mass)) << "somebody's own";
}

} // namespace
