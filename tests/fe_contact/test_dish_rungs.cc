// Rung rigid-dish's plans, and the hand-over of a state when the rim joins and leaves.
#include "fe_contact/drive/rim_hand_over.h"
#include "fe_contact/engine/master_faces.h"
#include "fe_contact/planning/plan.h"
#include "fe_contact/planning/refusal.h"
#include "fe_contact/rungs/rigid_dish.h"
#include <algorithm>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

planning::Plan plan_of(const std::string &scene, std::vector<std::string> settings = {}) {
  settings.push_back("model.rung=\"rigid-dish\"");
  return planning::make_plan(scene::load_scene(scene, settings));
}

TEST(DishPlan, AWindowAlongXTakesTheHalfAndMeshesTheRimItMeets) {
  const std::vector<std::string> weight{"excitation.with=[\"weight\",\"friction\"]"};
  EXPECT_TRUE(plan_of("impact-window", weight).half);
  EXPECT_EQ(plan_of("impact-window", weight).sectors, std::vector<double>{0});
  const planning::Plan aslant = plan_of("impact-window", {weight[0], "excitation.direction_deg=30"});
  EXPECT_FALSE(aslant.half);
  ASSERT_EQ(aslant.sectors.size(), 1u);
  EXPECT_NEAR(aslant.sectors[0], M_PI / 6, 1e-12);
  EXPECT_EQ(aslant.impacts.size(), 1u);
}

TEST(DishPlan, APulseMeshesTheSideTheScoutTouchesAndTheOtherOnlyWhenItComesNear) {
  const planning::Plan plain = plan_of("ricker-0.78g-1.0s", {"excitation.scale=1.05"});
  ASSERT_FALSE(plain.impacts.empty());
  EXPECT_NEAR(std::cos(plain.sectors[0]), std::cos(plain.impacts[0].direction_deg * M_PI / 180), 1e-9);
  const planning::Plan turned = plan_of("ricker-0.78g-1.0s", {"excitation.scale=1.05", "excitation.direction_deg=180"});
  EXPECT_NEAR(std::abs(std::remainder(turned.sectors[0] - plain.sectors[0], 2 * M_PI)), M_PI, 1e-9);
  EXPECT_EQ(plan_of("ricker-0.78g-1.0s", {"excitation.scale=2.0"}).sectors.size(), 2u);
}

TEST(DishPlan, EveryDirectionOfABidirectionalPulseThatMayTouchIsMeshedOnce) {
  const planning::Plan plan = plan_of("pulse-bidirectional", {"excitation.scale=1.3"});
  ASSERT_EQ(plan.impacts.size(), 3u);
  ASSERT_EQ(plan.sectors.size(), 3u);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(std::remainder(plan.sectors[k] - plan.impacts[k].direction_deg * M_PI / 180, 2 * M_PI), 0, 1e-12);
  EXPECT_EQ(plan_of("pulse-bidirectional", {"excitation.scale=0.5"}).sectors.size(), 1u); // where it comes nearest
}

TEST(DishPlan, RestTakesLongStepsAndIsSaid) {
  const planning::Plan whole = plan_of("ricker-0.78g-1.0s", {"excitation.scale=1.05"}),
                       cut = plan_of("ricker-0.78g-1.0s", {"excitation.scale=1.05", "excitation.duration_s=3"});
  EXPECT_GT(whole.rests_from, 4);
  EXPECT_LT(whole.rests_from, 6);
  EXPECT_LT(whole.expected_steps - cut.expected_steps,
            (whole.rests_from - 3) / 0.008 + (8 - whole.rests_from) / 0.05 + 1);
  const auto said = [](const planning::Plan &plan) {
    return std::any_of(plan.notes.begin(), plan.notes.end(),
                       [](const auto &note) { return note.find("rests from") != std::string::npos; });
  };
  EXPECT_TRUE(said(whole));
  EXPECT_FALSE(said(cut));
}

TEST(DishPlan, APushMeshesTheRimWhereItGoes) {
  const planning::Plan along = plan_of("rim-push"), aslant = plan_of("rim-push", {"excitation.direction_deg=30"});
  EXPECT_TRUE(along.half && along.rim_takes_part);
  EXPECT_FALSE(along.moves_in_time);
  EXPECT_FALSE(aslant.half);
  ASSERT_EQ(aslant.sectors.size(), 1u);
  EXPECT_NEAR(aslant.sectors[0], M_PI / 6, 1e-12);
  const scene::Scene scene = scene::load_scene("rim-push", {"model.rung=\"full\""});
  const planning::Plan full = planning::make_plan(scene);
  EXPECT_EQ(full.sectors.size(), 1u);
  EXPECT_EQ(planning::refusal(scene), std::nullopt);
  const planning::Plan draft = plan_of("rim-push", {"model.mesh=0"}); // the draft mesh has its own costs
  EXPECT_LT(draft.expected_dofs, along.expected_dofs);
  EXPECT_LT(draft.expected_seconds, along.expected_seconds);
}

TEST(DishPlan, ExpectsTheUnknownsThatRunsHad) {
  const auto expected = [](const std::string &scale, const std::string &mesh) {
    return double(
        plan_of("pulse-bidirectional", {"excitation.scale=" + scale, "excitation.duration_s=4.2", "model.mesh=" + mesh})
            .expected_dofs);
  };
  EXPECT_NEAR(expected("1.0", "1"), 36624, 0.1 * 36624); // one side of the rim
  EXPECT_NEAR(expected("1.1", "1"), 58692, 0.1 * 58692); // both
  EXPECT_NEAR(expected("1.1", "0"), 28356, 0.1 * 28356);
}

