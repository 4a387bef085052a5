// The joint at the rim's foot: its keys, what it bears, and what a run says of it.
#include "expect_error.h"
#include "responses/limits.h"
#include "scene/rim_identity.h"
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include <cmath>
#include <gtest/gtest.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

Bearing with_fillet(double throat) {
  Bearing bearing;
  bearing.rim.connection.kind = ConnectionKind::fillet;
  bearing.rim.connection.throat = throat;
  return bearing;
}

Bearing with_bolts() {
  Bearing bearing;
  auto &c = bearing.rim.connection;
  c.kind = ConnectionKind::bolts, c.number = 36, c.size = BoltSize::M16, c.grade = BoltGrade::g8_8;
  c.circle = 1.080; // the middle of the wall
  return bearing;
}

/// Printed stress areas of ISO 898-1 [mm^2].
TEST(RimConnection, StressAreasAreThoseOfTheStandard) {
  for (const auto &[size, area] : {std::pair{BoltSize::M8, 36.6},
                                   {BoltSize::M10, 58.0},
                                   {BoltSize::M12, 84.3},
                                   {BoltSize::M16, 157.0},
                                   {BoltSize::M20, 245.0},
                                   {BoltSize::M24, 353.0},
                                   {BoltSize::M27, 459.0},
                                   {BoltSize::M30, 561.0},
                                   {BoltSize::M36, 817.0}})
    EXPECT_NEAR(1e6 * stress_area(size), area, 0.003 * area) << word(size);
}

TEST(FootStrength, FilletsBearAMomentAsACouple) {
  Bearing bearing = with_fillet(0.010);
  bearing.rim.connection.strength = 510e6;
  // 2 fillets of 10 mm on a wall of 40 mm: 0.010 * 510e6 / (sqrt(3) 0.9 1.25) * 0.040 = 104.7 kN mm/mm.
  EXPECT_NEAR(*foot_use(bearing, {.moment = 104.69e3}), 1.0, 1e-3);
  const double strength = 0.010 * 510e6 / (std::sqrt(3.0) * 0.9 * 1.25);
  EXPECT_NEAR(*foot_use(bearing, {.normal = -2 * strength}), 1.0, 1e-12) << "nothing is pressed past the welds";
  EXPECT_NEAR(*foot_use(bearing, {.shear = 1.2 * strength, .along = 1.6 * strength}), 1.0, 1e-12);
  EXPECT_NEAR(*foot_use(bearing, {.normal = 0.6 * strength, .shear = 1.6 * strength, .moment = -0.012 * strength}),
              std::hypot(0.6, 0.8), 1e-12);
  EXPECT_FALSE(foot_use(Bearing{}, {.moment = 1e6}));
}

TEST(FootStrength, BoltsBearTensionAndShear) {
  const Bearing bearing = with_bolts();
  const double pitch = M_PI * 1.080 / 36, tension = 0.9 * 800e6 * stress_area(BoltSize::M16) / 1.25,
               shear = 0.6 * 800e6 * stress_area(BoltSize::M16) / 1.25;
  EXPECT_NEAR(*foot_use(bearing, {.moment = tension * 0.020 / pitch}), 1.0, 1e-12) << "about the outer edge";
  EXPECT_NEAR(*foot_use(bearing, {.moment = -tension * 0.020 / pitch}), 1.0, 1e-12);
  EXPECT_NEAR(*foot_use(bearing, {.shear = shear / pitch}), 1.0, 1e-12);
  EXPECT_NEAR(*foot_use(bearing, {.shear = 0.5 * shear / pitch, .moment = 0.5 * tension * 0.020 / pitch}),
              0.5 + 0.5 / 1.4, 1e-12);
  EXPECT_NEAR(*foot_use(bearing, {.normal = -1e9, .moment = 1e3}), 0, 1e-12) << "pressed on";
  EXPECT_NEAR(foot_reach(bearing), pitch, 1e-12);
}

