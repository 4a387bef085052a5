// Bearings of rigid bodies under a building: against one bearing alone, and dishes by implicit steps against branches.
#include "buildings/regular_building.h"
#include "buildings/simulate.h"
#include "by_implicit_steps.h"
#include "io/files/error.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::buildings;

namespace {

scene::Scene pulse(double scale, scene::ModelKind model, double tolerance) {
  return scene::parse_scene(
      "[load]\nvertical_kN = 160.0\nmass_kg = 16309.888\n[excitation]\nkind = \"ricker\"\namplitude_g = 0.5\n"
      "period_s = 1.5\ncentre_s = 3.0\nduration_s = 5.0\nscale = " +
          std::to_string(scale) + "\n[isolator]\nspace = \"spatial\"\npoints = 4\nstep_tolerance = " +
          std::to_string(tolerance) + "\n[reduced]\nmodel = \"" + word(model) +
          "\"\nfriction = \"park-wen\"\nelastic_slip_mm = 1.0\nk_i_kN_per_m = 4e4\n",
      "test");
}

Frame block() {
  RegularBuilding b;
  b.x = {0, 8}, b.y = {0, 8};
  return make_frame(b);
}

} // namespace

TEST(Mounts, ARigidBlockOnFourAlikeIsOneBearing) {
  const auto s = pulse(1.0, scene::ModelKind::dcfp, 1e-4);
  const auto whole = simulate(block(), s);
  const auto one = reduced::simulate(s);
  ASSERT_EQ(whole.summary.status, RunStatus::done) << whole.summary.reason;
  EXPECT_GT(one.summary.peak_displacement, 0.1);
  EXPECT_NEAR(whole.summary.peak_displacement, one.summary.peak_displacement, 2e-3 * one.summary.peak_displacement);
  EXPECT_NEAR(whole.summary.peak_lateral_force / 4, one.summary.peak_lateral_force,
              0.01 * one.summary.peak_lateral_force);
}

TEST(Mounts, ADishByImplicitStepsIsTheOneByBranches) {
  const auto s = pulse(0.6, scene::ModelKind::physical, 1e-3);
  const Frame f = block();
  const auto branches = simulate(f, s);
  const Summary implicit = buildings::by_implicit_steps(assemble(f), s, 4);
  EXPECT_GT(branches.summary.peak_displacement, 0.05);
  EXPECT_NEAR(implicit.peak_displacement, branches.summary.peak_displacement,
              1e-3 * branches.summary.peak_displacement);
  EXPECT_NEAR(implicit.peak_lateral_force, branches.summary.peak_lateral_force,
              5e-3 * branches.summary.peak_lateral_force);
}

TEST(Mounts, WhereARimsFootGoesABuildingStops) {
  for (const auto friction : {scene::Friction::park_wen, scene::Friction::coulomb}) { // by branches, by implicit steps
    auto s = pulse(2.5, scene::ModelKind::physical, 1e-3);
    s.reduced.friction = friction;
    const auto whole = simulate(block(), s).summary;
    ASSERT_FALSE(whole.impacts.empty());
    ASSERT_EQ(whole.status, RunStatus::done);
    s.bearing.rim.connection.kind = scene::ConnectionKind::fillet;
    s.reduced.foot_joint = scene::strength_in_words(s.bearing.rim.connection);
    s.reduced.foot_force = 0.5 * whole.impacts[0].peak_force / 4;
    const auto broken = simulate(block(), s).summary;
    EXPECT_EQ(broken.status, RunStatus::stopped);
    EXPECT_NE(broken.reason.find("the rim breaks off its plate"), std::string::npos) << broken.reason;
    s.reduced.foot_force = 2 * whole.peak_impact_force.value();
    EXPECT_EQ(simulate(block(), s).summary.status, RunStatus::done);
  }
}

TEST(Mounts, KindsStandSideBySide) {
  Frame f = block();
  f.nodes[0].bearing = "lir-dcfp"; // the others have dishes
  const auto s = pulse(0.6, scene::ModelKind::physical, 1e-3);
  const auto bearings = std::vector<scene::Scene>{pulse(0.6, scene::ModelKind::lir_dcfp, 1e-3), s, s, s};
  const auto run = simulate(f, s, bearings);
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-2);
}

