// A slider that slides between two dishes: its force against the closed form, and how its middle plane moves.
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/run.h"
#include "fe_contact/drive/top_drive.h"
#include "fe_contact/planning/plan.h"
#include "fe_contact/rungs/middle_plane.h"
#include "fe_contact/rungs/rigid_dish.h"
#include "fe_contact/solver/march.h"
#include "reduced_models/simulate.h"
#include "scene/bearing_catalogue.h"
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

constexpr double W = 853e3; ///< dead load [N]

/// The draft mesh without its rim, at rest on the vertex.
struct Between {
  explicit Between(bool half)
      : model(rungs::rigid_dish, scene::builtin_bearing("dcfp-155"), {.level = 0, .half = half, .rim = false}),
        system(model, 0, RimState::held), state(system.at_rest()), weight(system.dead_load(W)) {
    preload_on_dish(system, state, weight, rungs::rigid_dish.steps);
  }
  /// What is carried goes to a place.
  void slide(const Eigen::Vector2d &u) {
    ASSERT_TRUE(drive.move_to(system, state, {u / model.rate_ratio, {}}, weight, rungs::rigid_dish.steps).converged);
  }
  Eigen::Vector3d force() const { return system.force_of(state, Role::dish); }
  BearingModel model;
  BearingSystem system;
  SystemState state;
  const Eigen::VectorXd weight;
  TopDrive drive;
};

/// F of W tan(theta + phi): the resultant passes through the slider's middle and leans by the friction angle, so that
/// sin phi = R sin(atan mu) / (R - H_s / 2), sin theta = u / (2 R - H_s).
double closed_form(const scene::Bearing &bearing, double u) {
  const double R = bearing.surface.R0, middle = R - bearing.slider.height / 2;
  return W * std::tan(std::asin(u / (2 * middle)) +
                      std::asin(R * std::sin(std::atan(bearing.contact.steel_ertalyte)) / middle));
}

TEST(TwoDishes, TheForceIsThatOfASliderInBalanceBetweenThem) {
  Between half(true);
  for (const double u : {0.001, 0.02, 0.04, 0.06, 0.08, 0.10}) half.slide({u, 0});
  EXPECT_NEAR(half.force().z(), W, 1e-4 * W); // steps have 1e-5 of all forces
  EXPECT_NEAR(-half.force().x(), closed_form(half.model.bearing, 0.10), 1e-4 * W);
}

TEST(TwoDishes, TheWholeSliderGoesAnyWayAsTheHalfGoesAlongX) {
  Between half(true), whole(false);
  const Eigen::Vector2d aslant(std::cos(0.7), std::sin(0.7));
  for (const double u : {0.001, 0.02}) {
    half.slide({u, 0});
    whole.slide(u * aslant);
  }
  EXPECT_NEAR(whole.force().head<2>().dot(aslant), half.force().x(), 2e-3 * half.force().head<2>().norm());
  EXPECT_NEAR(whole.force().x() * aslant.y() - whole.force().y() * aslant.x(), 0, 1e-4 * W);
}

/// The slider turns by theta; its middle plane's points move oddly about the middle, within what the ties give.
TEST(TwoDishes, TheMiddlePlaneTurnsOddlyAboutItsMiddle) {
  Between half(true);
  for (const double u : {0.001, 0.02, 0.04}) half.slide({u, 0});
  const Discretisation &space = half.model.space;
  const Eigen::VectorXd u = half.system.expand(half.state);
  const unsigned middle = middle_node(space);
  const double theta = std::asin(0.04 / (2 * 1.5));
  int pairs = 0;
  for (const unsigned a : space.nodes_of(meshes::Surface::top))
    for (const unsigned b : space.nodes_of(meshes::Surface::top)) {
      const Eigen::Vector3d &x = space.positions[a], &y = space.positions[b];
      if (x.x() <= 1e-3 || std::abs(x.x() + y.x()) > 1e-9 || std::abs(x.y() - y.y()) > 1e-9) continue;
      ++pairs;
      for (const int i : {0, 2}) {
        EXPECT_NEAR(u[3 * a + i] + u[3 * b + i], 2 * u[3 * middle + i], 2e-6);
      }
      EXPECT_NEAR((u[3 * a + 2] - u[3 * b + 2]) / (2 * x.x()), std::sin(theta), 2e-4) << x.transpose();
    }
  EXPECT_GT(pairs, 20);
}

