// The exported bearing as the target program integrates it, against closed forms and the reduced model.
#include "answer_fixture.h"
#include "calibration/export/csi.h"
#include "calibration/export/opensees.h"
#include "calibration/export/self_check_text.h"
#include "reduced_models/bearings/physical_model.h"
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using testing::answer_fixture, testing::stored;

scene::Scene scene_with(scene::SurfaceKind kind) {
  scene::Scene scene;
  scene.bearing.surface.kind = kind;
  if (kind == scene::SurfaceKind::sphere) scene.bearing.surface.planar_radius = 0.5;
  return scene;
}

TEST(Rider, AnEllipsoidIsFoundAgain) {
  for (const Rider own : {Rider{0.5625, 0.25}, Rider{0.7, 0.6}, Rider{2.25, 1.0}}) {
    std::vector<double> travel, slope;
    for (int i = 0; i <= 30; ++i) travel.push_back(0.46 * i / 30), slope.push_back(own.slope(travel.back()));
    const Rider found = rider_of(travel, slope);
    EXPECT_NEAR(found.half_width / own.half_width, 1, 1e-4);
    EXPECT_NEAR(found.ratio / own.ratio, 1, 1e-4);
    const double h = 1e-5;
    EXPECT_NEAR(found.curvature(0.3), (found.slope(0.3 + h) - found.slope(0.3 - h)) / (2 * h), 1e-6);
  }
}

TEST(Rider, FrictionOfAStrokeIsKept) {
  // whatever grows with the slope goes against the rise; the work of a stroke to the rim is that of the coefficient
  const Rider rider{0.5625, 0.25};
  const auto per_reaction = [&](double r) { return 0.07 * (1 + rider.slope(r) * rider.slope(r)) + 0.02 * r; };
  const auto split = riding_friction(rider, 0.4, per_reaction);
  const auto both = [&](double r) { return split.slides + split.rises * rider.slope(r); };
  EXPECT_GT(split.rises, 0.02);
  EXPECT_NEAR(mean_to(0.4, both) / mean_to(0.4, per_reaction), 1, 1e-9);
  EXPECT_NEAR(both(0.4) / per_reaction(0.4), 1, 0.02);
  const auto falls = riding_friction(rider, 0.4, [](double r) { return 0.07 - 0.05 * r; });
  EXPECT_EQ(falls.rises, 0); // no friction can push on the way down
}

/// What the exported bearing has where the reduced model is the oracle: no rim, so that both stop by themselves.
double travel_of(const scene::Scene &scene, Slider slider) {
  const auto dish = dish_of(scene, scene.bearing.lateral_capacity());
  const FlownBearing bearing{.slider = slider,
                             .dish = &dish,
                             .mass = scene.load.mass,
                             .weight = scene.load.vertical,
                             .capacity = scene.bearing.lateral_capacity(),
                             .rim = {},
                             .stiffness = 1};
  return fly_bearing(bearing, {scene.excitation, scene.load.gravity}, scene.excitation.duration).largest_travel;
}

TEST(BearingFlight, RidesAsTheModelAndAFlatOneDoesNot) {
  // the slider's rise is all that differs without friction: 0.2 mm here, 4 mm of a slider that stays in its plane
  for (const auto kind : {scene::SurfaceKind::ellipse, scene::SurfaceKind::sphere}) {
    scene::Scene scene = scene_with(kind);
    scene.reduced.mu_slow = scene.reduced.mu_fast = 0, scene.reduced.k_i = 0;
    scene.excitation.scale = 0.6, scene.excitation.duration = 5;
    const double model = reduced::simulate_summary(scene).peak_displacement;
    ASSERT_LT(model, 0.39);
    EXPECT_NEAR(travel_of(scene, Slider::rides), model, 2e-4) << word(kind);
    EXPECT_GT(std::abs(travel_of(scene, Slider::flat) - model), 1e-3) << word(kind);
  }
}

