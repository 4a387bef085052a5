#include "expect_error.h"
#include "responses/identity.h"
#include "responses/open_impact.h"
#include "responses/run_folder.h"
#include "responses/summary.h"
#include "scene/toml_writer.h"
#include "temporary_folder.h"
#include <cmath>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

constexpr double capacity = 0.4;

/// Two impacts: at 30 degrees (0.5 m/s in, 0.3 m/s out), then at -150 degrees (0.2 in, 0.2 out), 2 mm and 1
/// mm deep.
Response two_impacts(bool with_velocities = true) {
  Response r;
  const double angle[2] = {M_PI / 6, M_PI / 6 - M_PI}, in[2] = {0.5, 0.2}, out[2] = {0.3, 0.2}, force[2] = {2e6, 1e6};
  const double depth[2] = {0.002, 0.001};
  const auto add = [&](double t, double radius, double speed, int k, double f) {
    const double c = std::cos(angle[k]), s = std::sin(angle[k]);
    r.append("time", t);
    r.append("displacement_x", radius * c), r.append("displacement_y", radius * s), r.append("displacement_z", 0.04);
    if (with_velocities) r.append("velocity_x", speed * c), r.append("velocity_y", speed * s);
    r.append("impact_x", -f * c), r.append("impact_y", -f * s);
    r.append("force_x", -(f + 1e5) * c), r.append("force_y", -(f + 1e5) * s), r.append("force_z", 8e5);
    r.append("gap", capacity - radius);
    r.append("normal_force", 9e5 - f / 4);
  };
  for (int k = 0; k < 2; ++k) {
    const double t = 1.0 + k, dt = 0.001;
    add(t - dt, capacity - in[k] * dt, in[k], k, 0);
    add(t, capacity, in[k], k, 0.1 * force[k]);
    add(t + 0.02, capacity + depth[k], 0, k, force[k]);
    add(t + 0.04, capacity, -out[k], k, 0.01 * force[k]);
    add(t + 0.04 + dt, capacity - out[k] * dt, -out[k], k, 0);
  }
  return r;
}

void expect_both_impacts(const Summary &s) {
  ASSERT_EQ(s.impacts.size(), 2u);
  EXPECT_DOUBLE_EQ(s.impacts[0].touch_time, 1.0);
  EXPECT_NEAR(s.impacts[0].release_time, 1.04 + 0.02 / 99, 1e-12); // the force goes on falling as it did
  EXPECT_NEAR(s.impacts[0].direction_deg, 30, 1e-10);
  EXPECT_NEAR(s.impacts[1].direction_deg, -150, 1e-10);
  EXPECT_NEAR(s.impacts[0].approach_speed, 0.5, 1e-9);
  EXPECT_NEAR(s.impacts[0].rebound_speed, 0.3, 1e-9);
  EXPECT_NEAR(s.impacts[0].restitution(), 0.6, 1e-9);
  EXPECT_NEAR(s.impacts[1].restitution(), 1.0, 1e-9);
  EXPECT_NEAR(s.impacts[0].peak_penetration, 0.002, 1e-12);
  EXPECT_NEAR(s.impacts[1].peak_force, 1e6, 1e-6);
}

TEST(Summary, FindsImpactsOnAnySide) {
  Summary s;
  summarise_response(two_impacts(), s);
  expect_both_impacts(s);
  EXPECT_NEAR(s.peak_displacement, 0.402, 1e-12);
  EXPECT_NEAR(s.peak_lateral_force, 2.1e6, 1e-6);
  EXPECT_NEAR(*s.peak_impact_force, 2e6, 1e-6);
  EXPECT_NEAR(*s.min_normal_force, 4e5, 1e-6);
  EXPECT_NEAR(s.residual_displacement, 0.3998, 1e-12);
  EXPECT_DOUBLE_EQ(s.peak_vertical_displacement, 0.04);
  EXPECT_FALSE(s.max_plastic_strain);
}

