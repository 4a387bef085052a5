// The ledger closes to 1e-6 of the input, for every law and for the hard cases.
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

namespace {

struct Case {
  std::string name;
  std::function<void(scene::Scene &)> change;
};

std::vector<Case> cases() {
  return {
      {"uplift", [](auto &) {}},
      {"nearly_plastic", [](auto &s) { s.reduced.restitution = 0.05; }},
      {"elastic", [](auto &s) { s.reduced.restitution = 1; }},
      {"frictionless", [](auto &s) { set_friction(s, 0); }},
      {"rough", [](auto &s) { set_friction(s, 0.3); }},
      {"bouncing", [](auto &s) { s.reduced.vertical_restitution = 0.6; }},
      {"no_tension", [](auto &s) { s.reduced.impact_law = &laws::impact_law("no-tension"); }},
      {"printed", [](auto &s) { s.reduced.impact_law = &laws::impact_law("printed"); }},
      {"hunt_crossley", [](auto &s) { s.reduced.impact_law = &laws::impact_law("hunt-crossley"); }},
      {"elastoplastic", [](auto &s) { s.reduced.impact_law = &laws::impact_law("elastoplastic"); }},
      {"static_normal", [](auto &s) { s.reduced.normal_force = scene::NormalForce::statics; }},
      {"constant_normal", [](auto &s) { s.reduced.normal_force = scene::NormalForce::constant; }},
      {"velocity_law", [](auto &s) { s.reduced.mu_slow = 0.03, s.reduced.rate = 20; }},
      {"pad_and_socket", [](auto &s) { s.reduced.finite_pad = s.reduced.socket_friction = true; }},
      {"park_wen", [](auto &s) { s.reduced.friction = scene::Friction::park_wen; }},
      {"oblique", [](auto &s) { s.excitation.direction_deg = 37; }},
      {"no_rim", [](auto &s) { s.reduced.k_i = 0, s.excitation.scale = 0.9; }},
  };
}

class Ledger : public ::testing::TestWithParam<Case> {};

TEST_P(Ledger, Closes) {
  scene::Scene s = ricker(1.4, 12);
  GetParam().change(s);
  const auto run = simulate(s);
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
  EXPECT_GT(run.summary.energy->external, 0);
  // friction never gives, nor does a landing; and the ledger closes along the way, not only at the end
  const auto &r = run.response;
  const auto &friction = r.series("energy_friction"), &contact = r.series("energy_contact");
  for (std::size_t i = 1; i < r.size(); ++i) {
    if (s.reduced.friction == scene::Friction::coulomb) {
      ASSERT_GE(friction[i], friction[i - 1] - 1e-4);
    }
    ASSERT_GE(contact[i], contact[i - 1]);
    ASSERT_NEAR(r.series("energy_external")[i],
                r.series("energy_gravity")[i] + r.series("energy_kinetic")[i] + friction[i] +
                    r.series("energy_impact")[i] + contact[i],
                2e-6 * run.summary.energy->largest_input);
  }
}
INSTANTIATE_TEST_SUITE_P(Hard, Ledger, ::testing::ValuesIn(cases()), [](const auto &info) { return info.param.name; });

} // namespace

TEST(Ledger, RimDissipatesWhatRestitutionSays) {
  const auto summary = simulate_summary(window(0.3));
  const double kinetic = 0.5 * 86952 * 0.09;
  EXPECT_NEAR(summary.energy->initial, kinetic, 1e-9 * kinetic);
  EXPECT_NEAR(summary.energy->impact, (1 - 0.65 * 0.65) * kinetic, 1e-6 * kinetic);
}