TEST(BearingFlight, FrictionActsAlongTheSlope) {
  scene::Scene scene = scene_with(scene::SurfaceKind::ellipse);
  scene.reduced.k_i = 0, scene.excitation.scale = 0.95, scene.excitation.duration = 5;
  for (const bool stack : {false, true}) {
    scene.reduced.finite_pad = scene.reduced.socket_friction = stack;
    scene.reduced.friction = stack ? scene::Friction::park_wen : scene::Friction::coulomb;
    scene.reduced.elastic_slip = 0.14e-3;
    const double model = reduced::simulate_summary(scene).peak_displacement;
    EXPECT_NEAR(travel_of(scene, Slider::rides), model, 1e-3) << stack;
  }
}

TEST(BearingFlight, AGroundThatRisesSteadilyIsMoreGravity) {
  const auto scene = scene_with(scene::SurfaceKind::sphere);
  const double capacity = scene.bearing.lateral_capacity(), g = scene.load.gravity, share = 0.5;
  const auto dish = dish_of(scene, capacity);
  scene::Excitation record;
  record.kind = scene::ExcitationKind::record, record.duration = 3;
  record.x.dt = record.z.dt = 1e-3;
  for (int i = 0; i <= 3000; ++i)
    record.x.values.push_back(2 * std::sin(4e-3 * i)), record.z.values.push_back(share * g);
  for (const auto slider : {Slider::flat, Slider::rides}) {
    FlownBearing bearing{.slider = slider,
                         .dish = &dish,
                         .mass = scene.load.mass,
                         .weight = scene.load.vertical,
                         .capacity = capacity,
                         .rim = {},
                         .stiffness = 1e8};
    const double risen = fly_bearing(bearing, {record, g}, record.duration).largest_travel;
    bearing.weight *= 1 + share;
    auto level = record;
    level.z.values.clear();
    const double heavy = fly_bearing(bearing, {level, g}, level.duration).largest_travel;
    ASSERT_GT(heavy, 0.05);
    EXPECT_NEAR(risen / heavy, 1, slider == Slider::flat ? 1e-4 : 5e-3); // the rider's table is of the dead load
  }
}

TEST(PulseCheck, TheRidingBearingArrivesAsTheModel) {
  const auto rim = exported_rim(stored(answer_fixture()), {});
  const auto springs = opensees_rim(rim);
  const auto links = csi_rim(rim);
  for (const auto kind : {scene::SurfaceKind::ellipse, scene::SurfaceKind::sphere}) {
    const auto scene = scene_with(kind);
    const auto dish = dish_of(scene, rim.lateral_capacity);
    const auto rides = pulse_check(scene, rim, flown_bearing(rim, springs, dish));
    const auto flat = pulse_check(scene, rim, flown_bearing(rim, links, dish));
    EXPECT_EQ(rides.rows.size() + rides.left_out.size(), 8u);
    EXPECT_FALSE(rides.refuses()) << word(kind);
    EXPECT_GT(flat.worst(), 2 * rides.worst()) << word(kind);
    for (const auto &row : rides.rows) {
      if (row.model.touch_speed < 3 * rim.from) continue; // a slower touch moves with anything
      EXPECT_NEAR(row.exported.touch_speed / row.model.touch_speed, 1, 0.06) << row.scale;
      EXPECT_LT(row.difference(rides.least_force), 0.06) << row.scale;
    }
  }
}

TEST(PulseCheck, ARowBeyondItsToleranceIsSaidWithBothNumbers) {
  const PulseRow harder{.pulse = "p", .scale = 1, .model = {0.164, 760e3, 0.401}, .exported = {0.3, 1078e3, 0.403}};
  PulseCheck check{.rows = {harder}, .left_out = {}, .least_force = 400e3, .slowest = 0.1};
  EXPECT_NEAR(check.worst(), 318.0 / 760, 1e-12);
  ASSERT_EQ(check.doubts().size(), 1u);
  for (const char *number : {"42 %", "0.300 m/s", "1078 kN", "0.164 m/s", "760 kN"})
    EXPECT_NE(check.doubts()[0].find(number), std::string::npos) << number;
  // what is refused is not in the file: no doubt of it
  check.written = false;
  EXPECT_TRUE(check.refuses());
  EXPECT_TRUE(check.doubts().empty());
  check.written = true;
  // a touch that hardly is one is judged over the law's least force, not over nothing
  check.rows = {{.pulse = "p", .scale = 1, .model = {0, 0, 0.3995}, .exported = {0.01, 30e3, 0.4001}}};
  EXPECT_NEAR(check.worst(), 0.075, 1e-12);
  EXPECT_TRUE(check.doubts().empty());
}