/// At rest aside, both dishes share the travel: the slider's load acts u / 2 from the top plate's axis (P-Delta), but
/// for what friction holds it aside; and the block's normal forces differ by what the moments ask for.
TEST(Mounts, ABearingAtRestAsideTurnsItsNodeByItsLoadOverHalfTheTravel) {
  auto s = pulse(1.0, scene::ModelKind::dcfp, 1e-4);
  s.excitation.kind = scene::ExcitationKind::free;
  s.excitation.initial_displacement = {0.06, 0};
  s.excitation.duration = 3;
  s.reduced.mu_slow = s.reduced.mu_fast = 0.2; // sticks
  const auto run = simulate(block(), s);
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  const auto last = [&](int bearing, const char *signal) {
    return run.response.series("bearing_" + std::to_string(bearing) + "_" + signal).back();
  };
  constexpr double weight = 10e3 * 8 * 8; // [N]
  double moments = 0, of_loads = 0, normals = 0;
  for (int bearing = 1; bearing <= 4; ++bearing) normals += last(bearing, "normal_force");
  for (int bearing = 1; bearing <= 4; ++bearing) {
    const double u = last(bearing, "displacement_x"), M = last(bearing, "moment_y"), x = bearing % 2 == 1 ? -4 : 4,
                 load = last(bearing, "normal_force") * weight / normals; // points at the edge press aslant
    EXPECT_GT(u, 0.05);
    EXPECT_NEAR(M, load * u / 2, 0.05 * load * u / 2) << bearing;
    moments += M, of_loads += x * load;
  }
  EXPECT_NEAR(moments, of_loads, 1e-3 * moments);
}

TEST(Mounts, RefuseAPlanarBearing) {
  auto s = pulse(1.0, scene::ModelKind::dcfp, 1e-4);
  s.isolator.space = scene::Space::planar;
  try {
    simulate(block(), s);
    FAIL() << "taken";
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("isolator.space"), std::string::npos);
  }
}

namespace {

/// Rims are struck: a block of 160 kN a bearing under the pulse of 0.78 g. Its supports are as good as rigid: with the
/// default ones normal forces ring during an impact, by 1 % of the lateral force. `own`: lines of [reduced].
scene::Scene struck(const std::string &own) {
  return scene::parse_scene(
      "[load]\nvertical_kN = 160.0\nmass_kg = 16309.888\n[excitation]\nkind = \"ricker\"\namplitude_g = 0.78\n"
      "period_s = 1.0\ncentre_s = 2.0\nduration_s = 5.0\nscale = 1.05\n[isolator]\nspace = \"spatial\"\npoints = 4\n"
      "contact_stiffness_kN_per_m = 1e9\nstep_tolerance = 3e-6\n[reduced]\nk_i_kN_per_m = 1e5\n" +
          own,
      "test");
}

/// Of the block on four dishes.
Summary by_implicit_steps(const scene::Scene &s) {
  return buildings::by_implicit_steps(assemble(block()), s, 4);
}

void expect_as_one(const Summary &whole, const Summary &one, double tolerance) {
  EXPECT_NEAR(whole.peak_displacement, one.peak_displacement, tolerance * one.peak_displacement);
  if (one.min_normal_force.value_or(0) > 0) { // else it lifts off: a landing is an impulse there, a force here
    EXPECT_NEAR(whole.peak_lateral_force, 4 * one.peak_lateral_force, 4 * tolerance * one.peak_lateral_force);
  }
  ASSERT_EQ(whole.impacts.size(), 4 * one.impacts.size());
  for (std::size_t i = 0; i < whole.impacts.size(); ++i) {
    const Impact &own = one.impacts[i / 4];
    EXPECT_NEAR(whole.impacts[i].touch_time, own.touch_time, 1e-4);
    EXPECT_NEAR(whole.impacts[i].peak_force, own.peak_force, tolerance * own.peak_force);
    EXPECT_NEAR(whole.impacts[i].peak_penetration, own.peak_penetration, tolerance * own.peak_penetration);
    EXPECT_NEAR(*whole.impacts[i].impulse, *own.impulse, tolerance * *own.impulse);
  }
  EXPECT_LT(std::abs(whole.energy->imbalance_relative()), 1e-5);
}

constexpr const char *park_wen = "friction = \"park-wen\"\nelastic_slip_mm = 0.5\n";

} // namespace

TEST(Mounts, AYieldingRimIsTheOneOfOneBearing) {
  for (const char *law : {"elastoplastic", "bilinear"}) {
    const auto s = struck(park_wen + std::string("impact_law = \"") + law + "\"\n");
    const auto one = reduced::simulate(s).summary;
    ASSERT_GE(one.impacts.size(), 1U) << law;
    expect_as_one(by_implicit_steps(s), one, 2e-3);
  }
}

