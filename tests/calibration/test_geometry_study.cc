#include "calibration/studies/geometry_results.h"
#include "calibration/studies/wanted_pair.h"
#include "io/files/error.h"
#include "synthetic.h"
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

TEST(Surrogate, RecoversAProductOfPowers) {
  std::vector<std::vector<double>> x;
  std::vector<double> y;
  for (int i = 1; i <= 12; ++i) {
    x.push_back({1.0 + i % 4, 2.0 + i % 3, 0.1 * i});
    y.push_back(5 * std::pow(x.back()[0], 0.7) * std::pow(x.back()[1], -1.3) * std::pow(x.back()[2], 0.4));
  }
  const auto s = power_surrogate(x, y);
  ASSERT_TRUE(s);
  EXPECT_NEAR(s->exponents[0], 0.7, 1e-10);
  EXPECT_NEAR(s->exponents[1], -1.3, 1e-10);
  EXPECT_NEAR(s->exponents[2], 0.4, 1e-10);
  EXPECT_LT(s->left_out_largest, 1e-9);
  EXPECT_NEAR(s->at({2, 3, 0.5}), 5 * std::pow(2, 0.7) * std::pow(3, -1.3) * std::pow(0.5, 0.4), 1e-9);
  EXPECT_TRUE(s->covers({2, 3, 0.5}));
  EXPECT_FALSE(s->covers({2, 3, 5}));
}

TEST(Surrogate, ItsErrorIsThatOfFitsWithoutTheRow) {
  std::vector<std::vector<double>> x;
  std::vector<double> y;
  for (int i = 1; i <= 8; ++i) x.push_back({1.0 * i}), y.push_back(std::pow(i, 0.5) * (i % 2 ? 1.1 : 0.95));
  const auto s = power_surrogate(x, y);
  double square = 0, largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    auto fewer_x = x;
    auto fewer_y = y;
    fewer_x.erase(fewer_x.begin() + i), fewer_y.erase(fewer_y.begin() + i);
    const double error = std::expm1(std::abs(std::log(power_surrogate(fewer_x, fewer_y)->at(x[i]) / y[i])));
    square += error * error / x.size(), largest = std::max(largest, error);
  }
  EXPECT_NEAR(s->left_out_rms, std::sqrt(square), 1e-10);
  EXPECT_NEAR(s->left_out_largest, largest, 1e-10);
}

TEST(Surrogate, IsEmptyWhereTheRowsDoNotTell) {
  EXPECT_FALSE(
      power_surrogate({{1, 2}, {2, 4}, {3, 6}, {4, 8}, {5, 10}, {6, 12}}, {1, 2, 3, 4, 5, 6})); // one input twice
  EXPECT_FALSE(power_surrogate({{1}, {2}, {3}}, {1, 2, 3}));
  EXPECT_FALSE(power_surrogate({{1}, {2}, {3}, {4}}, {0, 0, 3, 4})); // zeros do not count
}

TEST(GeometryScenes, CanBeBuiltAndFillTheRanges) {
  const auto own = window(0.3);
  GeometryOptions options;
  options.samples = 20;
  const auto scenes = geometry_scenes(own, options);
  ASSERT_EQ(scenes.size(), 20u);
  EXPECT_EQ(scenes[1].bearing, own.bearing);
  EXPECT_NEAR(scenes[0].excitation.speed, 0.1, 1e-12);
  EXPECT_NEAR(scenes[2].excitation.speed, 0.8, 1e-12);
  for (const auto &axis : geometry_axes()) {
    double low = 1e300, high = 0;
    for (const auto &s : scenes) {
      EXPECT_NO_THROW(s.validate());
      low = std::min(low, axis.get(s)), high = std::max(high, axis.get(s));
    }
    const double first = axis.absolute ? axis.low : axis.low * axis.get(own),
                 last = axis.absolute ? axis.high : axis.high * axis.get(own);
    EXPECT_GE(low, first * (1 - 1e-9)) << axis.name;
    EXPECT_LE(high, last * (1 + 1e-9)) << axis.name;
    EXPECT_GT(std::log(high / low), 0.7 * std::log(last / first)) << axis.name;
  }
  EXPECT_EQ(geometry_scenes(own, options)[7].bearing, scenes[7].bearing);
  options.ranges["rim_hight"] = {50, 70};
  EXPECT_THROW(geometry_scenes(own, options), InputError);
}

