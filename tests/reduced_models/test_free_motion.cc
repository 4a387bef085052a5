// Motion without ground acceleration against closed forms.
#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <algorithm>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

TEST(Pendulum, PeriodOfAnyAmplitude) {
  for (const double x0 : {1e-3, 0.4, 0.9}) {
    scene::Scene s = on_sphere(free_motion({x0, 0}, {0, 0}));
    set_friction(s, 0);
    s.reduced.k_i = 0;
    const PhysicalModel model(s);
    Response r;
    EnergyLedger ledger;
    const auto end = model.fly(
        model.initial_state(), 5, [](const Eigen::Vector3d &u) { return u[0]; }, r, ledger);
    ASSERT_TRUE(end.stopped);
    const double theta = std::asin(x0 / 2.25), g = s.load.vertical / s.load.mass;
    const double quarter = std::sqrt(2.25 / g) * std::comp_ellint_1(std::sin(theta / 2));
    EXPECT_NEAR(end.state.t, quarter, 1e-8 * quarter) << x0;
    EXPECT_NEAR(std::abs(end.state.v[0]), std::sqrt(2 * g * 2.25 * (1 - std::cos(theta))), 1e-8);
  }
}

TEST(Pendulum, CoulombDecay) {
  // On a sphere, sliding towards -theta: d(v^2)/dtheta - 2 mu v^2 = -2 g R (sin theta - mu cos theta), linear
  // in v^2. Each swing ends where v^2 vanishes; the motion ends where a swing cannot start.
  const double mu = 0.03, R = 2.25;
  scene::Scene s = on_sphere(free_motion({0.4, 0}, {0, 0}, 40));
  set_friction(s, mu);
  s.reduced.k_i = 0;
  const double g = s.load.vertical / s.load.mass;
  const auto particular = [&](double th) { // A sin + B cos
    const double A = 6 * g * R * mu / (1 + 4 * mu * mu), B = 2 * g * R * (1 - 2 * mu * mu) / (1 + 4 * mu * mu);
    return A * std::sin(th) + B * std::cos(th);
  };
  std::vector<double> turning{std::asin(0.4 / R)};
  while (std::tan(turning.back()) > mu) {
    const double start = turning.back();
    const auto v2 = [&](double th) { return particular(th) - particular(start) * std::exp(2 * mu * (th - start)); };
    double high = -1e-9, low = -start; // v^2 > 0 at the bottom unless it stops before
    if (v2(high) < 0) low = high, high = start - 1e-6;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (v2(middle) > 0 ? high : low) = middle;
    }
    turning.push_back(-high); // mirrored: each swing looks the same
  }
  s.reduced.output_step = 0.002;
  const auto run = simulate(s);
  EXPECT_NEAR(run.summary.residual_displacement, R * std::abs(std::sin(turning.back())), 1e-8);
  // the second turning point, from the samples
  const auto &u = run.response.series("displacement_x");
  EXPECT_NEAR(*std::min_element(u.begin(), u.end()), -R * std::sin(turning[1]), 2e-6);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
  EXPECT_EQ(run.summary.energy->kinetic, 0);
}

TEST(Stick, HoldsUpToTheFrictionAngle) {
  const Ellipse e;
  double low = 0.1, high = 0.2; // slope 0.07 lies between
  for (int i = 0; i < 100; ++i) (e.slope((low + high) / 2) < 0.07 ? low : high) = (low + high) / 2;
  for (const double angle : {0.0, 1.1, 4.0}) {
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    EXPECT_EQ(simulate_summary(free_motion((low - 1e-7) * direction, {0, 0}, 1)).energy->friction, 0);
    const auto slides = simulate_summary(free_motion((low + 1e-4) * direction, {0, 0}, 5));
    EXPECT_LT(slides.residual_displacement, low);
    EXPECT_GT(slides.energy->friction, 0);
  }
}

TEST(Stick, GroundAccelerationReleasesAtMuG) {
  // a record rising linearly from zero: at the vertex sliding starts when m a_g = mu (W + m a_gz)
  scene::Scene s;
  s.excitation.kind = scene::ExcitationKind::record;
  s.excitation.x.dt = s.excitation.z.dt = 0.1;
  for (int i = 0; i <= 20; ++i) s.excitation.x.values.push_back(0.1 * i), s.excitation.z.values.push_back(0.05 * i);
  s.excitation.duration = 2;
  s.reduced.output_step = 1e-3;
  const auto run = simulate(s);
  // 0.1 t/0.1 = a; mu (W/m + a/2) = a
  const double a = 0.07 * s.load.vertical / s.load.mass / (1 - 0.035);
  const auto &t = run.response.series("time"), &v = run.response.series("velocity_x");
  std::size_t first = 0;
  while (v[first] == 0) ++first;
  EXPECT_NEAR(t[first], a, 1.01e-3);
  EXPECT_GE(t[first], a);
  EXPECT_LT(v[first], 0); // pushed against the ground's acceleration
}

TEST(FreeMotion, FrictionlessOrbitKeepsEnergyAndAngularMomentum) {
  scene::Scene s = free_motion({0.3, 0.0}, {0.1, 0.8}, 10);
  set_friction(s, 0);
  s.reduced.k_i = 0;
  const auto run = simulate(s);
  const auto &r = run.response;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double L = r.series("displacement_x")[i] * r.series("velocity_y")[i] -
                     r.series("displacement_y")[i] * r.series("velocity_x")[i];
    ASSERT_NEAR(L, 0.24, 1e-8);
    ASSERT_NEAR(r.series("energy_kinetic")[i] + r.series("energy_gravity")[i], run.summary.energy->initial,
                1e-8 * run.summary.energy->initial);
  }
}

TEST(FreeMotion, TwoDimensionalStopIsFoundAndKept) {
  const auto run = simulate(free_motion({0.25, 0.05}, {-0.4, 0.9}, 20));
  EXPECT_EQ(run.summary.status, RunStatus::done);
  EXPECT_EQ(run.summary.energy->kinetic, 0);
  EXPECT_LT(run.summary.n_steps, 3000);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
}

TEST(Socket, StickLimitCountsTheSocket) {
  // along the meridian the limit is mu + mu_ss kappa_m times the socket's arm
  scene::Scene s = free_motion({0, 0}, {0, 0}, 1);
  s.reduced.socket_friction = true;
  const Ellipse e;
  double low = 0.1, high = 0.2;
  for (int i = 0; i < 100; ++i) {
    const double r = (low + high) / 2;
    (e.slope(r) < 0.07 + 0.1 * socket_arm(s.bearing) * e.meridional(r) ? low : high) = r;
  }
  s.excitation.initial_displacement = {0, low - 1e-6};
  EXPECT_EQ(simulate_summary(s).energy->friction, 0);
  s.excitation.initial_displacement = {0, low + 1e-4};
  EXPECT_GT(simulate_summary(s).energy->friction, 0);
}
