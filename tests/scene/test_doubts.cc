#include "scene/doubts.h"
#include <gtest/gtest.h>

namespace {
using namespace rimpact::scene;

TEST(Doubts, NoneAboutTheDefaultScene) { EXPECT_TRUE(doubts(Scene{}).empty()); }

TEST(Doubts, AMassInTonnesIsNoticed) {
  Scene s;
  s.load.mass /= 1000;
  ASSERT_EQ(doubts(s).size(), 1u);
  EXPECT_NE(doubts(s)[0].find("1e+03 times load.mass_kg = 86.952"), std::string::npos) << doubts(s)[0];
  s.load.vertical = 0; // no weight is a case of its own, not a slip
  EXPECT_TRUE(doubts(s).empty());
}

TEST(Doubts, ARecordInTheWrongUnitIsNoticed) {
  Scene s;
  s.excitation.kind = ExcitationKind::record;
  s.excitation.x = {0.01, {0, 300, -780}}; // cm/s^2 read as m/s^2
  ASSERT_EQ(doubts(s).size(), 1u);
  EXPECT_NE(doubts(s)[0].find("79.5 g"), std::string::npos) << doubts(s)[0];
  s.excitation.scale = 0.01;
  EXPECT_TRUE(doubts(s).empty());
}

TEST(Doubts, AnImpactOfTenMetresASecondIsNoticed) {
  Scene s;
  s.excitation.kind = ExcitationKind::window;
  s.excitation.speed = 11;
  EXPECT_EQ(doubts(s).size(), 1u);
}

} // namespace
