// A building on bearings: against one bearing, rotated, side by side, let go, uplifting.
#include "buildings/bearing_doubts.h"
#include "buildings/regular_building.h"
#include "buildings/simulate.h"
#include "io/files/error.h"
#include "scene/bearing_catalogue.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::buildings;

namespace {

scene::Scene pulse(double scale, const std::string &more = "") {
  return scene::parse_scene(
      "[load]\nvertical_kN = 853.0\n[excitation]\nkind = \"ricker\"\namplitude_g = 0.78\nperiod_s = 1.0\n"
      "centre_s = 2.0\nduration_s = 4.0\nscale = " +
          std::to_string(scale) + "\n" + more +
          "[reduced]\nfriction = \"park-wen\"\nelastic_slip_mm = 1.0\ntolerance = 1e-11\n",
      "test");
}

Frame block(int nx, int ny, double load = 10e3) {
  RegularBuilding b;
  for (int i = 0; i < nx; ++i) b.x.push_back(8.0 * i);
  for (int j = 0; j < ny; ++j) b.y.push_back(8.0 * j);
  b.load = load;
  return make_frame(b);
}

} // namespace

TEST(BuildingRun, OfARigidBlockOnFourAlikeIsOneBearing) {
  const Frame f = block(2, 2);
  scene::Scene s = pulse(1.05);
  const auto whole = simulate(f, s);
  s.load.vertical = 64 * 10e3 / 4, s.load.mass = s.load.vertical / s.load.gravity;
  const auto one = reduced::simulate(s);
  ASSERT_EQ(whole.summary.status, RunStatus::done) << whole.summary.reason;
  ASSERT_EQ(one.summary.impacts.size() * 4, whole.summary.impacts.size());
  EXPECT_GT(one.summary.impacts.size(), 0u);
  EXPECT_NEAR(whole.response.series("displacement_x").back(), one.response.series("displacement_x").back(), 1e-8 * 0.4);
  EXPECT_NEAR(whole.summary.impacts[0].touch_time, one.summary.impacts[0].touch_time, 1e-8);
  EXPECT_NEAR(whole.summary.impacts[0].rebound_speed, one.summary.impacts[0].rebound_speed, 1e-7);
  EXPECT_LT(std::abs(whole.summary.energy->imbalance_relative()), 1e-7);
}

TEST(BuildingRun, OfTheThesisKeepsItsEnergy) {
  const auto run = simulate(make_frame(load_building("thesis-2.4")), pulse(1.05));
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-7);
  EXPECT_GT(run.summary.impacts.size(), 0u);
  EXPECT_LT(run.summary.extra["building"]["bearings"][2]["min_normal_force_N"].get<double>(),
            1e-9); // a corner is lifted off by the impact
}

TEST(BuildingRun, RotatedWithItsGroundRespondsRotated) {
  scene::Scene s = pulse(1.05);
  RegularBuilding b = load_building("thesis-2.4");
  b.eccentricity = {0.1, 0.05};
  Frame f = make_frame(b);
  const auto straight = simulate(f, s);
  const double a = 37 * std::acos(-1.0) / 180;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
  for (auto &node : f.nodes) node.at = R * node.at;
  for (auto &slab : f.diaphragms) slab.centre = R.topLeftCorner<2, 2>() * slab.centre;
  for (auto &e : f.elements) e.up = R * e.up;
  s.excitation.direction_deg = 37;
  const auto turned = simulate(f, s);
  ASSERT_EQ(turned.summary.impacts.size(), straight.summary.impacts.size());
  EXPECT_GT(straight.summary.extra["building"]["peak_base_rotation_rad"].get<double>(), 1e-5);
  EXPECT_NEAR(turned.summary.impacts[0].touch_time, straight.summary.impacts[0].touch_time, 1e-8);
  for (std::size_t i = 0; i < straight.summary.impacts.size(); ++i)
    EXPECT_NEAR(turned.summary.impacts[i].peak_force, straight.summary.impacts[i].peak_force,
                1e-4 * straight.summary.impacts[0].peak_force)
        << i;
}