TEST(Summary, DifferentiatesWhereVelocitiesAreNotStored) {
  Summary s;
  summarise_response(two_impacts(false), s);
  expect_both_impacts(s);
}

TEST(Summary, JsonHasTheContractsKeys) {
  Summary s;
  s.energy = EnergyLedger{};
  s.energy->external = 100, s.energy->kinetic = 60, s.energy->friction = 39, s.energy->largest_input = 200;
  s.extra["plan"] = 1;
  summarise_response(two_impacts(), s);
  const auto json = to_json(s);
  for (const char *key : {"peak_displacement_m",
                          "peak_lateral_force_N",
                          "peak_impact_force_N",
                          "n_impacts",
                          "impacts",
                          "residual_displacement_m",
                          "peak_vertical_displacement_m",
                          "min_normal_force_N",
                          "max_plastic_strain",
                          "energy",
                          "rung",
                          "mesh",
                          "n_dofs",
                          "n_steps",
                          "n_newton_iterations",
                          "time_split_s",
                          "wall_time_s",
                          "processor_time_s",
                          "peak_memory_bytes",
                          "status",
                          "plan"})
    EXPECT_TRUE(json.contains(key)) << key;
  for (const char *key : {"touch_time_s", "release_time_s", "direction_deg", "approach_speed_m_s", "rebound_speed_m_s",
                          "restitution", "peak_force_N", "peak_penetration_m"})
    EXPECT_TRUE(json["impacts"][0].contains(key)) << key;
  for (const char *key : {"external_J", "gravity_J", "kinetic_J", "elastic_J", "plastic_J", "friction_J", "impact_J",
                          "contact_J", "integrator_J", "imbalance_relative"})
    EXPECT_TRUE(json["energy"].contains(key)) << key;
  for (const char *key : {"search", "assembly", "factor", "solve", "output"})
    EXPECT_TRUE(json["time_split_s"].contains(key)) << key;
  EXPECT_EQ(json["n_impacts"], 2);
  EXPECT_TRUE(json["mesh"].is_null());
  EXPECT_TRUE(json["max_plastic_strain"].is_null());
  EXPECT_FALSE(json.contains("reason"));
  EXPECT_NEAR(json["energy"]["imbalance_relative"].get<double>(), 1.0 / 200, 1e-15);
  Summary stopped;
  stopped.status = RunStatus::stopped, stopped.reason = "no convergence";
  EXPECT_EQ(to_json(stopped)["reason"], "no convergence");
  EXPECT_TRUE(to_json(stopped)["energy"].is_null());
  EXPECT_TRUE(to_json(stopped)["peak_impact_force_N"].is_null());
}

TEST(Summary, AnImpactThatNeverEndedHasNoReleaseAndNoRebound) {
  Summary stopped;
  stopped.status = RunStatus::stopped, stopped.reason = "the slider left the dish";
  stopped.impacts = {{2.0, -1, 30, 0.5, 0, 1e6, 1e-3}, {0.0, 0.1, 30, 0.5, 0.25, 1e6, 1e-3}};
  const auto json = to_json(stopped)["impacts"];
  for (const char *key : {"release_time_s", "rebound_speed_m_s", "restitution"}) {
    EXPECT_TRUE(json[0][key].is_null()) << key;
    EXPECT_TRUE(json[1][key].is_number()) << key;
  }
  EXPECT_EQ(json[0]["peak_force_N"], 1e6);
}

