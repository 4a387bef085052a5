// The triple pendulum, slowly: the five stages of Fenz and Constantinou (2008), whole loops, what its faces report.
#include "reduced_models/rigid_body/triple_parts.h"
#include "reduced_models/simulate.h"
#include "scene/isolator_catalogue.h"
#include "scenes.h"
#include "triple_loop.h"
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

using Column = const std::vector<double> &;

/// The tested specimen under 112 kN, its sliders as good as weightless, rims and contacts as good as rigid.
scene::Scene triple(const char *name = "tfp-fenz-2008") {
  scene::Scene s;
  s.reduced.model = scene::ModelKind::tfp, s.isolator = scene::builtin_isolator(name);
  s.load.vertical = 112e3, s.load.mass = 112e3 / 9.81;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.05;
  s.reduced.k_i = 1e9, s.isolator.contact_stiffness = 2e10;
  s.isolator.slider_mass = s.isolator.inner.mass = 0.01;
  return s;
}

/// Small turns: where the closed form of the paper holds.
scene::Scene flat() {
  scene::Scene s = triple();
  auto &b = s.isolator;
  b.radius = 2.0, b.bottom_height = b.top_height = 0.06, b.travel = 0.045, b.slider_diameter = 0.2;
  b.inner.radius = 0.3, b.inner.bottom_height = b.inner.top_height = 0.03, b.inner.travel = 0.03,
  b.inner.diameter = 0.1;
  b.inner.mu_fast = b.inner.mu_slow = 0.004, b.top_mu_fast = b.top_mu_slow = 0.02;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.012;
  return s;
}

FenzBackbone backbone(const scene::Scene &s) {
  const auto face = scene::triple_faces(s.isolator);
  FenzBackbone b;
  for (int i = 0; i < 4; ++i) {
    b.R[i] = face[i].effective_radius(), b.d[i] = face[i].travel * b.R[i] / face[i].radius;
  }
  b.f = {s.reduced.mu_fast, s.isolator.inner.mu_fast, s.isolator.inner.mu_fast, *s.isolator.top_mu_fast};
  return b;
}

struct Line {
  double slope, at_zero;
};
/// Least squares through the force of the first loading between two displacements.
Line line(const ReducedRun &run, double load, double from, double to) {
  Column u = run.response.series("displacement_x"), F = run.response.series("force_x");
  double n = 0, su = 0, sf = 0, suu = 0, suf = 0;
  for (std::size_t i = 0; i + 1 < u.size() && u[i + 1] >= u[i]; ++i) {
    if (u[i] < from || u[i] > to) continue;
    const double f = -F[i] / load;
    n += 1, su += u[i], sf += f, suu += u[i] * u[i], suf += u[i] * f;
  }
  const double slope = (n * suf - su * sf) / (n * suu - su * su);
  return {slope, (sf - slope * su) / n};
}

TEST(TripleBackbone, FiveStagesAreThoseOfFenzAndConstantinou) {
  const auto s = flat();
  const auto b = backbone(s);
  const double last = b.end(3) + 0.006;
  auto scene = cyclic(s, last, 1);
  const auto run = simulate(scene);
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  const double ends[] = {0, b.end(0), b.end(1), b.end(2), b.end(3), last};
  std::array<Line, 5> lines;
  for (int i = 0; i < 5; ++i) {
    const double width = ends[i + 1] - ends[i];
    ASSERT_GT(width, 0) << i;
    lines[i] = line(run, s.load.vertical, ends[i] + 0.25 * width, ends[i + 1] - 0.15 * width);
    EXPECT_NEAR(lines[i].slope / b.slope(i), 1, 0.005) << "stage " << i + 1;
  }
  for (int i = 0; i < 4; ++i) {
    const double u = (lines[i].at_zero - lines[i + 1].at_zero) / (lines[i + 1].slope - lines[i].slope);
    const double F = lines[i].at_zero + lines[i].slope * u;
    EXPECT_NEAR(u / b.end(i), 1, 0.005) << "end of stage " << i + 1;
    EXPECT_NEAR(F / b.force(i), 1, 0.005) << "end of stage " << i + 1;
  }
}

