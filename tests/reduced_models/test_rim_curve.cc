// The law `curve`: against closed forms and against the law whose curve it is given.
#include "../scene/temporary_folder.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/bearings/curve_limits.h"
#include "reduced_models/bearings/rim_curve_file.h"
#include "reduced_models/record/run_doubts.h"
#include "reduced_models/simulate.h"
#include "scene/rim_identity.h"
#include "scenes.h"
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::laws;
using namespace rimpact::reduced::testing;

namespace {

/// Written for a scene's own bearing; gone with it.
struct CurveOf {
  std::string path;
  CurveOf(scene::Scene &scene, const CurvePath &dish, const CurvePath &held) {
    static int n = 0;
    path = (std::filesystem::temp_directory_path() /
            ("rim-curve-" + std::to_string(getpid()) + "-" + std::to_string(++n) + ".h5"))
               .string();
    write_rim_curve({.dish = dish,
                     .held = held,
                     .strain = {},
                     .foot = {},
                     .joint = {},
                     .bearing = scene.bearing.name,
                     .rim_identity = scene::rim_identity(scene.bearing),
                     .rim_values = scene::rim_values(scene.bearing),
                     .mesh = "made up",
                     .made_by = "test",
                     .errors = {0.01, 0.02}},
                    path);
    scene.reduced.impact_law = &laws::impact_law("curve"), scene.reduced.impact_curve = path;
  }
  ~CurveOf() { std::filesystem::remove(path); }
};

/// As pushed on an elastoplastic element, n samples a curve.
CurvePath pushed_on(const RimElement &rim, double range, int n, int branches) {
  CurvePath path{{{0}, {0}}, {}};
  for (int i = 1; i <= n; ++i) {
    const double d = range * i * i / (n * n);
    path.loading.penetration.push_back(d), path.loading.force.push_back(elastoplastic_backbone(rim, d).force);
  }
  for (int k = 1; k <= branches; ++k) {
    const double D = path.loading.penetration[n * k / branches];
    const Unloading back = unloading(rim, D);
    CurveSamples s;
    for (int j = 0; j <= n; ++j) {
      const double x = double(j) / n;
      s.penetration.push_back(std::max(0.0, D - x * back.length));
      s.force.push_back(j == n ? 0 : back.top * (1 - x) * (1 - back.curvature * x));
    }
    path.unloading.push_back(s);
  }
  return path;
}

std::string refusal(const std::function<void()> &act) {
  try {
    act();
  } catch (const Error &error) {
    return error.what();
  }
  return "nothing was thrown";
}

bool holds(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(RimCurve, LinearCurvesInClosedForm) {
  const double k = 4e8, k_back = 1.6e9;
  const RimCurve curve(linear_curve(k, k_back, 8e-3));
  for (const double d : {1e-4, 1.7e-3, 5e-3, 8e-3}) {
    EXPECT_NEAR(curve.loading(d).force, k * d, 1e-9 * k * d);
    EXPECT_NEAR(curve.work(d), k * d * d / 2, 1e-9 * k * d * d);
    EXPECT_NEAR(curve.depth_of(k * d * d / 2), d, 1e-12);
  }
  for (const double D : {2e-3, 5e-3, 8e-3}) { // at and between the pushed depths
    EXPECT_NEAR(curve.returned(D), k * k * D * D / (2 * k_back), 1e-9 * k * D * D) << D;
    EXPECT_NEAR(curve.residual(D), D * (1 - k / k_back), 1e-12) << D;
    const double d = D - 0.1 * D * k / k_back;
    EXPECT_NEAR(curve.unloading(d, D).force, 0.9 * k * D, 1e-9 * k * D) << D;
    EXPECT_LT(curve.unloading(curve.residual(D) - 1e-5, D).force, 0);
  }
  EXPECT_NEAR(curve.left_out_rebound(), 0, 1e-9);
}

TEST(RimCurve, ALinearRimReturnsTheRootOfItsStiffnesses) {
  scene::Scene s = window(0.3);
  const double k = 4e8, k_back = 1.6e9;
  const CurveOf file(s, linear_curve(k, 4 * k, 8e-3), linear_curve(k, k_back, 8e-3)); // a window is held
  for (const double v : {0.2, 0.4}) {
    s.excitation.speed = v;
    const auto impact = simulate_summary(s).impacts.at(0);
    EXPECT_NEAR(impact.peak_force / (v * std::sqrt(k * s.load.mass)), 1, 1e-6) << v;
    EXPECT_NEAR(impact.restitution(), std::sqrt(k / k_back), 1e-6) << v;
  }
}

TEST(RimCurve, FliesAsTheLawItWasSampledFrom) {
  scene::Scene s = window(0.5), own = s;
  own.reduced.impact_law = &laws::impact_law("elastoplastic");
  const CurvePath path = pushed_on(own.reduced.element(own.load.mass), 20e-3, 80, 40);
  const CurveOf file(s, path, path);
  for (const double v : {0.05, 0.1, 0.3, 0.5}) {
    s.excitation.speed = own.excitation.speed = v;
    const auto curve = simulate_summary(s).impacts.at(0), law = simulate_summary(own).impacts.at(0);
    EXPECT_NEAR(curve.peak_force / law.peak_force, 1, 1e-3) << v;
    EXPECT_NEAR(curve.rebound_speed / law.rebound_speed, 1, 3e-3) << v;
    EXPECT_NEAR(curve.peak_penetration / law.peak_penetration, 1, 1e-3) << v;
  }
}

TEST(RimCurve, TheSecondHitIntoTheSameDentGoesOnWhereTheFirstEnded) {
  scene::Scene s = window(0.5);
  const CurvePath path = linear_curve(4e8, 1.6e9, 10e-3);
  const CurveOf file(s, path, path);
  const double deepest = simulate_summary(s).impacts.at(0).peak_penetration;
  BearingState again = PhysicalModel(s).initial_state();
  again.v.x() = 0.05;
  again.rim.press({1, 0}, deepest, dent_shape(s));
  const auto second = simulate_from(s, again, 0.4);
  ASSERT_EQ(second.summary.status, RunStatus::done) << second.summary.reason;
  EXPECT_NEAR(second.summary.impacts.at(0).rebound_speed, 0.05, 1e-6);
}

TEST(RimCurve, SaysWhatItCannotDo) {
  scene::Scene s = window(0.3);
  const CurvePath path = linear_curve(4e8, 1.6e9, 8e-3);
  const CurveOf file(s, path, path);
  s.excitation.speed = 0.6; // 8 mm stop 0.543 m/s
  auto fast = simulate_summary(s);
  EXPECT_EQ(fast.status, RunStatus::stopped);
  EXPECT_TRUE(holds(fast.reason, "0.600 m/s exceeds the 0.543 m/s") && holds(fast.reason, "rung rim")) << fast.reason;
  s.excitation.speed = 0.3;
  BearingState at = PhysicalModel(s).initial_state();
  at.v = {0.3, 0.5, 0};
  const auto oblique = simulate_from(s, at, 0.2);
  EXPECT_EQ(oblique.summary.status, RunStatus::stopped);
  EXPECT_TRUE(holds(oblique.summary.reason, "oblique slide")) << oblique.summary.reason;
  at.v = {0.3, 0, 0};
  at.rim.press({std::cos(0.05), std::sin(0.05)}, 4e-3, dent_shape(s));
  const auto beside = simulate_from(s, at, 0.2);
  EXPECT_TRUE(holds(beside.summary.reason, "beside a dent")) << beside.summary.reason;
  const RimCurve curve(path);
  const auto lifted = beyond_curve(curve, {1e-3, 0, 8e4, true}, {}, {1, 0}, dent_shape(s));
  EXPECT_TRUE(lifted && holds(*lifted, "lifted off"));
  const auto deep = beyond_curve(curve, {9e-3, 0, 8e4, false}, {}, {1, 0}, dent_shape(s));
  EXPECT_TRUE(deep && holds(*deep, "9.000 mm, its curve ends at 8.000 mm"));
  EXPECT_FALSE(beyond_curve(curve, {7e-3, 0.05, 8e4, false}, {}, {1, 0}, dent_shape(s)));
  scene::Scene other = s;
  other.bearing.rim.thickness *= 1.5;
  const std::string foreign = refusal([&] { simulate(other); });
  EXPECT_TRUE(holds(foreign, "the curve is of the rim of shfps-225")) << foreign;
  EXPECT_TRUE(holds(foreign, "there and here rim.thickness_mm 40.0 and 60.0; make its own")) << foreign;
  other = s, other.reduced.impact_curve.clear();
  EXPECT_TRUE(holds(refusal([&] { other.validate(); }), "needs reduced.impact_curve"));
  EXPECT_TRUE(holds(refusal([&] { s.reduced.element(1e4); }), "physical only"));
}

TEST(RimCurve, ACoarseOneIsDoubtedWhereItIsFlown) {
  scene::Scene s = window(0.3);
  const CurvePath dish = linear_curve(4e8, 1.6e9, 8e-3), held = linear_curve(5e8, 1.6e9, 8e-3);
  const CurveOf good(s, dish, held);
  EXPECT_TRUE(doubts_of_curve(s).empty());
  RimCurveFile coarse = read_rim_curve(good.path);
  coarse.errors = {{}, 0.4};
  const TemporaryFolder folder;
  s.reduced.impact_curve = folder / "coarse.h5";
  write_rim_curve(coarse, s.reduced.impact_curve);
  auto run = simulate(s);
  add_doubts(s, run.response, run.summary);
  const std::string said = run.summary.extra["warnings"].dump();
  EXPECT_TRUE(holds(said, "nothing says how far the mesh of this rim curve is off")) << said;
  EXPECT_TRUE(holds(said, "off by up to 40 % of the rebound")) << said;
}

TEST(RimCurve, FilesComeBackAndDamagedOnesAreNamed) {
  scene::Scene s = window(0.3);
  const CurvePath dish = linear_curve(4e8, 1.6e9, 8e-3), held = linear_curve(5e8, 1.6e9, 8e-3);
  const CurveOf file(s, dish, held);
  const RimCurveFile back = read_rim_curve(file.path);
  EXPECT_EQ(back.dish.loading.force, dish.loading.force);
  EXPECT_EQ(back.held.unloading.at(2).penetration, held.unloading.at(2).penetration);
  EXPECT_EQ(back.errors.left_out_rebound, 0.02);
  RimCurveFile draft = back;
  draft.errors.mesh_force = {};
  const TemporaryFolder folder;
  write_rim_curve(draft, folder / "draft.h5");
  EXPECT_FALSE(read_rim_curve(folder / "draft.h5").errors.mesh_force);
  std::string bytes = read_file(file.path);
  write_atomically(bytes.substr(0, bytes.size() / 2), file.path);
  EXPECT_TRUE(holds(refusal([&] { read_rim_curve(file.path); }), file.path + ": is not a rim curve"));
  CurvePath falling = dish;
  falling.loading.penetration[3] = 0;
  EXPECT_TRUE(holds(refusal([&] { RimCurve{falling}; }), "it must rise"));
  CurvePath apart = dish;
  apart.unloading[1].force[0] *= 1.1;
  EXPECT_TRUE(holds(refusal([&] { RimCurve{apart}; }), "unloading 2 begins with"));
}