TEST(DishPlan, RefusesWhatWouldFloatAndWhatItDoesNotHave) {
  const auto why = [](const std::string &scene, std::vector<std::string> settings = {}) {
    settings.push_back("model.rung=\"rigid-dish\"");
    return planning::refusal(scene::load_scene(scene, settings)).value_or("");
  };
  EXPECT_NE(why("impact-window").find("excitation.with"), std::string::npos);
  EXPECT_NE(why("impact-window", {"excitation.kind=\"free\"", "excitation.displacement_m=[0.39, 0]",
                                  "excitation.velocity_m_per_s=[0.5, 0]"})
                .find("'free'"),
            std::string::npos);
  EXPECT_EQ(why("rim-push"), "");
  EXPECT_EQ(why("ricker-0.38g-1.5s"), "");
}

class RimHandOver : public testing::Test {
protected:
  RimHandOver()
      : model_(rungs::rigid_dish, scene::Bearing{}, {.rim = true}), alone_(model_, 80e3, RimState::held),
        joined_(model_, 80e3, RimState::solid) {}
  /// Smooth and small, so that no cell turns inside out.
  static Eigen::VectorXd wave(int n, double size) {
    Eigen::VectorXd v(n);
    for (int i = 0; i < n; ++i) v[i] = size * std::sin(0.001 * i);
    return v;
  }
  BearingModel model_;
  BearingSystem alone_, joined_;
};

TEST_F(RimHandOver, TheRimIsHeldWithoutItsEquationsAndKeepsItsShape) {
  EXPECT_LT(alone_.equations().n, joined_.equations().n - 2000);
  SystemState together = joined_.at_rest();
  const Eigen::VectorXd u = wave(joined_.equations().n, 1e-6), v = wave(joined_.equations().n, 0.1);
  together.u = u;
  together.v = v;
  together.history[joined_.space().n_cells * 27 - 1].alpha = 0.02;
  together.energies = {50.0, 7.0};
  HeldRim held;
  const SystemState apart = parted_state(model_, joined_, together, alone_, held);
  // Energies split without loss, motion of the rim is gone.
  EXPECT_GT(held.energies.elastic, 0);
  EXPECT_DOUBLE_EQ(apart.energies.elastic + held.energies.elastic, 50.0);
  EXPECT_DOUBLE_EQ(apart.energies.plastic + held.energies.plastic, 7.0);
  EXPECT_LT(alone_.kinetic_energy(apart), joined_.kinetic_energy(together));
  EXPECT_EQ(alone_.top_of(apart.u), joined_.top_of(u));
  EXPECT_LT((alone_.expand(apart) + held.displacement - joined_.expand(together)).norm(), 1e-14 * u.norm());
  // And back: the same displacements everywhere, the rim at rest.
  const SystemState again = joined_state(alone_, apart, held, joined_);
  EXPECT_LT((again.u - u).norm(), 1e-14 * u.norm());
  EXPECT_DOUBLE_EQ(joined_.kinetic_energy(again), alone_.kinetic_energy(apart));
  EXPECT_EQ(again.history[joined_.space().n_cells * 27 - 1].alpha, 0.02);
  EXPECT_NEAR(again.energies.elastic, 50.0, 1e-12);
}

/// From its own face as a start and from none: a point that is not found would be out of contact, whatever it bears.
TEST(StackFaces, EveryPointOnSocketAndRimIsFound) {
  meshes::MeshOrder order{.half = false, .rim = true};
  for (order.level = 0; order.level < 2; ++order.level) {
    const BearingModel model(rungs::rigid_dish, scene::Bearing{}, order);
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(3 * model.space.n_nodes);
    for (const auto group : {meshes::Surface::socket, meshes::Surface::rim_wall}) {
      const MasterFaces faces(model.space, group);
      int lost = 0;
      for (std::size_t f = 0; f < model.space.faces_of(group).size(); ++f)
        for (double xi = -0.95; xi < 1; xi += 0.38)
          for (double eta = -0.95; eta < 1; eta += 0.38) {
            Eigen::Vector3d x = Eigen::Vector3d::Zero(), along[2] = {x, x};
            const FaceShapes shapes = face_shapes(model.space.degree, xi, eta);
            for (int a = 0; a < shapes.n; ++a) {
              const Eigen::Vector3d &node = model.space.positions[faces.face(f).nodes[a]];
              x += shapes.N[a] * node, along[0] += shapes.dxi[a] * node, along[1] += shapes.deta[a] * node;
            }
            x += 2e-4 * along[0].cross(along[1]).normalized();
            for (const int guess : {-1, static_cast<int>(f)})
              lost += faces.find(x, at_rest, guess, 0.0).face != static_cast<int>(f);
          }
      EXPECT_EQ(lost, 0) << "level " << order.level << ", group " << static_cast<int>(group);
    }
  }
}

TEST_F(RimHandOver, TheCarriedMassIsTheWholeOfIt) {
  SystemState state = alone_.at_rest();
  state.v.setZero();
  for (std::size_t dof = 0; dof < alone_.equations().of_dof.size(); dof += 3)
    if (const int equation = alone_.equations().of_dof[dof]; equation >= 0) state.v[equation] = 1.0;
  EXPECT_NEAR(2 * model_.share() * alone_.kinetic_energy(state), 80e3, 0.5);
  EXPECT_NEAR(model_.own_mass(), 35, 15);
}

} // namespace
} // namespace rimpact::fe