TEST(TripleBackbone, WholeLoopsFollowTheClosedFormAtFiniteTurns) {
  for (const char *name : {"tfp-fenz-2008", "tfp-kim-2023"}) {
    auto s = triple(name);
    if (name == std::string("tfp-kim-2023")) {
      s.load.vertical = 13345e3, s.load.mass = s.load.vertical / s.load.gravity;
      // As in the catalogue but for rigid rims: lighter sliders, or stiffer contacts, swing against an undamped rim in
      // steps of nanoseconds.
      const auto own = scene::builtin_isolator(name);
      s.isolator.contact_stiffness = own.contact_stiffness, s.isolator.slider_mass = own.slider_mass;
      s.isolator.inner.mass = own.inner.mass, s.reduced.k_i = 1e10, s.isolator.step_tolerance = 1e-3;
    }
    const auto scene = cyclic(s, 0.97 * s.lateral_capacity(), 1.25);
    const auto run = simulate(scene);
    ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
    TripleLoop loop(s.isolator, {s.reduced.mu_fast, s.isolator.inner.mu_fast, *s.isolator.top_mu_fast});
    Column u = run.response.series("displacement_x"), F = run.response.series("force_x");
    double largest = 0, apart = 0, since_turn = 0;
    for (std::size_t i = 1; i < u.size(); ++i) {
      const double expected = loop.move(u[i]);
      largest = std::max(largest, std::abs(expected));
      const bool turned = i > 1 && (u[i] - u[i - 1]) * (u[i - 1] - u[i - 2]) < 0;
      since_turn = turned ? 0 : since_turn + std::abs(u[i] - u[i - 1]);
      if (since_turn > 5e-4) apart = std::max(apart, std::abs(-F[i] / s.load.vertical - expected));
    }
    EXPECT_GT(largest, 0.15) << name;
    EXPECT_LT(apart, 0.005 * largest) << name;
    EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-3) << name;
  }
}

TEST(TripleBackbone, TheFacesTravelSumsToTheDisplacement) {
  auto s = triple();
  s.isolator.space = scene::Space::spatial, s.isolator.points = 8;
  const auto scene = cyclic(s, 0.12, 1);
  const auto run = simulate(scene);
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  Column u = run.response.series("displacement_x");
  for (std::size_t i = 0; i < u.size(); i += 10) {
    double sum = 0;
    for (int face = 1; face <= 4; ++face) sum += run.response.series("face_" + std::to_string(face) + "_travel_x")[i];
    ASSERT_NEAR(sum, u[i], 2e-4);
  }
  const auto &faces = run.summary.extra["isolator"]["faces"];
  const auto f = scene::triple_faces(s.isolator)[0];
  EXPECT_NEAR(faces[0]["peak_travel_m"], f.travel * f.effective_radius() / f.radius, 2e-4);
  EXPECT_GT(faces[0]["rim_peak_force_N"], 0);
  EXPECT_EQ(faces[1]["rim_peak_force_N"], 0);
}

/// Two points in the plane: a face's friction has the moment mu R N / cos(phi).
TEST(TripleBackbone, TheMomentOfTwoPointsIsOverTheirCosine) {
  const auto s = triple();
  for (const auto &face : scene::triple_faces(s.isolator))
    EXPECT_NEAR(moment_factor(s.isolator, face), 1 / std::cos(face.edge_angle()), 1e-12);
}

TEST(TripleBackbone, FrictionOfLoopsIsThatOfFacesByEquilibrium) {
  const auto s = triple();
  const auto face = scene::triple_faces(s.isolator);
  const FaceFriction mu = face_friction(s.isolator, {0.05, 0.02, 0.02, 0.10});
  std::array<double, 4> moment;
  for (int i = 0; i < 4; ++i) moment[i] = mu[i] * face[i].radius / std::cos(face[i].edge_angle());
  EXPECT_NEAR((moment[1] + moment[2]) / (0.053 + 0.053), 0.02, 1e-12);
  EXPECT_NEAR((moment[0] - moment[1]) / (0.435 - 0.053), 0.05, 1e-12);
  EXPECT_NEAR((moment[3] - moment[2]) / (0.435 - 0.053), 0.10, 1e-12);
}

} // namespace
} // namespace rimpact::reduced::testing
