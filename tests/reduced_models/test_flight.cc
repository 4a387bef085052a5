// Flights without the rim element, and shots from a given state: what the finite elements and the calibration
// use.
#include "io/files/error.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

namespace {

double gap(const Eigen::Vector3d &u) {
  return 0.4 - std::hypot(u[0], u[1]);
}

} // namespace

TEST(Flight, StopsAtTheTouchOfTheWholeRun) {
  const scene::Scene s = ricker(1.05);
  const auto whole = simulate_summary(s).impacts.at(0);
  const PhysicalModel model(s);
  Response r;
  EnergyLedger ledger;
  const auto end = model.fly(model.initial_state(), 8, gap, r, ledger);
  ASSERT_TRUE(end.stopped);
  EXPECT_NEAR(end.state.t, whole.touch_time, 1e-10);
  EXPECT_NEAR(gap(end.state.u), 0, 1e-12);
  EXPECT_NEAR(std::abs(end.state.v[0]), whole.approach_speed, 1e-9);
  EXPECT_NEAR(ledger.external, ledger.kinetic + ledger.gravity + ledger.friction, 1e-6 * ledger.external);
  for (const double impact : r.series("impact_x")) ASSERT_EQ(impact, 0);
}

TEST(Flight, ContinuesFromAStateJustReleased) {
  const PhysicalModel model(ricker(1.05));
  Response r;
  EnergyLedger ledger;
  BearingState state = model.fly(model.initial_state(), 8, gap, r, ledger).state;
  const std::size_t stored = r.size();
  for (const double offset : {0.0, 1e-15, -1e-15, -1e-9}) { // on the rim to rounding, or still a nanometre inside it
    BearingState released = state;
    released.u[0] = -(0.4 - offset);
    released.u[2] = model.height(released.u[0], 0).z;
    released.v *= -0.6; // thrown back
    Response more = r;
    EnergyLedger l = ledger;
    const auto next = model.fly(released, 8, gap, more, l);
    EXPECT_FALSE(next.stopped) << offset;
    EXPECT_GT(more.size(), stored + 100);
    const auto &t = more.series("time");
    for (std::size_t i = 1; i < t.size(); ++i) ASSERT_LT(t[i - 1], t[i]);
  }
}

TEST(Flight, StopsAtOnceWhenStillMovingOutwards) {
  const PhysicalModel model(ricker(1.05));
  Response r;
  EnergyLedger ledger;
  const BearingState state = model.fly(model.initial_state(), 8, gap, r, ledger).state;
  const auto next = model.fly(state, 8, gap, r, ledger);
  EXPECT_TRUE(next.stopped);
  EXPECT_NEAR(next.state.t, state.t, 1e-9);
}

TEST(Flight, PiecesAddUpToTheWhole) {
  const scene::Scene s = ricker(0.9);
  const PhysicalModel model(s);
  Response r;
  EnergyLedger ledger;
  BearingState state = model.initial_state();
  for (const double t : {1.7, 2.05, 2.3, 8.0}) state = model.fly(state, t, {}, r, ledger).state;
  const auto whole = simulate(s);
  EXPECT_NEAR(state.u[0], whole.response.series("displacement_x").back(), 1e-7);
  EXPECT_NEAR(ledger.external, whole.summary.energy->external, 1e-6 * ledger.external);
  EXPECT_NEAR(ledger.friction, whole.summary.energy->friction, 1e-6 * ledger.external);
  EXPECT_LT(std::abs(ledger.imbalance_relative()), 1e-6);
}

TEST(Flight, AirborneFallIsAParabola) {
  scene::Scene s = free_motion({0, 0}, {0, 0});
  set_friction(s, 0);
  const PhysicalModel model(s);
  BearingState start;
  start.u = {0.1, 0, model.height(0.1, 0).z + 0.05};
  start.v = {-0.5, 0.2, 0};
  start.airborne = true;
  const double g = s.load.vertical / s.load.mass;
  Response r;
  EnergyLedger ledger;
  const auto end = model.fly(start, 0.09, {}, r, ledger);
  EXPECT_TRUE(end.state.airborne);
  EXPECT_NEAR(end.state.u[0], 0.1 - 0.5 * 0.09, 1e-10);
  EXPECT_NEAR(end.state.u[2], start.u[2] - g / 2 * 0.09 * 0.09, 1e-10);
  const auto landed = model.fly(end.state, 0.2, {}, r, ledger);
  EXPECT_FALSE(landed.state.airborne);
  EXPECT_NEAR(landed.state.u[2], model.height(landed.state.u[0], landed.state.u[1]).z, 1e-12);
  EXPECT_GT(ledger.contact, 0.9 * s.load.vertical * 0.05);
}

TEST(Flight, ARimIsNoHigherThanItStands) {
  const scene::Scene s = free_motion({0, 0}, {0, 0});
  const double over = lift_over_rim(s.bearing);
  // By hand: the rim's top, 60 mm over the dish's edge, less the slider's bottom at rest.
  EXPECT_NEAR(over, lift(s.bearing, s.bearing.surface.planar_radius) + 0.060 - 0.05825, 1e-12);
  BearingState start;
  start.airborne = true;
  start.v = {1, 0, 0};
  const double before = s.bearing.lateral_capacity() - 1e-4;
  for (const double above : {-1e-3, 1e-3}) {
    start.u = {before, 0, over + above};
    const auto run = simulate_from(s, start, 0.05);
    EXPECT_EQ(run.summary.status, above > 0 ? RunStatus::stopped : RunStatus::done) << run.summary.reason;
    EXPECT_EQ(run.summary.reason.find("thrown over the rim") != std::string::npos, above > 0) << run.summary.reason;
    EXPECT_GT(run.summary.n_steps, 0);
    EXPECT_EQ(run.summary.impacts.empty() || run.summary.impacts[0].peak_force == 0, above > 0);
  }
}

TEST(Shot, FromTouchRepeatsTheWholeRun) {
  const scene::Scene s = ricker(1.05);
  const PhysicalModel model(s);
  Response r;
  EnergyLedger ledger;
  const BearingState touch = model.fly(model.initial_state(), 8, gap, r, ledger).state;
  const auto whole = simulate_summary(s).impacts.at(0);
  const auto shot = simulate_from(s, touch, touch.t + 0.1);
  ASSERT_EQ(shot.summary.impacts.size(), 1u);
  const auto &impact = shot.summary.impacts[0];
  EXPECT_NEAR(impact.peak_force / whole.peak_force, 1, 1e-8);
  EXPECT_NEAR(impact.rebound_speed, whole.rebound_speed, 1e-8);
  EXPECT_NEAR(shot.response.series("time").front(), touch.t, 1e-12);
  EXPECT_NEAR(shot.response.series("time").back(), touch.t + 0.1, 1e-12);
}

TEST(Shot, CapacityOverrideMovesTheRim) {
  const scene::Scene s = ricker(1.05);
  BearingState start;
  start.t = 2.46;
  start.u = {-0.401, 0, 0};
  start.v = {-0.4, 0, 0};
  const auto dented = simulate_from(s, start, 2.6, 0.403);
  ASSERT_EQ(dented.summary.impacts.size(), 1u);
  EXPECT_GT(dented.summary.impacts[0].touch_time, 2.464);
  EXPECT_NEAR(dented.response.series("gap").front(), 0.002, 1e-12);
  const auto pressed = simulate_from(s, start, 2.6);
  EXPECT_DOUBLE_EQ(pressed.summary.impacts.at(0).touch_time, 2.46); // starts inside the rim
}