TEST(GeometryStudy, SaysWhetherTheRimSurvives) {
  const auto own = window(0.3);
  GeometryOptions options;
  options.samples = 24;
  std::vector<GeometryRow> rows;
  for (const auto &s : geometry_scenes(own, options)) {
    GeometryRow row{.name = s.name, .inputs = {}, .k_i = 1e5, .e = 0.4, .peak_force = 1e6, .plastic_strain = 0};
    for (const auto &axis : geometry_axes()) row.inputs.push_back(axis.get(s) / axis.si);
    row.plastic_strain = 0.5 * s.excitation.speed * std::sqrt(360e6 / *s.bearing.steel.yield);
    rows.push_back(row);
  }
  const auto study = geometry_study(rows, own, options); // 0.2 at 0.4 m/s
  EXPECT_NE(study.sentence.find("meets the limit 0.2 at 0.4 m/s"), std::string::npos) << study.sentence;
  EXPECT_EQ(to_json(study)["rows"].size(), 24u);
  EXPECT_NEAR(to_json(study)["surrogates"]["plastic_strain"]["inputs"]["yield_stress"]["exponent"].get<double>(), -0.5,
              1e-6);
  EXPECT_EQ(to_csv(study).substr(0, 15), "name,rim_height");
  rows.resize(4);
  EXPECT_NE(geometry_study(rows, own, options).sentence.find("too few"), std::string::npos);
}

/// e = 0.65 at 0.2 m/s over thickness / 40 mm, k_i = 4.5e5 (thickness / 40 mm)^2: the region is known.
TEST(GeometryStudy, KnowsWhichRimsReturnAWantedPair) {
  const auto own = window(0.3);
  GeometryOptions options;
  options.samples = 40;
  options.ranges["rim_thickness"] = {20, 80};
  std::vector<GeometryRow> rows;
  for (const auto &s : geometry_scenes(own, options)) {
    GeometryRow row{.name = s.name, .inputs = {}, .k_i = 0, .e = 0, .peak_force = 1e6, .plastic_strain = 0.1};
    for (const auto &axis : geometry_axes()) row.inputs.push_back(axis.get(s) / axis.si);
    const double thickness = s.bearing.rim.thickness / 0.04, error = rows.size() % 2 ? 1.05 : 1 / 1.05;
    row.e = 0.65 * std::sqrt(0.2 / thickness / s.excitation.speed), row.k_i = 4.5e5 * thickness * thickness * error;
    rows.push_back(row);
  }
  const auto region = pair_region(geometry_study(rows, own, options), {4.5e5, 0.65});
  ASSERT_TRUE(region);
  EXPECT_EQ(region->n_rims, 38u) << "the bearing's own stands there three times";
  EXPECT_GT(region->rims.size(), 33u);
  EXPECT_NEAR(region->k_i_error, 0.06, 0.02);
  int n_met = 0;
  for (const auto &rim : region->rims) {
    const double thickness = rim.inputs[1] / 40;
    EXPECT_NEAR(rim.inputs.back() * thickness, 0.2, 1e-6);
    EXPECT_NEAR(rim.k_i / (4.5e5 * thickness * thickness), 1, 0.03);
    EXPECT_EQ(rim.met, std::abs(rim.k_i / 4.5e5 - 1) <= region->k_i_error);
    n_met += rim.met;
  }
  EXPECT_GT(n_met, 0);
  EXPECT_LT(n_met, 10);
  EXPECT_EQ(to_json(*region)["n_met"], n_met);
  EXPECT_NE(region->sentence.find("of 38 rims"), std::string::npos) << region->sentence;
}

TEST(GeometryStudy, RefusesAPairThatIsNone) {
  EXPECT_THROW(pair_region({}, {0, 0.65}), InputError);
  EXPECT_THROW(pair_region({}, {4.5e5, 1}), InputError);
}

TEST(GeometryRow, IsTheFitOfItsWindow) {
  const auto row = geometry_row("g000", run_of(window(0.3)), 0.1);
  EXPECT_NEAR(row.k_i, 3e5, 1);
  EXPECT_NEAR(row.e, 0.4, 1e-5);
  EXPECT_DOUBLE_EQ(row.inputs.back(), 0.3);
}

} // namespace
} // namespace rimpact::calibration