TEST(BuildingRun, WithoutFrictionSwingsAsAPendulum) { // small amplitude: T = 2 pi sqrt(R0 / g)
  scene::Scene s = pulse(1);
  s.excitation.kind = scene::ExcitationKind::free;
  s.excitation.initial_displacement = {0.002, 0};
  s.reduced.mu_fast = s.reduced.mu_slow = 0;
  const auto run = simulate(block(2, 2), s);
  ASSERT_EQ(run.summary.status, RunStatus::done);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
  EXPECT_NEAR(run.summary.peak_displacement, 0.002, 1e-8);
}

TEST(BuildingRun, StopsWhereACornerIsThrownOverItsRim) {
  scene::Scene s = pulse(2);
  s.reduced.tolerance = 1e-6;
  const auto run = simulate(make_frame(load_building("thesis-2.4")), s);
  EXPECT_EQ(run.summary.status, RunStatus::stopped);
  EXPECT_GT(run.summary.n_steps, 0);
  EXPECT_NE(run.summary.reason.find("bearing 3: the slider is thrown over the rim"), std::string::npos)
      << run.summary.reason;
  EXPECT_LT(run.response.series("time").back(), s.excitation.duration);
}

TEST(BearingDoubts, AreOfTheWeightEachCarries) {
  const scene::Scene s = pulse(1);
  const double usual = scene::Load{}.vertical;
  EXPECT_TRUE(doubts_of_elements({s, s}, {usual, usual}).empty());
  const auto doubts = doubts_of_elements({s, s, s}, {usual, usual / 4, usual / 2});
  ASSERT_EQ(doubts.size(), 1u); // a sentence once
  EXPECT_EQ(doubts[0].find("bearing 2 (21738 kg): "), 0u) << doubts[0];
}

TEST(BearingDoubts, LookAtEachKindOfRigidBodies) {
  scene::Scene s = pulse(1);
  const double usual = scene::Load{}.vertical;
  s.reduced.model = scene::ModelKind::dcfp, s.reduced.fitted_plates.radius = s.isolator.radius;
  scene::Scene other = s;
  other.isolator.radius = 2;
  const auto doubts = doubts_of_elements({s, other, s}, {usual / 1.1, usual, 1.1 * usual});
  ASSERT_FALSE(doubts.empty());
  EXPECT_EQ(doubts.back().find("bearing 2"), 0u) << doubts.back();
  EXPECT_NE(doubts.back().find("isolator.radius_m 2 (1.55 there)"), std::string::npos) << doubts.back();
}

TEST(BuildingRun, RefusesAStartBeyondTheRimOfOneOfItsBearings) {
  scene::Scene s = pulse(1);
  s.excitation.kind = scene::ExcitationKind::free;
  s.excitation.initial_displacement = {0.3, 0};
  std::vector<scene::Scene> bearings(4, s);
  bearings[2].bearing = scene::builtin_bearing("shfps-appendix-a");
  try {
    simulate(block(2, 2), s, bearings);
    ADD_FAILURE() << "accepted";
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("beyond the rim of bearing 3 at L_c = 0.095 m"), std::string::npos)
        << error.what();
  }
}

TEST(BuildingRun, RefusesWhatABuildingCannotHave) {
  const Frame f = block(2, 2);
  const auto said = [&](auto change) {
    scene::Scene s = pulse(1);
    change(s);
    try {
      simulate(f, s);
    } catch (const InputError &error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(said([](scene::Scene &s) { s.reduced.normal_force = scene::NormalForce::constant; }).find("inertia"),
            std::string::npos);
  EXPECT_NE(said([](scene::Scene &s) { s.excitation.kind = scene::ExcitationKind::window; }).find("window"),
            std::string::npos);
}
