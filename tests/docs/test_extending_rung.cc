// The rung of docs/extending.md is solved by the engine as any other: pressed, it bears its load; dragged, it slides.
#include "extending_rung.h"
#include "fe_contact/solver/march.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

namespace {

/// The top dragged sideways to x [m] under a dead load [N].
fe::MarchReport drag(fe::BearingSystem &system, fe::SystemState &state, double x, double load) {
  fe::StepTerms terms{system.dead_load(load)};
  return fe::march(0, x, {.first = 1e-3 * x, .smallest = 1e-6 * x, .largest = 0.2 * x}, [&](double at, double step) {
    terms.driven = {{system.top().equation[0], at + step}, {system.top().equation[1], 0.0}};
    const auto report = fe::static_step(system, state, terms, blocks.steps);
    return fe::Attempt{report.converged, 0, report.reason};
  });
}

} // namespace

TEST(Extending, ARungIsAValue) {
  constexpr double load = 2e6, mu = 0.2; // [N], [-]
  const scene::Bearing bearing = scene::load_bearing("shfps-225");
  const fe::BearingModel model(blocks, bearing, {.half = false});
  fe::BearingSystem system(model, 0);
  EXPECT_NEAR(model.own_mass(), bearing.steel.density * 0.2 * 0.2 * 0.1, 1e-9 * model.own_mass());

  fe::SystemState state = system.at_rest();
  const auto pressed = fe::preload(system, state, system.dead_load(load), 1e8, blocks.steps);
  ASSERT_TRUE(pressed.converged) << pressed.reason;
  EXPECT_NEAR(system.force_of(state, fe::Role::dish).z(), load, 1e-6 * load);
  // Shorter by what a block alone shortens, and less than if the lower one had no more than its width.
  const double alone = load * 0.1 / (bearing.steel.E * 0.2 * 0.2);
  EXPECT_LT(system.top_of(state.u).z(), -alone);
  EXPECT_GT(system.top_of(state.u).z(), -2 * alone);

  const auto dragged = drag(system, state, 2e-3, load);
  ASSERT_TRUE(dragged.finished) << dragged.reason;
  EXPECT_NEAR(system.force_of(state, fe::Role::dish).x(), -mu * load, 1e-3 * mu * load);
  EXPECT_NEAR(system.force_of(state, fe::Role::dish).z(), load, 1e-6 * load);
}