TEST(PulseCheck, WhatIsRefusedIsNoHairsBreadth) {
  const auto judged = [](Arrival model, Arrival exported) {
    return PulseCheck{.rows = {{"p", 1, model, exported}}, .left_out = {}, .least_force = 400e3, .slowest = 0.1}
        .worst_judged();
  };
  EXPECT_GT(judged({0.164, 760e3, 0.401}, {0.3, 1078e3, 0.403}), PulseCheck::refused); // a flat slider's
  EXPECT_GT(judged({0, 0, 0.399}, {0.3, 1078e3, 0.403}), PulseCheck::refused);
  EXPECT_EQ(judged({0.01, 50e3, 0.4}, {0.09, 390e3, 0.401}), 0); // slower than the law knows, in both
}

TEST(SelfCheck, SecondHitsMeetTheDent) {
  const auto rim = exported_rim(stored(answer_fixture()), {});
  for (const SelfCheck &check : {opensees_rim(rim).check, csi_rim(rim).check}) {
    ASSERT_TRUE(check.dents);
    for (const auto &row : check.rows) {
      EXPECT_LT(row.law_again.rebound, 1 + 1e-6);
      EXPECT_GT(row.law_again.rebound, row.law.rebound); // the dent gives back more
      EXPECT_GT(row.spring_again.rebound, row.spring.rebound);
    }
  }
  const auto springs = opensees_rim(rim).check;
  for (const auto &doubt : doubts_of(springs)) EXPECT_NE(doubt.find("kN"), std::string::npos) << doubt;
  EXPECT_EQ(doubts_of(springs).size(), std::size_t(springs.again() > 0.1) + std::size_t(springs.again_new() > 0.1));
  const auto lines = lines_of(springs);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [](const auto &line) { return line.find("rim_round, a new rim") != std::string::npos; }),
            5 + (springs.again_new() > 0.1));
}

TEST(Statement, ErrorsOfTheAnswerAreInTheHead) {
  auto calibration = answer_fixture();
  const auto has = [](const ExportedRim &rim, const std::string &needle) {
    return std::any_of(rim.statement.begin(), rim.statement.end(),
                       [&](const auto &line) { return line.find(needle) != std::string::npos; });
  };
  EXPECT_TRUE(has(exported_rim(stored(calibration), {}), "DOUBT: how far these numbers may be"));
  calibration["answer"]["error_sentences"] = {"Peak force: within about 28 % of the bearing's."};
  EXPECT_TRUE(has(exported_rim(stored(calibration), {}), "Error of the answer: Peak force: within about 28 %"));
  EXPECT_FALSE(has(exported_rim(stored(calibration), {}), "DOUBT: how far"));
}

TEST(TakeStack, TermsOfTheAnswerComeIntoTheDish) {
  auto calibration = answer_fixture();
  scene::Scene scene;
  take_stack(scene, *stored(calibration).answer);
  const auto bare = dish_of(scene, 0.4);
  EXPECT_TRUE(stack_effect(scene, exported_rim(stored(calibration), {})).empty());
  calibration["answer"]["stack"] = {{"finite_pad", true},
                                    {"socket_friction", true},
                                    {"friction", "park-wen"},
                                    {"elastic_slip_mm", 0.2},
                                    {"elastic_slip_from", "fit"}};
  take_stack(scene, *stored(calibration).answer);
  const auto dish = dish_of(scene, 0.4);
  EXPECT_NEAR(dish.elastic_slip, 1.25 * 0.2e-3, 1e-12);
  EXPECT_GT(dish.mu_fast, 1.03 * bare.mu_fast);             // the socket
  EXPECT_GT(dish.slope_at(0.4), 1.01 * bare.slope_at(0.4)); // the pad's size
  EXPECT_EQ(dish.stack.size(), 3u);
  EXPECT_EQ(stack_effect(scene, exported_rim(stored(calibration), {})).size(), 2u);
}

} // namespace
} // namespace rimpact::calibration