/// Finite-element runs list an impact at its release; one that is interrupted before it has touched all the same.
TEST(Summary, ARunThatStopsWithTheRimPressedListsTheOpenImpact) {
  Response pressed = two_impacts();
  Summary whole;
  summarise_response(pressed, whole);
  const std::size_t n = whole.impacts.size();
  pressed.append("time", pressed.series("time").back() + 0.01);
  for (const auto &[name, values] : pressed.all())
    if (name != "time") pressed.append(name, name == "impact_x" ? -3e5 : values.back());
  Summary stopped;
  stopped.impacts = whole.impacts, stopped.status = RunStatus::interrupted;
  for (int k = 0; k < 2; ++k) { // a second time changes nothing
    leave_last_impact_open(pressed, stopped);
    ASSERT_EQ(stopped.impacts.size(), n + 1);
    const auto json = to_json(stopped)["impacts"];
    EXPECT_TRUE(json[n - 1]["release_time_s"].is_number());
    EXPECT_TRUE(json[n]["release_time_s"].is_null());
    EXPECT_TRUE(json[n]["rebound_speed_m_s"].is_null());
    EXPECT_EQ(json[n]["peak_force_N"], 3e5);
  }
  leave_last_impact_open(two_impacts(), whole);
  EXPECT_EQ(whole.impacts.size(), n) << "released before the run stopped";
  const TemporaryFolder folder;
  stopped.impacts.clear();
  write_run_folder(folder / "run", load_scene("impact-window"), pressed, stopped);
  EXPECT_TRUE(
      nlohmann::json::parse(text_of(folder / "run/summary.json"))["impacts"].back()["release_time_s"].is_null());
}

TEST(Ledger, TheRoundingOfARestIsNoDoubt) {
  EnergyLedger rest;
  rest.external = 1e-13, rest.friction = 2e-9;
  EXPECT_FALSE(doubt_of_ledger(rest));
  EnergyLedger real;
  real.external = 100, real.friction = 90;
  EXPECT_TRUE(doubt_of_ledger(real));
}

/// A bearing on its dish before the ground moves: it settles by a twentieth of a joule, and next to nothing is put in.
TEST(Ledger, ABearingThatOnlySettlesIsMeasuredByWhatItExchanges) {
  EnergyLedger e;
  e.external = e.largest_input = 1e-15;
  e.elastic = 0.0601, e.contact = -0.0476, e.friction = 0.0198, e.gravity = -0.0327, e.integrator = 4e-4;
  EXPECT_LT(std::abs(e.imbalance_relative()), 1e-3);
  e.elastic += 0.006;
  EXPECT_GT(std::abs(e.imbalance_relative()), 0.05);
}

TEST(Ledger, AWindowsKineticEnergyIsItsInput) {
  EnergyLedger e;
  e.initial = 50, e.kinetic = 30, e.plastic = 19;
  EXPECT_NEAR(e.imbalance_relative(), 1.0 / 50, 1e-15);
  EXPECT_EQ(EnergyLedger{}.imbalance_relative(), 0);
}

TEST(PeakMemory, GrowsWithUse) {
  const long before = peak_memory_bytes();
  EXPECT_GT(before, 1'000'000);
  const std::vector<char> block(static_cast<std::size_t>(before) + 50'000'000, 1);
  EXPECT_GT(peak_memory_bytes(), before + 20'000'000) << block.back();
}

TEST(RunFolder, HoldsEverythingAndRunsAgain) {
  const TemporaryFolder folder;
  const std::string run = folder / "a/b";
  const Scene scene = load_scene("ricker-0.38g-1.5s", {"excitation.scale=1.1"});
  Summary summary;
  summarise_response(two_impacts(), summary);
  write_run_folder(run, scene, two_impacts(), summary);
  EXPECT_EQ(to_toml(load_scene(run)), to_toml(scene)) << "a run folder is a scene";
  const Response back = read_response(run);
  EXPECT_EQ(back.meta.at("scene"), to_toml(scene));
  EXPECT_FALSE(back.meta.at("version").empty());
  EXPECT_FALSE(back.meta.at("git").empty());
  auto written = nlohmann::json::parse(text_of(run + "/summary.json"));
  EXPECT_EQ(written["identity"], to_json(identity_of(scene)));
  EXPECT_DOUBLE_EQ(written["lateral_capacity_m"].get<double>(), 0.4) << "L_c = r_p - b_s / 2 of shfps-225";
  written.erase("identity"), written.erase("lateral_capacity_m");
  EXPECT_EQ(written, to_json(summary));
  EXPECT_TRUE(std::filesystem::exists(run + "/response.csv"));
  write_run_folder(folder / "stopped", scene, Response{}, summary); // stopped before its first sample
  EXPECT_TRUE(std::filesystem::exists(folder / "stopped/summary.json"));
  expect_error<IoError>([&] { write_run_folder("/proc/x", scene, two_impacts(), summary); }, {"/proc/x"});
}

