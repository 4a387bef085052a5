// Dents with a place: the law itself for straight impacts, flanks for oblique ones and for those beside a dent.
#include "reduced_models/bearings/dented_rim.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <cmath>
#include <gtest/gtest.h>
#include <optional>

namespace rimpact::reduced {
namespace {

using namespace laws;

using Eigen::Vector2d;

const DentShape shape{0.52, 0.12, 3};

RimElement yielding() {
  scene::ReducedSettings settings;
  settings.impact_law = &laws::impact_law("elastoplastic");
  settings.k_i = 0.986e9, settings.yield_force = 696.5e3, settings.hardening = 0.1563, settings.unloading_gain = 0.382;
  return settings.element(86952);
}

Vector2d at(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

TEST(DentedRim, AStraightImpactMeetsTheLawAsItStands) {
  const RimElement rim = yielding();
  for (const double angle : {0.0, 0.5, M_PI, -2.0}) {
    DentedRim dented;
    for (const double d : {1e-3, 3e-3, 5e-3, 4e-3, 1e-3}) dented.press(at(angle), d, shape);
    EXPECT_EQ(dented.dents().size(), 1u);
    for (const double d : {2e-3, 4.5e-3, 6e-3}) {
      const RimPush push = dented.push(rim, 0.4 * at(angle), {d, 0.1, 0.1}, shape);
      EXPECT_EQ(push.inwards, rim.at({d, 0.1, 0.1, 5e-3}).force);
      EXPECT_EQ(push.along, 0);
    }
  }
}

TEST(DentedRim, OnTheFlankItPushesHarderAndBackToTheDentsBottom) {
  const RimElement rim = yielding();
  DentedRim dented;
  dented.press(at(0), 7e-3, shape);
  double before = dented.push(rim, at(0), {6.5e-3, 0, 0}, shape).inwards;
  for (const double s : {0.01, 0.02, 0.04}) {
    const RimPush left = dented.push(rim, at(s / shape.wall), {6.5e-3, 0, 0}, shape),
                  right = dented.push(rim, at(-s / shape.wall), {6.5e-3, 0, 0}, shape);
    EXPECT_GT(left.inwards, before);
    EXPECT_NEAR(left.inwards, right.inwards, 1e-9 * left.inwards);
    EXPECT_LT(left.along, 0); // counter-clockwise of the dent: clockwise, back to it
    EXPECT_NEAR(left.along, -right.along, 1e-9 * left.inwards);
    before = left.inwards;
  }
  const double far = 2 * std::sqrt(2 * shape.flank() * 7e-3) / shape.wall; // touches apart: a fresh rim
  EXPECT_DOUBLE_EQ(dented.push(rim, at(far + 1e-6), {6.5e-3, 0, 0}, shape).inwards, rim.at({6.5e-3, 0, 0}).force);
}

TEST(DentedRim, SlidingWhilePressedLeavesAGrooveNoShallowerThanAnyDentInIt) {
  DentedRim dented;
  for (int k = 0; k <= 40; ++k) dented.press(at(1e-3 * k), 5e-3 - 1e-3 * std::pow((k - 20) / 20.0, 2), shape);
  for (int k = 0; k <= 40; ++k)
    EXPECT_GE(dented.deepest_at(at(1e-3 * k), shape), 5e-3 - 1e-3 * std::pow((k - 20) / 20.0, 2));
  EXPECT_LE(dented.deepest_at(at(0.02), shape), 5e-3 + 1e-12);
  EXPECT_LE(dented.dents().size(), 41u);
}

/// Thrown at the rim with 0.48 m/s across and `along` along it, without friction
/// (docs/decisions/0002-a-dent-has-a-place.md).
scene::Scene thrown(double along) {
  scene::Scene s;
  s.excitation.kind = scene::ExcitationKind::free;
  s.excitation.initial_displacement = {0.395, 0};
  s.excitation.initial_velocity = {0.48, along};
  s.excitation.duration = 0.12;
  s.load.vertical = 853e3, s.load.mass = 86952;
  s.reduced.impact_law = &laws::impact_law("elastoplastic");
  s.reduced.k_i = 0.986e9, s.reduced.yield_force = 696.5e3, s.reduced.hardening = 0.1563,
  s.reduced.unloading_gain = 0.382;
  s.reduced.mu_fast = s.reduced.mu_slow = 0;
  return s;
}

TEST(DentedRim, AnObliqueReboundGrowsWithTheSpeedAlongTheRimAsRungRimHasIt) {
  const struct {
    double along, out_over_in, along_after;
  } solid[] = {{0, 0.298, 0}, {0.25, 0.334, 0.2222}, {0.5, 0.393, 0.4453}, {0.75, 0.469, 0.6757}};
  for (const auto &fe : solid) {
    const auto run = simulate(thrown(fe.along));
    ASSERT_EQ(run.summary.impacts.size(), 1u);
    const auto &impact = run.summary.impacts[0];
    EXPECT_NEAR(impact.restitution(), fe.out_over_in, 0.05 * fe.out_over_in) << fe.along;
    const auto &t = run.response.series("time"), &x = run.response.series("displacement_x"),
               &y = run.response.series("displacement_y"), &vx = run.response.series("velocity_x"),
               &vy = run.response.series("velocity_y");
    std::size_t k = 0;
    while (t[k] < impact.release_time) ++k;
    EXPECT_NEAR((x[k] * vy[k] - y[k] * vx[k]) / std::hypot(x[k], y[k]), fe.along_after, 0.06 * fe.along + 1e-12)
        << fe.along;
    scene::Scene lumped = thrown(fe.along);
    lumped.reduced.dent_spread = 1e5; // a dent all round the rim: what the law alone says
    EXPECT_LE(simulate_summary(lumped).impacts.at(0).restitution(), 0.305);
  }
}

TEST(DentedRim, BothIntegratorsAgreeOnAnObliqueImpact) {
  const auto own = simulate(thrown(0.5)).summary.impacts.at(0),
             cvode = simulate_with_cvode(thrown(0.5)).summary.impacts.at(0);
  EXPECT_NEAR(own.peak_force, cvode.peak_force, 1e-6 * own.peak_force);
  EXPECT_NEAR(own.rebound_speed, cvode.rebound_speed, 1e-6 * own.rebound_speed);
}

/// Pressed along the wall by the path s(t), d(t), in so many steps.
DentedRim pressed_along(int n_steps, double from, double to) {
  const auto at_instant = [&](double t) {
    WallPoint p;
    const double place = from + (to - from) * t;
    p.direction = at(place / shape.wall), p.along_rate = to - from;
    p.d = 5e-3 * (1 - std::pow(2 * t - 1, 2)) + 1e-4, p.rate = -5e-3 * 4 * (2 * t - 1), p.acceleration = -5e-3 * 8;
    return p;
  };
  DentedRim rim;
  for (int k = 0; k < n_steps; ++k) {
    rim.begin_step(double(k) / n_steps, at_instant(double(k) / n_steps));
    rim.arrive(double(k + 1) / n_steps, at_instant(double(k + 1) / n_steps), shape);
  }
  return rim;
}

TEST(DentedRim, WhatAPathLeavesDoesNotDependOnItsSteps) {
  const DentedRim one = pressed_along(1, 0, 0.03), many = pressed_along(64, 0, 0.03), odd = pressed_along(7, 0, 0.03);
  const RimElement rim = yielding();
  for (double s = -0.06; s < 0.1; s += 0.004) {
    const Vector2d u = at(s / shape.wall);
    EXPECT_NEAR(one.deepest_at(u, shape), many.deepest_at(u, shape), 1e-12) << s;
    EXPECT_NEAR(odd.deepest_at(u, shape), many.deepest_at(u, shape), 1e-12) << s;
    const RimPush a = one.push(rim, u, {4e-3, 0, 0}, shape), b = many.push(rim, u, {4e-3, 0, 0}, shape);
    EXPECT_NEAR(a.inwards, b.inwards, 1e-9 * b.inwards + 1e-3) << s;
    EXPECT_NEAR(a.along, b.along, 1e-9 * b.inwards + 1e-3) << s;
  }
  // closed form: the largest of d(t) - (place - s(t))^2 / (2 r_f) over the path
  for (double s = 0; s < 0.03; s += 0.005) {
    double largest = 0;
    for (int i = 0; i <= 20000; ++i) {
      const double t = i / 20000.0;
      largest = std::max(largest,
                         5e-3 * (1 - std::pow(2 * t - 1, 2)) + 1e-4 - std::pow(s - 0.03 * t, 2) / (2 * shape.flank()));
    }
    EXPECT_NEAR(many.deepest_at(at(s / shape.wall), shape), largest, 1e-10) << s;
  }
}

TEST(DentedRim, ARidgeBetweenTwoDentsIsPressedFlat) {
  DentedRim rim;
  rim.press(at(0.03 / shape.wall), 5e-3, shape), rim.press(at(-0.03 / shape.wall), 5e-3, shape);
  const double ridge = rim.deepest_at(at(0), shape);
  ASSERT_LT(ridge, 4.5e-3);
  rim.press(at(0), 4.5e-3, shape);
  EXPECT_DOUBLE_EQ(rim.deepest_at(at(0), shape), 4.5e-3);
}

/// Three oblique impacts, the later ones beside earlier dents.
scene::Scene thrice(double turn_deg = 0, bool exchanged = false) {
  scene::Scene s;
  s.excitation.kind = scene::ExcitationKind::free;
  const double c = std::cos(turn_deg * M_PI / 180), n = std::sin(turn_deg * M_PI / 180);
  const auto turned = [&](double x, double y) {
    return exchanged ? Vector2d(y, x) : Vector2d(c * x - n * y, n * x + c * y);
  };
  s.excitation.initial_displacement = turned(0.39, 0), s.excitation.initial_velocity = turned(0.48, 1.17);
  s.excitation.duration = 1.2;
  s.reduced.impact_law = &laws::impact_law("elastoplastic");
  s.reduced.mu_fast = s.reduced.mu_slow = 0.01;
  return s;
}

TEST(DentedRim, ObliqueImpactsConvergeWithTheTolerance) {
  const auto rebounds = [](double tolerance) {
    scene::Scene s = thrice();
    s.reduced.tolerance = tolerance;
    std::vector<double> out;
    for (const auto &impact : simulate_summary(s).impacts) out.push_back(impact.rebound_speed);
    return out;
  };
  const auto exact = rebounds(1e-13), fine = rebounds(1e-11), usual = rebounds(1e-9), coarse = rebounds(1e-7);
  ASSERT_GE(exact.size(), 2u);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(fine[i], exact[i], 1e-6) << i;
    EXPECT_NEAR(usual[i], exact[i], 1e-5) << i;
    EXPECT_NEAR(coarse[i], exact[i], 3e-3) << i;
  }
}

TEST(DentedRim, NoDirectionIsPreferred) {
  const auto of = [](scene::Scene s) {
    s.reduced.tolerance = 1e-12; // the second impact differs by up to 2e-8 at 1e-11, by 3e-10 here
    return simulate_summary(s).impacts;
  };
  const auto given = of(thrice()), exchanged = of(thrice(0, true)), turned = of(thrice(37));
  ASSERT_EQ(exchanged.size(), given.size());
  ASSERT_EQ(turned.size(), given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_NEAR(exchanged[i].rebound_speed, given[i].rebound_speed, 1e-8) << i;
    EXPECT_NEAR(turned[i].rebound_speed, given[i].rebound_speed, 1e-8) << i;
    EXPECT_NEAR(turned[i].peak_force, given[i].peak_force, 1e-8 * given[i].peak_force) << i;
  }
}

TEST(DentedRim, ASecondImpactBesideTheDentStandsOnItsFlank) {
  const auto second =
      [](std::optional<double> dent) { // its restitution, 0.3 m/s along x, by the earlier dent's direction
        scene::Scene s = thrown(0);
        s.excitation.initial_displacement = {0.4, 0}, s.excitation.initial_velocity = {0.3, 0};
        s.reduced.tolerance = 1e-11; // mirrored they differ by what the integrator leaves: 4e-7 at 1e-9, 3e-10 here
        BearingState start = PhysicalModel(s).initial_state();
        if (dent) start.rim.press(at(*dent), 7e-3, shape);
        return simulate_from(s, start, 0.2).summary.impacts.at(0).restitution();
      };
  const double fresh = second({});
  EXPECT_GT(second(0), 1.2 * fresh); // in the dent, until it deepens it
  EXPECT_LT(second(0.03), second(0));
  EXPECT_LT(second(0.06), second(0.03));
  EXPECT_NEAR(second(0.06), second(-0.06), 1e-8);
  EXPECT_NEAR(second(0.4), fresh, 1e-9); // touches apart
}

} // namespace
} // namespace rimpact::reduced