TEST(RimConnection, IsReadWrittenAndNoPartOfTheForce) {
  const Bearing bearing = with_bolts();
  const std::string text = to_toml(bearing);
  EXPECT_NE(text.find("[rim.connection]\nkind = \"bolts\""), std::string::npos) << text;
  EXPECT_EQ(text.find("throat_mm"), std::string::npos);
  EXPECT_EQ(to_toml(Bearing{}).find("connection"), std::string::npos) << "described as ever";
  EXPECT_EQ(rim_identity(bearing), rim_identity(Bearing{}));
  EXPECT_EQ(bearing_identity(bearing), bearing_identity(Bearing{}));
  Bearing wide = bearing;
  wide.rim.connection.circle = 1.2;
  expect_error<InputError>([&] { wide.validate_rim(); },
                           {"rim.connection.circle_mm 1200 mm with bolts M16 leaves the wall"});
  Bearing many = bearing;
  many.rim.connection.number = 200;
  expect_error<InputError>([&] { many.validate_rim(); }, {"less than twice their diameter"});
  expect_error<InputError>([&] { with_fillet(0).validate_rim(); }, {"rim.connection.throat_mm 0 must be > 0"});
}

TEST(FootReport, TheWorstInstantIsToldAndJudged) {
  Scene scene;
  scene.bearing = with_fillet(0.010);
  Response response;
  for (int k = 0; k < 3; ++k) {
    const double use = k == 1 ? 1.5 : 0.2 * k;
    const std::pair<const char *, double> row[] = {{"time", 0.01 * k},
                                                   {"rim_foot_normal", 10. * k},
                                                   {"rim_foot_shear", 20. * k},
                                                   {"rim_foot_moment", 30. * k},
                                                   {"rim_foot_normal_per_length", 1},
                                                   {"rim_foot_shear_per_length", 2},
                                                   {"impact_x", 3e5 * k},
                                                   {"impact_y", 4e5 * k},
                                                   {"rim_foot_use", use},
                                                   {"rim_foot_moment_per_length", 3. * k},
                                                   {"rim_foot_weld_force", 1e6 * use}};
    for (const auto &[name, value] : row) response.append(name, value);
  }
  Summary s;
  s.foot = foot_report(response, scene.bearing);
  ASSERT_TRUE(s.foot);
  EXPECT_EQ(s.foot->time, 0.01);
  EXPECT_EQ(s.foot->moment, 30);
  EXPECT_NEAR(*s.foot->goes_at_force, 5e5 / 1.5, 1e-6) << "on a straight line to the instant at a use of 1.5";
  judge(scene, s);
  EXPECT_EQ(s.extra["rim_foot"]["exceeded"], true);
  EXPECT_NE(s.extra["warnings"][0].get<std::string>().find("two fillet welds with a throat of 10 mm, is used to 1.50"),
            std::string::npos);
  const auto back = foot_report_in({{"rim_foot", s.extra["rim_foot"]}}, "here");
  ASSERT_TRUE(back);
  EXPECT_EQ(*back->use, 1.5);
  EXPECT_EQ(*back->goes_at_force, *s.foot->goes_at_force);
  auto old = s.extra["rim_foot"];
  old.erase("goes_at_force_N");
  expect_error<DataError>(
      [&] {
        foot_report_in({{"rim_foot", old}}, "here");
      },
      {"here: the run is of an earlier version, which did not keep the force"});
  EXPECT_NEAR(back->needed_throat, 1.5e6 / weld_strength(scene.bearing.rim.connection), 1e-12);
  EXPECT_FALSE(foot_report_in({{"rim_foot", nullptr}}, "here"));
  expect_error<DataError>([] { foot_report_in({{"rim_foot", 3}}, "here"); }, {"here: \"rim_foot\" is not"});
  Scene whole;
  Summary piece;
  piece.foot = foot_report(response, whole.bearing);
  judge(whole, piece);
  EXPECT_TRUE(piece.extra["rim_foot"]["use"].is_null());
  EXPECT_FALSE(piece.foot->goes_at_force);
  EXPECT_FALSE(piece.extra.contains("warnings") && !piece.extra["warnings"].empty());
}

} // namespace
