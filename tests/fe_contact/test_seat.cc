// The pad by friction in the foot's recess: what bottom and wall carry when it is pressed and dragged.
#include "fe_contact/drive/top_drive.h"
#include "fe_contact/rungs/rigid_dish.h"
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

constexpr double load = 853e3; ///< [N]

scene::Bearing seated(double clearance = 0) {
  scene::Bearing bearing;
  bearing.contact.pad_foot = scene::PadFoot::frictional;
  bearing.contact.pad_clearance = clearance;
  return bearing;
}

/// A whole stack of the draft mesh's half, on its dish under the dead load.
struct PressedStack {
  explicit PressedStack(const scene::Bearing &bearing)
      : model(rungs::rigid_dish, bearing, {.level = 0}), system(model, 0, RimState::held), state(system.at_rest()),
        steps(rungs::rigid_dish.steps), weight(system.dead_load(load)) {
    steps.newton.tolerance = 1e-9;
    steps.newton.finest_forcing = 1e-6;
  }
  void press() {
    preload_on_dish(system, state, weight, steps);
    ASSERT_TRUE(TopDrive().move_to(system, state, {{0, 0}, {}}, weight, steps).converged); // without its springs
  }
  /// The top face goes to a place along x.
  void drag(double x) { ASSERT_TRUE(drive.move_to(system, state, {{x, 0}, {}}, weight, steps).converged) << x; }
  Eigen::Vector3d force(Role role) const { return system.force_of(state, role); }
  /// The forces on the pad; they balance.
  Eigen::Vector3d sum() const { return force(Role::dish) + force(Role::seat) + force(Role::recess); }
  BearingModel model;
  BearingSystem system;
  SystemState state;
  StepOptions steps;
  const Eigen::VectorXd weight;
  TopDrive drive;
};

TEST(Seat, APressedPadBearsTheLoadOnItsBack) {
  PressedStack stack(seated());
  stack.press();
  EXPECT_NEAR(stack.force(Role::dish).z(), load, 1e-6 * load);
  EXPECT_LT(stack.sum().norm(), 1e-6 * load);
  // The back bears what the wall's friction does not, and the pad swells against the wall.
  EXPECT_GT(-stack.force(Role::seat).z(), 0.9 * load);
  EXPECT_GT(stack.system.report_of(stack.state, Role::recess)->largest_pressure, 1e6);
  EXPECT_LT(std::abs(stack.force(Role::recess).x()), 1e-3 * load);
}

TEST(Seat, WithoutFrictionTheBackAloneBearsTheLoad) {
  scene::Bearing bearing = seated(0.001); // the wall out of reach
  PressedStack stack(bearing);
  for (const Role role : {Role::seat, Role::recess})
    stack.system.contact(*stack.system.contact_of(role)).law().friction = {};
  stack.press();
  EXPECT_NEAR(-stack.force(Role::seat).z(), load, 1e-6 * load);
  EXPECT_EQ(stack.force(Role::recess).norm(), 0);
  EXPECT_NEAR(stack.system.friction_of(stack.state, Role::seat).norm(), 0, 1e-9 * load);
}

TEST(Seat, ADraggedPadIsHeldByTheWallWhereFrictionDoesNotHoldIt) {
  for (const bool friction : {true, false}) {
    PressedStack stack(seated());
    if (!friction) stack.system.contact(*stack.system.contact_of(Role::seat)).law().friction = {};
    stack.press();
    for (int k = 1; k <= 6; ++k) stack.drag(0.5e-3 * k);
    const double dish = stack.force(Role::dish).x(), bottom = stack.force(Role::seat).x(),
                 wall = stack.force(Role::recess).x();
    EXPECT_NEAR(dish, -0.07 * load, 5e-3 * load); // and the dish's slope, and the moment of the socket
    EXPECT_LT(stack.sum().norm(), 1e-6 * load);
    EXPECT_NEAR(wall, -dish - bottom, 1e-6 * load);
    const double held = stack.system.friction_of(stack.state, Role::seat).norm();
    if (friction) {
      EXPECT_LE(held, 0.07 * stack.force(Role::seat).norm() * (1 + 1e-6));
      EXPECT_GT(bottom, 0.02 * load);
      EXPECT_GT(wall, 0.01 * load);
    } else { // the foot tilts a little under the drag, and its bottom with it
      EXPECT_NEAR(held, 0, 1e-9 * load);
      EXPECT_NEAR(bottom, 0, 1e-4 * load);
      EXPECT_NEAR(wall, -dish, 1e-4 * load);
    }
  }
}

} // namespace
} // namespace rimpact::fe
