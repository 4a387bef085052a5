// A liner's size in closed form, against its circles counted out, a mass flown into it, and the small stroke's limit.
#include "../scene/expect_error.h"
#include "calibration/studies/liner_answer.h"
#include "scene/scene.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace rimpact::calibration::liner_test { // its own names, whatever stands beside it
namespace {

constexpr double mass = 86952, speed = 0.6, slider = 0.12, wall = 0.52;
const LinerCase usual{.energy = mass * speed * speed / 2,
                      .most_force = 1.2e6,
                      .slider_radius = slider,
                      .wall_radius = wall,
                      .crush_share = 0.6};

/// The disc's area outside the ring, in strips across the line of centres.
double counted_area(double ring, double r, double depth) {
  const double x = ring - r + depth;
  constexpr int n = 200'000;
  double area = 0;
  for (int i = 0; i < n; ++i) {
    const double s = -r + 2 * r * (i + 0.5) / n, half = std::sqrt(r * r - s * s); // at x + s along the line of centres
    const double inner = std::abs(x + s) < ring ? std::sqrt(ring * ring - (x + s) * (x + s)) : 0;
    area += 2 * std::max(0.0, half - inner) * 2 * r / n;
  }
  return area;
}

/// A rim of which the wall gives way by 1 mm a MN, strained 0.02 a MN, its foot used to 0.5 a MN, pushed to 2 MN.
VaryPoint linear_rim() {
  VaryPoint rim{};
  rim.name = "thickness_mm-40";
  rim.at = {40}, rim.peak_force = 2e6;
  for (int i = 0; i <= 4; ++i) {
    const double meganewtons = 0.5 * i;
    rim.table.severity.push_back(i), rim.table.rebound.push_back(0);
    rim.table.peak_force.push_back(1e6 * meganewtons), rim.table.depth.push_back(1e-3 * meganewtons);
    rim.table.strain.push_back(0.02 * meganewtons), rim.table.foot_use.push_back(0.5 * meganewtons);
  }
  return rim;
}

VaryQuestion asked(double peak_kN) {
  return {.keys = {{"rim.thickness_mm", {30, 40}}},
          .speed = speed,
          .mass = mass,
          .strain_limit = 0.2,
          .targets = {{"peak_kN", peak_kN}}};
}

} // namespace

TEST(Liner, ItsAreaIsTheDiscOutsideTheRing) {
  for (const double depth : {0.004, 0.02, 0.06})
    EXPECT_NEAR(liner_area(0.48, slider, depth) / counted_area(0.48, slider, depth), 1, 1e-4) << depth;
  constexpr double step = 1e-6; // the chord is the area's slope
  EXPECT_NEAR((liner_area(0.48, slider, 0.03 + step) - liner_area(0.48, slider, 0.03 - step)) / (2 * step),
              liner_chord(0.48, slider, 0.03), 1e-6);
  EXPECT_NEAR(liner_chord(0.48, slider, liner_deepest(0.48, slider)), 2 * slider, 1e-9) << "the whole slider";
}

TEST(Liner, AMassIsStoppedAtTheForceWithinItsStroke) {
  const Liner liner = liner_for(usual);
  EXPECT_NEAR(liner.stroke / liner.thickness, usual.crush_share, 1e-12);
  const double ring = wall - liner.thickness, band = 0.03, sigma = liner.crush_stress(usual.most_force, band);
  double d = 0, v = speed, peak = 0;
  constexpr double dt = 2e-6;
  while (v > 0) { // midpoint rule: half the step, its force, the whole step
    const double force = sigma * band * liner_chord(ring, slider, std::max(d + v * dt / 2, 1e-12));
    peak = std::max(peak, force);
    d += dt * (v - force / mass * dt / 2), v -= force / mass * dt;
  }
  EXPECT_NEAR(d / liner.stroke, 1, 1e-4);
  EXPECT_NEAR(peak / usual.most_force, 1, 1e-4);
}

