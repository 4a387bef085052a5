#include "calibration/studies/vary_answer.h"
#include "calibration/studies/vary_results.h"
#include "io/files/error.h"
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace rimpact::calibration {
namespace {

constexpr double mass = 86952, stiffness = 6e6, power = 0.4, elastic = 1.2e9;

/// F = scale K d^n, back along a line of slope `elastic`; the strain grows as d / `tough`.
reduced::RimCurveFile power_curve(double scale, double deepest, double tough = 0.1) {
  reduced::RimCurveFile file;
  const auto force = [&](double d) { return scale * stiffness * std::pow(d, power); };
  constexpr int n = 400;
  for (int i = 0; i <= n; ++i) {
    const double d = deepest * std::pow(double(i) / n, 2);
    file.held.loading.penetration.push_back(d), file.held.loading.force.push_back(force(d));
    file.strain.penetration.push_back(d), file.strain.strain.push_back(d / tough);
  }
  for (const double share : {0.1, 0.3, 0.6, 1.0}) {
    const double top = file.held.loading.penetration[static_cast<std::size_t>(n * std::sqrt(share))];
    laws::CurveSamples back;
    for (int i = 0; i <= 20; ++i)
      back.penetration.push_back(top - force(top) / elastic * i / 20), back.force.push_back(force(top) * (20 - i) / 20);
    file.held.unloading.push_back(back);
  }
  return file;
}

VaryQuestion asked(std::map<std::string, double> targets = {}) {
  return {.keys = {{"rim.thickness_mm", {20, 50, 80}}},
          .speed = 0.8,
          .mass = mass,
          .strain_limit = 0.2,
          .targets = std::move(targets)};
}

/// Of the work K d^(n + 1) / (n + 1) = m v^2 / 2.
double depth_of(double scale, double speed) {
  return std::pow((power + 1) * mass * speed * speed / 2 / (scale * stiffness), 1 / (power + 1));
}

VaryPoint at(double thickness, const VaryQuestion &question, double tough = 0.1) {
  const double scale = std::sqrt(thickness / 50);
  VaryPoint point = vary_point(power_curve(scale, 0.06, tough), question);
  point.at = {thickness};
  return point;
}

std::vector<VaryPoint> three(const VaryQuestion &question, double tough = 0.1) {
  return {at(20, question, tough), at(50, question, tough), at(80, question, tough)};
}

TEST(VaryPoint, IsTheClosedFormOfAPowerCurve) {
  const auto point = vary_point(power_curve(1, 0.06), asked());
  const double d = depth_of(1, 0.8), force = stiffness * std::pow(d, power);
  EXPECT_NEAR(point.depth / d, 1, 2e-3);
  EXPECT_NEAR(point.peak_force / force, 1, 2e-3);
  EXPECT_NEAR(point.rebound / (force / std::sqrt(elastic * mass)), 1, 0.01); // F^2 / 2k comes back
  EXPECT_NEAR(*point.strain, d / 0.1, 2e-3 * d / 0.1);
  const double reached = std::sqrt(2 * stiffness * std::pow(0.02, power + 1) / (power + 1) / mass); // strain 0.2
  ASSERT_TRUE(point.speed_at_limit);
  EXPECT_NEAR(*point.speed_at_limit / reached, 1, 2e-3);
}

TEST(VaryPoint, SaysWhatTheCurveDoesNotReach) {
  EXPECT_THROW(vary_point(power_curve(1, 0.005), asked()), DataError);
  const auto tough = vary_point(power_curve(1, 0.06, 10), asked());
  EXPECT_FALSE(tough.speed_at_limit);
  EXPECT_GT(tough.fastest, 0.8);
  auto old = power_curve(1, 0.06);
  old.foot = {{0, 0.1}, {0, 10}}; // goes at 10 mm
  const VaryPoint joined = vary_point(old, asked());
  EXPECT_NEAR(joined.foot_use.value(), joined.depth / 0.01, 1e-9);
  EXPECT_NEAR(joined.foot_goes_at.value(), std::sqrt(2 * stiffness * std::pow(0.01, power + 1) / (power + 1) / mass),
              2e-3);
  old.foot = {}, old.strain = {};
  const auto unknown = vary_point(old, asked());
  EXPECT_FALSE(unknown.strain);
  EXPECT_TRUE(std::isnan(unknown.output(3)));
}

TEST(VaryInterpolation, IsExactForPowersAndSaysItsError) {
  const auto question = asked();
  const auto points = three(question);
  for (const double thickness : {25.0, 37.0, 65.0, 79.0}) {
    const auto found = interpolated(points, 0, thickness);
    EXPECT_NEAR(found.value / (at(thickness, question).peak_force / 1e3), 1, 1e-3) << thickness;
    EXPECT_LT(*found.error, 2e-3);
  }
  auto bent = points;
  bent[1].peak_force *= 1.1;
  const auto found = interpolated(bent, 0, 35);
  EXPECT_GT(*found.error, 0.01);
  EXPECT_DOUBLE_EQ(interpolated(bent, 0, 50).value, bent[1].peak_force / 1e3);
  EXPECT_EQ(*interpolated(bent, 0, 50).error, 0);
  EXPECT_FALSE(interpolated({points[0], points[2]}, 0, 50).error) << "two points say nothing of it";
}

TEST(VaryAnswer, FindsTheThicknessOfAForce) {
  // F goes as scale^(1 / (n + 1)), scale as the root of the thickness.
  const auto question = asked({{"peak_kN", 1e-3 * at(50, asked()).peak_force}});
  const auto answer = vary_answer(three(question, 10), question);
  ASSERT_TRUE(answer.design);
  EXPECT_TRUE(answer.reached);
  EXPECT_NEAR(answer.force_error, CurveAgainstWindows{}.force, 1e-4);
  const double safe =
      50 * std::pow(1 + answer.force_error, -2 * (power + 1)); // the target is met with the error on top
  EXPECT_NEAR(answer.design->at(0), safe, 1);
  EXPECT_LT(answer.design->at(0), safe);
  EXPECT_NE(answer.sentence.find("is met by rim.thickness_mm from 20 to 50"), std::string::npos) << answer.sentence;
  EXPECT_NE(answer.sentence.find("error 2.0 %"), std::string::npos) << answer.sentence;
}

TEST(VaryAnswer, TheSteelIsALimitToo) {
  auto question = asked({{"peak_kN", 1e4}});
  const auto thick = at(65, question);
  question.strain_limit = thick.strain;
  const auto answer = vary_answer(three(question), question);
  EXPECT_NE(answer.sentence.find("rim.thickness_mm from 65"), std::string::npos) << answer.sentence;
  EXPECT_DOUBLE_EQ(answer.design->at(0), 80) << "the least strained";
}

TEST(VaryAnswer, NoRimMayMeetIt) {
  const auto question = asked({{"peak_kN", 100}});
  const auto answer = vary_answer(three(question), question);
  EXPECT_FALSE(answer.reached);
  EXPECT_DOUBLE_EQ(answer.design->at(0), 20) << "the nearest";
  EXPECT_NE(answer.sentence.find("no rim of the range meets"), std::string::npos) << answer.sentence;
  EXPECT_FALSE(vary_answer({}, question).design);
}

TEST(VaryAnswer, OfSeveralKeysTheCombinationsAreNamed) {
  auto question = asked({{"peak_kN", 1e-3 * at(50, asked()).peak_force}});
  question.keys.push_back({"rim.height_mm", {60, 80}});
  auto points = three(question, 10);
  points.erase(points.begin() + 1);
  points[0].at = {20, 60}, points[1].at = {80, 60};
  const auto answer = vary_answer(points, question);
  EXPECT_EQ(*answer.design, (std::vector<double>{20, 60}));
  EXPECT_NE(answer.sentence.find("is met by rim.thickness_mm = 20, rim.height_mm = 60;"), std::string::npos)
      << answer.sentence;
  EXPECT_TRUE(answer.between.empty());
}

TEST(VaryResults, AreWholeRows) {
  const auto question = asked();
  const auto points = three(question);
  const auto json = to_json(points, question);
  EXPECT_EQ(json["points"].size(), 3u);
  EXPECT_NEAR(json["points"][1]["utilisation"].get<double>(), *points[1].strain / 0.2, 1e-12);
  std::istringstream csv(to_csv(points, question));
  std::string head, row;
  std::getline(csv, head), std::getline(csv, row);
  EXPECT_EQ(std::count(head.begin(), head.end(), ','), std::count(row.begin(), row.end(), ','));
  EXPECT_NE(describe(points, question).find("rim.thickness_mm"), std::string::npos);
}

TEST(CurveAgainstWindows, IsTheWorstOfTheKeptComparison) {
  std::ifstream file(RIMPACT_RIM_CURVES);
  double force = 0, restitution = 0;
  int n_rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    constexpr std::size_t after_name = 13;
    std::istringstream row(line.substr(after_name));
    double speed = 0, rim = 0, curve = 0, force_off = 0, rim_e = 0, curve_e = 0, e_off = 0;
    row >> speed >> rim >> curve >> force_off >> rim_e >> curve_e >> e_off;
    ASSERT_TRUE(row) << line;
    force = std::max(force, std::abs(force_off) / 100), restitution = std::max(restitution, std::abs(e_off) / 100);
    ++n_rows;
  }
  EXPECT_EQ(n_rows, 18);
  EXPECT_NEAR(CurveAgainstWindows{}.force, force, 1e-9);
  EXPECT_NEAR(CurveAgainstWindows{}.restitution, restitution, 1e-9);
}

} // namespace
} // namespace rimpact::calibration
