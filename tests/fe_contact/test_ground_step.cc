// A frame that rides on the ground: what nothing holds stays where it is, whatever the step.
#include "fe_contact/drive/ground_step.h"

#include "blocks.h"
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

/// Displacement of a free block on shaken ground, in the ground's frame, after `end` [m].
double left_behind(const scene::GroundMotion &ground, double end, double dt, bool rides) {
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, 0}, {0.4, 0.1, 0.1}, {2, 1, 1}, Volume::rim, {}});
  const Discretisation space(mesh, 2);
  const Solid solid(space, {{Volume::rim, scene::Material{block_modulus, 0.3, 1000, {}, {}}}});
  ContactSystem system(space, solid, Supports(space).number());
  SystemState state = system.at_rest();
  for (int k = 0; k * dt < end - 1e-9; ++k) {
    StepTerms terms{system.gravity(-ground.acceleration((k + 1) * dt))};
    terms.dt = dt;
    if (rides) terms.ground = ground_step(ground, k * dt, dt);
    const SystemState before = state;
    const ContactStepReport step = time_step(system, state, terms, {});
    EXPECT_TRUE(step.converged);
    const double work = 0.5 * (before.R + state.R).dot(state.u - before.u);
    EXPECT_NEAR(step.integrator_loss, work - system.kinetic_energy(state) + system.kinetic_energy(before), 1e-8);
  }
  const Eigen::VectorXd masses = system.gravity({1, 0, 0});
  return masses.dot(state.u) / masses.sum();
}

// Ricker's pulse, integrated twice: A T^2 / (2 pi^2) exp(-p^2), with the sign of its acceleration turned.
TEST(GroundStep, LeavesAFreeBlockWhereItIsInSpace) {
  const scene::Excitation pulse; // 0.78 g, 1 s, centred at 2 s
  const scene::GroundMotion ground(pulse, 9.81);
  constexpr double end = 2.2, dt = 0.02;
  const double p = M_PI * (end - pulse.centre) / pulse.period,
               moved = pulse.amplitude_g * 9.81 * pulse.period * pulse.period / (2 * M_PI * M_PI) * std::exp(-p * p);
  EXPECT_NEAR(left_behind(ground, end, dt, true), moved, 1e-6 * moved);
  const double sampled = std::abs(left_behind(ground, end, dt, false) - moved),
               half = std::abs(left_behind(ground, end, dt / 2, false) - moved);
  EXPECT_GT(sampled, 3e-4 * moved); // what sampling the shaking at the steps' ends would cost
  EXPECT_NEAR(sampled / half, 4, 0.5);
}

} // namespace
} // namespace rimpact::fe
