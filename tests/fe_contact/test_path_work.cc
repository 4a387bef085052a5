// The work along a path: exact for parabolas, a chord where it turns, bounded at kinks, of third order.
#include "fe_contact/drive/path_work.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace rimpact::fe {
namespace {

/// Along a slanted straight line, force and way in step with one another.
double work_of(const std::function<double(double)> &force, const std::vector<double> &at) {
  const Eigen::Vector3d direction(0.6, 0, 0.8);
  PathWork work;
  double total = 0;
  for (std::size_t k = 1; k < at.size(); ++k)
    total += work.add(force(at[k - 1]) * direction, force(at[k]) * direction, (at[k] - at[k - 1]) * direction);
  return total;
}

TEST(PathWork, IsExactForALineAndForAParabolaButForItsFirstStep) {
  EXPECT_NEAR(work_of([](double s) { return 3 + 2 * s; }, {0, 0.1, 0.4, 1}), 4, 1e-14);
  const auto parabola = [](double s) { return 1 + s * s; };
  const double first_chord = 0.1 * 0.1 * 0.1 / 6;
  EXPECT_NEAR(work_of(parabola, {0, 0.1, 0.3, 0.45, 1}), 4.0 / 3 + first_chord, 1e-14);
}

TEST(PathWork, IsOfThirdOrder) {
  const auto error = [](int n) {
    std::vector<double> at;
    for (int k = 0; k <= n; ++k) at.push_back(double(k) / n);
    return std::abs(work_of([](double s) { return std::exp(2 * s); }, at) - 0.5 * std::expm1(2));
  };
  EXPECT_NEAR(std::log2(error(40) / error(80)), 3, 0.2);
  EXPECT_LT(error(40), 1e-4 * 0.5 * std::expm1(2));
}

TEST(PathWork, GoesBackToItsStartWithoutWork) {
  const auto spring = [](double s) { return 5 * s; };
  EXPECT_NEAR(work_of(spring, {0, 0.2, 0.5, 1, 0.7, 0.1, 0}), 0, 1e-13);
}

/// Friction turns from -1 to 1 within a thousandth of the way: what a long step afterwards adds is its own work.
TEST(PathWork, IsNotThrownByAKink) {
  const auto friction = [](double s) { return std::clamp(-1 + 2000 * s, -1.0, 1.0); };
  EXPECT_NEAR(work_of(friction, {0, 0.001, 0.101, 1}), 1 - 0.001, 1e-3);
  PathWork work;
  work.add({0, 0, 0}, {1, 0, 0}, {1e-3, 0, 0});
  const double chord = 0.5 * (1 + 1.1) * 0.1;
  EXPECT_LE(std::abs(work.add({1, 0, 0}, {1.1, 0, 0}, {0.1, 0, 0}) - chord), 0.1 * 0.1 / 6 + 1e-15);
}

} // namespace
} // namespace rimpact::fe