TEST(Ledger, ThatDoesNotCloseIsDoubtedAboveATenthOfAPercent) {
  EnergyLedger ledger;
  ledger.external = 1000, ledger.kinetic = 999.5;
  EXPECT_FALSE(doubt_of_ledger(ledger));
  for (const double kinetic : {998.5, 1001.5}) {
    ledger.kinetic = kinetic;
    const auto doubt = doubt_of_ledger(ledger);
    ASSERT_TRUE(doubt);
    EXPECT_NE(doubt->find(kinetic < 1000 ? "0.15 %" : "-0.15 %"), std::string::npos) << *doubt;
  }
  EXPECT_FALSE(doubt_of_ledger(EnergyLedger())); // nothing put in
}

TEST(Doubts, AStackThatLeavesItsDishIsSaidWhereItMayHaveLanded) {
  const auto response = [](std::vector<double> normal, bool stack, double step) {
    Response r;
    for (std::size_t k = 0; k < normal.size(); ++k) {
      r.append("time", step * static_cast<double>(k));
      r.append("normal_force", normal[k]);
      if (stack) r.append("pad_pressure_max", 60e6);
    }
    return r;
  };
  const auto doubt = doubt_of_bounce(response({8e5, 4e5, 0, 9e5}, true, 0.25));
  ASSERT_TRUE(doubt);
  EXPECT_NE(doubt->find("at t = 0.500 s"), std::string::npos) << *doubt;
  EXPECT_FALSE(doubt_of_bounce(response({8e5, 1e5, 9e5}, true, 0.25)));     // it stays on the dish
  EXPECT_FALSE(doubt_of_bounce(response({8e5, 4e5, 0, 0}, true, 0.01)));    // the response ends in flight
  EXPECT_FALSE(doubt_of_bounce(response({8e5, 4e5, 0, 9e5}, false, 0.25))); // a point lands by its own law
  EXPECT_FALSE(doubt_of_bounce(Response()));
  Response damped = response({8e5, 4e5, 0, 9e5}, true, 0.25);
  for (const double lost : {0, 0, 5, 9}) damped.append("energy_damping", lost);
  EXPECT_FALSE(doubt_of_bounce(damped)); // the pad loses what the bounce has
}

/// A hundred joules put in, one created by contact, a rebound that carries 25: its speed is 2 % too fast.
TEST(Doubts, EnergyFromContactIsSaidWithWhatItDoesToTheRebound) {
  EnergyLedger ledger;
  ledger.initial = ledger.largest_input = 100;
  ledger.contact = -1;
  Impact impact{};
  impact.rebound_speed = 5;
  const auto doubt = doubt_of_contact(ledger, {impact}, 2.0);
  ASSERT_TRUE(doubt);
  EXPECT_NE(doubt->find("given back 1.00 % more"), std::string::npos) << *doubt;
  EXPECT_NE(doubt->find("overstated by about 2.0 %"), std::string::npos) << *doubt;
  for (const double quiet : {-0.2, 0.0, 5.0}) { // little, nothing, or taken up by landings
    ledger.contact = quiet;
    EXPECT_FALSE(doubt_of_contact(ledger, {impact}, 2.0)) << quiet;
  }
  EXPECT_FALSE(doubt_of_contact({}, {}, 2.0));
}

} // namespace