/// Struck aslant, so that dents lie beside one another.
TEST(Mounts, AYieldingRimStruckAslantIsTheOneByBranches) {
  auto s = struck(park_wen + std::string("impact_law = \"elastoplastic\"\n"));
  s.excitation = scene::load_scene("pulse-bidirectional").excitation;
  const auto branches = simulate(block(), s).summary;
  const auto implicit = by_implicit_steps(s);
  ASSERT_GE(branches.impacts.size(), 4U);
  ASSERT_EQ(implicit.impacts.size(), branches.impacts.size());
  for (std::size_t i = 0; i < implicit.impacts.size(); ++i)
    EXPECT_NEAR(implicit.impacts[i].peak_force, branches.impacts[i].peak_force, 5e-3 * branches.impacts[i].peak_force);
  EXPECT_LT(std::abs(implicit.energy->imbalance_relative()), 1e-5);
}

TEST(Mounts, ASocketRubsAsByBranches) {
  const auto s = struck(park_wen + std::string("socket_friction = true\nmu_slow = 0.03\nrate_s_per_m = 20.0\n"));
  const auto plain = struck(park_wen + std::string("mu_slow = 0.03\nrate_s_per_m = 20.0\n"));
  const auto branches = simulate(block(), s).summary, without = simulate(block(), plain).summary;
  const auto implicit = by_implicit_steps(s);
  EXPECT_GT(std::abs(without.energy->friction / branches.energy->friction - 1), 0.01); // it matters
  EXPECT_NEAR(implicit.energy->friction, branches.energy->friction, 1e-3 * branches.energy->friction);
  EXPECT_NEAR(implicit.peak_lateral_force, branches.peak_lateral_force, 2e-3 * branches.peak_lateral_force);
  EXPECT_LT(std::abs(implicit.energy->imbalance_relative()), 1e-5);
}

TEST(Mounts, CoulombsFrictionUnderABuildingIsTheOneOfOneBearing) {
  // By pressure and temperature too: the pad carries 11 MPa.
  constexpr const char *measured =
      "mu_slow = 0.03\nrate_s_per_m = 20.0\nmu_reference_pressure_MPa = 5.0\nmu_by_temperature = true\n";
  for (const char *own : {"", "mu_slow = 0.03\nrate_s_per_m = 20.0\n", "impact_law = \"elastoplastic\"\n", measured}) {
    const auto s = struck(own);
    const auto whole = simulate(block(), s).summary;
    const auto one = reduced::simulate(s).summary;
    ASSERT_EQ(whole.status, RunStatus::done) << whole.reason;
    ASSERT_GE(one.impacts.size(), 1U);
    // Rounding moves the steps, and with them the impulse: below 0.2 % with one compiler, 0.22 % with another.
    expect_as_one(whole, one, 4e-3);
    EXPECT_NEAR(whole.residual_displacement, one.residual_displacement, 1e-3);
  }
}

/// Dishes whose rims yield, with sockets that rub, stand beside LIR-DCFP bearings; the plan is symmetric about both
/// axes.
TEST(Mounts, ASymmetricPlanStaysSymmetric) {
  for (const char *friction : {park_wen, "friction = \"coulomb\"\n"}) {
    RegularBuilding b;
    b.x = {0, 8, 16}, b.y = {0, 8}, b.storeys = {3.5};
    Frame f = make_frame(b);
    const auto s = struck(friction + std::string("impact_law = \"elastoplastic\"\nsocket_friction = true\n"));
    auto lir = s;
    lir.reduced.model = scene::ModelKind::lir_dcfp, lir.isolator.capacity = 0.6; // the dishes' rims hold the building
    f.nodes[1].bearing = f.nodes[4].bearing = "lir-dcfp";
    const auto run = simulate(f, s, {s, lir, s, s, lir, s}).summary;
    ASSERT_EQ(run.status, RunStatus::done) << run.reason;
    const auto &building = run.extra.at("building");
    EXPECT_LT(building.at("peak_base_rotation_rad").get<double>(), 1e-9);
    const auto force = [&](int b) { return building.at("bearings")[b].at("peak_impact_force_N").get<double>(); };
    EXPECT_GT(force(0), 1e5);
    EXPECT_NEAR(force(0), force(3), 1e-6 * force(0)); // across
    EXPECT_NEAR(force(2), force(5), 1e-6 * force(2));
    EXPECT_LT(std::abs(run.energy->imbalance_relative()), 1e-5);
  }
}