TEST(Liner, ASmallStrokeTakesTwoThirdsOfForceTimesStroke) {
  LinerCase stiff = usual;
  stiff.most_force = 1e9;
  const Liner liner = liner_for(stiff);
  EXPECT_NEAR(stiff.energy / (stiff.most_force * liner.stroke), 2.0 / 3, 1e-3);
  const double relative = 1 / (1 / slider - 1 / wall); // of a cylinder in a bore: w = 2 sqrt(2 R_eff D)
  EXPECT_NEAR(liner.chord / (2 * std::sqrt(2 * relative * liner.stroke)), 1, 2e-3);
}

TEST(Liner, RefusesWhatThereIsNoRoomForAndWhatIsNoNumber) {
  LinerCase soft = usual;
  soft.most_force = 1e5;
  expect_error<InputError>([&] { liner_for(soft); }, {"no liner stops 15.65 kJ at 100 kN", "travel of 400 mm"});
  for (double LinerCase::*bad :
       {&LinerCase::energy, &LinerCase::most_force, &LinerCase::slider_radius, &LinerCase::crush_share}) {
    LinerCase broken = usual;
    broken.*bad = std::nan("");
    EXPECT_THROW(liner_for(broken), InputError);
  }
  LinerCase wide = usual;
  wide.slider_radius = wall;
  expect_error<InputError>([&] { liner_for(wide); }, {"slider's radius 0.52", "below the wall's"});
}

TEST(LinerAnswer, HoldsTheWallAndItsFootAgainstTheForce) {
  const scene::Bearing bearing = scene::load_scene("impact-window").bearing;
  const auto behind = wall_behind(linear_rim(), 1.2e6);
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->depth, 1.2e-3, 1e-12);
  EXPECT_NEAR(*behind->strain, 0.024, 1e-12);
  EXPECT_NEAR(*behind->foot_use, 0.6, 1e-12);
  EXPECT_FALSE(wall_behind(linear_rim(), 2.1e6)) << "it was pushed to 2 MN";

  const auto answer = liner_answer(asked(1200), linear_rim(), bearing, 0.6);
  ASSERT_TRUE(answer.liner);
  EXPECT_TRUE(answer.works) << answer.sentence;
  EXPECT_NEAR(answer.crush_stress * answer.band * answer.liner->chord, 1.2e6, 1e-3);
  EXPECT_NEAR(answer.travel + answer.liner->thickness, bearing.lateral_capacity(), 1e-12);
  EXPECT_GT(answer.band, rim_top(bearing) - edge_at_touch(bearing)) << "the slider is lower where it meets the liner";
  for (const char *words :
       {"stays at or below 1200 kN", "60 % of it", "strained 0.024 (limit 0.2)", "used to 0.60", "Assumed"})
    EXPECT_NE(answer.sentence.find(words), std::string::npos) << words << ": " << answer.sentence;

  auto weak = linear_rim();
  for (double &use : weak.table.foot_use) use *= 2; // 1.2 at 1.2 MN
  const auto lost = liner_answer(asked(1200), weak, bearing, 0.6);
  EXPECT_FALSE(lost.works);
  EXPECT_NE(lost.sentence.find("it does not do"), std::string::npos) << lost.sentence;
  auto stiff = linear_rim();
  stiff.peak_force = 9e6;
  const auto hard = liner_answer(asked(8000), stiff, bearing, 0.6);
  EXPECT_FALSE(hard.works);
  EXPECT_NE(hard.sentence.find("none is softer than the rim"), std::string::npos) << hard.sentence;
  EXPECT_FALSE(liner_answer(asked(50), linear_rim(), bearing, 0.6).liner);
  const auto unneeded = liner_answer(asked(2000), linear_rim(), bearing, 0.6);
  EXPECT_FALSE(unneeded.liner);
  EXPECT_NE(unneeded.sentence.find("No liner is needed on the wall of rim.thickness_mm = 40, which bare stays at 2000"),
            std::string::npos)
      << unneeded.sentence;
  EXPECT_THROW(liner_answer(asked(1200), linear_rim(), bearing, 1.5), InputError);
  EXPECT_TRUE(to_json(lost, 0.6)["wall"]["rim_foot_use"].is_number());
}

} // namespace rimpact::calibration::liner_test