/// Both rims hold the halves of an LIR-DCFP's slider: its interface slides at tan(theta + atan mu_s), and keeps its
/// slip on the way back.
TEST(TwoDishes, HalvesSlideOnOneAnotherWhereTheRimsHoldThem) {
  scene::Bearing bearing = scene::builtin_bearing("lir-dcfp-155");
  bearing.surface.planar_radius = 0.1705; // a short way out
  const double C = bearing.lateral_capacity();
  ASSERT_NEAR(C, 0.04, 1e-3);
  const BearingModel model(rungs::rigid_dish, bearing, {.level = 0, .half = true, .rim = true});
  BearingSystem system(model, 0, RimState::solid);
  SystemState state = system.at_rest();
  const Eigen::VectorXd weight = system.dead_load(W);
  preload_on_dish(system, state, weight, rungs::rigid_dish.steps);
  TopDrive drive;
  double at = 0;
  const auto slide = [&](double u) { // [m], in steps that are cut
    const double way = u - at;
    const auto go = [&](double s, double ds) {
      const Eigen::Vector2d goal((at + (s + ds) * way) / model.rate_ratio, 0);
      const auto report = drive.move_to(system, state, {goal, {}}, weight, rungs::rigid_dish.steps);
      return Attempt{report.converged, 0, report.reason};
    };
    const double longest = std::min(1.0, 0.02 / std::abs(way));
    const MarchReport report = march(0, 1, {std::min(longest, 5e-5 / std::abs(way)), 1e-6 * longest, longest, 5.0}, go);
    EXPECT_TRUE(report.finished) << u << ": " << report.reason;
    at = u;
  };
  slide(C - 5e-4);
  EXPECT_LT(system.interface_slip(state.u).norm(), 2e-5);
  EXPECT_FALSE(system.walls_touch(state));
  slide(C + 2e-3);
  const double theta = std::asin(C / 3.0), expected = W * std::tan(theta + std::atan(*bearing.slider.mu_interface));
  EXPECT_NEAR(-forces_of(system, state).total().x(), expected, 0.005 * expected);
  const Eigen::Vector3d slip = system.interface_slip(state.u);
  EXPECT_NEAR(slip.x(), 2e-3 - 0.3e-3, 0.2e-3);            // what the rims give way is theirs
  EXPECT_NEAR(slip.z() / slip.x(), std::tan(theta), 0.02); // along the tilted plane
}

/// Loads, masses and ways of what is carried and of the middle, in time: a pulse that stays on the dishes.
TEST(TwoDishes, APulseMovesItAsTheReducedModelDoes) {
  const scene::Scene scene =
      scene::load_scene("ricker-0.78g-1.0s", {"bearing.name=dcfp-155", "model.rung=\"rigid-dish\"", "model.mesh=0",
                                              "excitation.scale=0.4", "excitation.duration_s=2.0"});
  RunOptions options;
  options.writes = false;
  const Summary solid = run(scene, planning::make_plan(scene), options), law = reduced::simulate_summary(scene);
  EXPECT_NEAR(solid.peak_displacement, law.peak_displacement, 0.01 * law.peak_displacement);
  EXPECT_NEAR(solid.peak_lateral_force, law.peak_lateral_force, 0.01 * law.peak_lateral_force);
  EXPECT_LT(std::abs(solid.energy->imbalance_relative()), 1e-3);
}

TEST(TwoDishes, ItsPlansSpeakOfNoPad) {
  for (const std::string rung : {"rim", "rigid-dish", "full"}) {
    const planning::Plan plan = planning::make_plan(scene::load_scene(
        "ricker-0.78g-1.0s", {"bearing.name=dcfp-155", "excitation.scale=0.9", "model.rung=\"" + rung + "\""}));
    EXPECT_FALSE(plan.impacts.empty()) << rung;
    for (const std::string &note : plan.notes) EXPECT_EQ(note.find("pad"), std::string::npos) << rung << ": " << note;
  }
}

} // namespace
} // namespace rimpact::fe
