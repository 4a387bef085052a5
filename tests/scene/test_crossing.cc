// Where a series first passes a level: straight lines have it in closed form.
#include "responses/crossing.h"
#include <gtest/gtest.h>
#include <vector>

using namespace rimpact;

namespace {

const std::vector<double> depth{0, 2, 3, 7};

/// Of `depth`, where `values` first pass 1.
std::optional<double> depth_where(const std::vector<double> &values) {
  const auto crossing = first_crossing(values, 1);
  if (!crossing) return {};
  return crossing->of(depth);
}

TEST(Crossing, LiesOnTheStraightLineBetweenTwoPoints) {
  EXPECT_DOUBLE_EQ(depth_where({0, 0.5, 1.5, 9}).value(), 2.5);
  EXPECT_DOUBLE_EQ(depth_where({0.5, 1.5, 0, 0}).value(), 1) << "the first one, though it falls again";
  const auto crossing = first_crossing(std::vector<double>{0, 0.5, 1.5, 9}, 1);
  EXPECT_EQ(crossing.value().right, 2U);
  EXPECT_DOUBLE_EQ(crossing->share, 0.5);
}

TEST(Crossing, IsAtThePointThatMeetsTheLevel) {
  EXPECT_EQ(depth_where({0, 1, 2, 3}), 2);
  EXPECT_EQ(depth_where({0, 1, 1, 3}), 3) << "a level that is kept is passed where the series leaves it";
}

TEST(Crossing, IsAtTheFirstPointOfASeriesThatBeginsBeyond) {
  EXPECT_EQ(depth_where({1.5, 2, 3, 4}), 0);
  EXPECT_EQ(depth_where({1.5, 0.5, 0.2, 0}), 0) << "it falls";
  EXPECT_EQ(depth_where({1, 1.5, 2, 3}), 0) << "it begins at the level";
}

TEST(Crossing, IsNoneWhereTheLevelIsBorne) {
  EXPECT_FALSE(depth_where({0, 0.2, 0.9, 0.99}));
  EXPECT_FALSE(depth_where({0.9, 0.5, 0.2, 0})) << "it falls";
  EXPECT_FALSE(depth_where({0, 0.5, 1, 1})) << "it is met and not passed";
  EXPECT_FALSE(depth_where({1, 0.5, 0.2, 0})) << "it falls from the level";
  EXPECT_FALSE(first_crossing({}, 1));
}

} // namespace
