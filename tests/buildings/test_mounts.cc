// Bearings of rigid bodies under a building: against one bearing alone, and dishes by implicit steps against branches.
#include "buildings/implicit_run.h"
#include "buildings/regular_building.h"
#include "buildings/simulate.h"
#include "files/error.h"
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
  const BuildingModel model = assemble(f);
  MountedBuilding building(model, s, std::vector<scene::Scene>(4, s), linear_structure(model, s.load.gravity));
  ImplicitRun run(building, s);
  BuildingRecorder recorder(building, nullptr, s.reduced.output_step);
  run.run(s.excitation.duration, recorder);
  Summary implicit;
  recorder.summarise(implicit);
  EXPECT_GT(branches.summary.peak_displacement, 0.05);
  EXPECT_NEAR(implicit.peak_displacement, branches.summary.peak_displacement,
              1e-3 * branches.summary.peak_displacement);
  EXPECT_NEAR(implicit.peak_lateral_force, branches.summary.peak_lateral_force,
              5e-3 * branches.summary.peak_lateral_force);
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
