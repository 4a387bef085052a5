// Buildings on the physical model: against modal superposition, a single mass on a held base, and limits.
#include "../scene/expect_error.h"
#include "reduced_models/simulate.h"
#include "reduced_models/structures/superstructure.h"
#include "scene/toml_writer.h"
#include "scenes.h"
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

namespace {

scene::Superstructure frame(double post_yield = 0.05) {
  scene::Superstructure s;
  s.kind = scene::StructureKind::bouc_wen;
  s.mass_ratio = 0.7, s.period = 0.6, s.yield = 0.0186, s.post_yield = post_yield;
  return s;
}
scene::Superstructure shear_building() {
  scene::Superstructure s;
  s.kind = scene::StructureKind::shear_building;
  s.storeys = 3, s.masses = {25e3, 20e3, 15e3}, s.stiffnesses = {3e7, 2.5e7, 2e7};
  return s;
}
SampledSignal sine(double amplitude, double period, double duration) {
  SampledSignal signal{0.005, {}};
  for (double t = 0; t <= duration; t += signal.dt)
    signal.values.push_back(amplitude * std::sin(2 * std::numbers::pi * t / period));
  return signal;
}
/// x'' + 2 xi w x' + w^2 x = -a(t), from rest, by Runge-Kutta of order four: x and the absolute acceleration.
template <class Ground>
std::vector<std::array<double, 2>> single_mass(double w, double xi, const Ground &a, double dt, int n, int every) {
  std::array<double, 2> y{0, 0};
  std::vector<std::array<double, 2>> samples;
  const auto f = [&](double t, const std::array<double, 2> &s) {
    return std::array{s[1], -a(t) - 2 * xi * w * s[1] - w * w * s[0]};
  };
  for (int i = 0; i <= n; ++i) {
    if (i % every == 0) samples.push_back({y[0], -2 * xi * w * y[1] - w * w * y[0]});
    const double t = i * dt;
    const auto add = [&](const std::array<double, 2> &k, double h) {
      return std::array{y[0] + h * k[0], y[1] + h * k[1]};
    };
    const auto k1 = f(t, y), k2 = f(t + dt / 2, add(k1, dt / 2)), k3 = f(t + dt / 2, add(k2, dt / 2)),
               k4 = f(t + dt, add(k3, dt));
    for (int c = 0; c < 2; ++c) y[c] += dt / 6 * (k1[c] + 2 * k2[c] + 2 * k3[c] + k4[c]);
  }
  return samples;
}

} // namespace

// Small free motion on a frictionless sphere without dashpots: base and floors are a linear chain on the
// spring W / R (Kelly's model of an isolated building).
TEST(Superstructure, ModesOfALinearBuilding) {
  scene::Scene s = on_sphere(free_motion({1e-3, 0}, {0, 0}, 4));
  set_friction(s, 0);
  s.superstructure = shear_building();
  s.superstructure.damping_ratio = 0;
  const auto &b = s.superstructure;
  Eigen::Matrix4d K = Eigen::Matrix4d::Zero(), M = Eigen::Matrix4d::Zero();
  K(0, 0) = s.load.vertical / 2.25;
  M(0, 0) = s.load.mass - 60e3;
  for (int i = 0; i < 3; ++i) {
    M(i + 1, i + 1) = b.masses[i];
    K.block<2, 2>(i, i) += b.stiffnesses[i] * (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix4d> modes(K, M);
  const Eigen::Vector4d shares = modes.eigenvectors().transpose() * M * Eigen::Vector4d::Constant(1e-3);
  const auto run = simulate(s);
  const auto &time = run.response.series("time"), &u = run.response.series("displacement_x"),
             &drift = run.response.series("drift_x"), &roof = run.response.series("roof_x");
  for (std::size_t k = 0; k < time.size(); k += 7) {
    Eigen::Vector4d x = Eigen::Vector4d::Zero();
    for (int i = 0; i < 4; ++i)
      x += modes.eigenvectors().col(i) * shares[i] * std::cos(std::sqrt(modes.eigenvalues()[i]) * time[k]);
    EXPECT_NEAR(u[k], x[0], 2e-9);
    EXPECT_NEAR(drift[k], x[1] - x[0], 2e-9);
    EXPECT_NEAR(roof[k], x[3] - x[0], 2e-9);
  }
  EXPECT_EQ(run.summary.n_dofs, 12);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
}

// The first period asked for is the one the uniform building has: closed form of n equal masses and springs.
TEST(Superstructure, UniformBuildingHasItsPeriod) {
  scene::Scene s;
  s.superstructure.kind = scene::StructureKind::shear_building, s.superstructure.storeys = 5,
  s.superstructure.period = 0.5;
  const Superstructure b(s);
  const double w = 2 * std::sqrt(b.storeys[0].stiffness / b.storeys[0].mass) * std::sin(std::numbers::pi / 22);
  EXPECT_NEAR(2 * std::numbers::pi / w, 0.5, 1e-12);
  EXPECT_NEAR(b.mass(), 0.9 * s.load.mass, 1e-6);
  EXPECT_NEAR(b.storeys[4].damping, 2 * 0.02 / w * b.storeys[4].stiffness, 1e-6);
}

// A base that friction holds leaves a single mass on a spring.
TEST(Superstructure, HeldBase) {
  scene::Scene s = ricker(0.1);
  set_friction(s, 2);
  s.superstructure = frame(0.999999), s.superstructure.yield = 1e3; // elastic
  const auto run = simulate(s);
  const double w = 2 * std::numbers::pi / 0.6;
  const auto a = [&](double t) { return 0.078 * 9.81 * scene::ricker_shape(t, 2, 1); };
  const auto exact = single_mass(w, 0.02, a, 5e-4, 16000, 10);
  const auto &drift = run.response.series("drift_x"), &roof = run.response.series("roof_acceleration_x");
  ASSERT_EQ(drift.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(drift[i], exact[i][0], 1e-8);
    EXPECT_NEAR(roof[i], exact[i][1], 1e-6);
  }
  double peak = 0;
  for (const auto &sample : single_mass(w, 0.02, a, 5e-4, 16000, 1)) peak = std::max(peak, std::abs(sample[0]));
  EXPECT_NEAR(run.summary.extra["peak_drift_m"].get<double>(), peak, 1e-5 * peak);
  EXPECT_EQ(run.summary.peak_displacement, 0);
}

// Vertical ground motion on the flat middle: N = W + m_b a_z + what the axial spring hands down.
TEST(Superstructure, VerticalMotionReachesTheNormalForce) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::record;
  s.excitation.z = sine(2.0, 0.15, 3), s.excitation.duration = 3;
  s.superstructure = frame();
  const auto run = simulate(s);
  const double w = 2 * std::numbers::pi / 0.1, m_s = 0.7 * s.load.mass, m_b = 0.3 * s.load.mass;
  const auto exact = single_mass(
      w, 0.02, [&](double t) { return s.excitation.z.at(t); }, 1e-4, 30000, 50);
  const auto &normal = run.response.series("normal_force"), &roof = run.response.series("roof_z");
  ASSERT_EQ(normal.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double a = s.excitation.z.at(5e-3 * static_cast<double>(i));
    EXPECT_NEAR(roof[i], exact[i][0], 1e-8);
    EXPECT_NEAR(normal[i], s.load.vertical + m_b * a + m_s * exact[i][1], 2e-6 * s.load.vertical);
  }
}

// A stiff, light building changes nothing; a stiff one of any mass rides as one with the base.
TEST(Superstructure, RigidLimit) {
  for (const double mass_ratio : {1e-4, 0.7}) {
    scene::Scene s = ricker(0.9);
    const auto bare = simulate(s);
    s.superstructure = frame();
    s.superstructure.mass_ratio = mass_ratio;
    s.superstructure.period = s.superstructure.vertical_period = 0.01, s.superstructure.yield = 1;
    s.superstructure.damping_ratio = s.superstructure.vertical_damping_ratio = 0.5;
    const auto carried = simulate(s);
    EXPECT_NEAR(carried.summary.peak_displacement / bare.summary.peak_displacement, 1, 2e-4);
    EXPECT_NEAR(carried.summary.peak_lateral_force / bare.summary.peak_lateral_force, 1, 2e-2);
  }
}

TEST(Superstructure, EnergyCloses) {
  for (const auto &building : {frame(), frame(-0.02), shear_building()})
    for (const double scale : {0.7, 1.1, 1.5}) {
      SCOPED_TRACE(word(building.kind) + " x " + std::to_string(scale));
      scene::Scene s = ricker(scale);
      s.superstructure = building;
      const auto run = simulate(s);
      EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
      const auto &e = *run.summary.energy;
      EXPECT_GT(e.damping, 0);
      EXPECT_GE(e.plastic, 0);
    }
}

TEST(Superstructure, TwoDirectionsWithVerticalMotion) {
  scene::Scene s = scene::load_scene("pulse-bidirectional");
  s.excitation.z = sine(4, 0.2, 10);
  for (const auto &building : {frame(), shear_building()}) {
    s.superstructure = building;
    const auto run = simulate(s);
    EXPECT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
    EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
    EXPECT_GT(run.response.series("drift_y").size(), 100u);
  }
}

// Same branches, other integrator.
TEST(Superstructure, AgreesWithCvode) {
  for (const auto &building : {frame(), shear_building()}) {
    SCOPED_TRACE(word(building.kind));
    scene::Scene s = ricker(1.25);
    s.superstructure = building;
    s.reduced.tolerance = 1e-10;
    const auto own = simulate(s), other = simulate_with_cvode(s);
    EXPECT_NEAR(own.summary.peak_displacement / other.summary.peak_displacement, 1, 1e-6);
    ASSERT_EQ(own.summary.impacts.size(), other.summary.impacts.size());
    ASSERT_GE(own.summary.impacts.size(), 1u);
    EXPECT_NEAR(*own.summary.peak_impact_force / *other.summary.peak_impact_force, 1, 1e-5);
    for (const char *key : {"peak_drift_m", "peak_storey_shear_N"})
      EXPECT_NEAR(own.summary.extra[key].get<double>() / other.summary.extra[key].get<double>(), 1, 1e-4) << key;
  }
}

TEST(Superstructure, CollapseStopsTheRun) {
  scene::Scene s = ricker(1.3);
  s.superstructure = frame(-0.1);
  s.superstructure.yield = 0.004;
  const auto run = simulate(s);
  EXPECT_EQ(run.summary.status, RunStatus::stopped);
  EXPECT_NE(run.summary.reason.find("collapsed at t = "), std::string::npos) << run.summary.reason;
  EXPECT_TRUE(run.summary.extra["collapsed"].get<bool>());
  EXPECT_NEAR(run.summary.extra["peak_drift_m"].get<double>(), 11 * 0.004, 1e-9); // (1 - r) u_y / -r
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
  const auto by_cvode = simulate_with_cvode(s);
  EXPECT_EQ(by_cvode.summary.status, RunStatus::stopped);
  EXPECT_NEAR(run.response.series("time").back(), by_cvode.response.series("time").back(), 1e-5);
}

TEST(Superstructure, WhatItCannotDoIsRefused) {
  const auto refused = [](const std::string &toml, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { scene::parse_scene(toml, "s.toml"); }, words);
  };
  const std::string frame = "[superstructure]\nkind = \"bouc-wen\"\n";
  refused(frame + "mass_ratio = 1.0\n", {"s.toml:3:", "mass_ratio", "1"});
  refused(frame + "post_yield_ratio = 1.5\n", {"post_yield_ratio", "1.5"});
  refused(frame + "yield_mm = 0\n", {"yield_mm", "> 0"});
  refused(frame + "period = 0.5\n", {"period_s"});
  refused("[superstructure]\nkind = \"frame\"\n", {"frame", "bouc-wen"});
  refused("[superstructure]\nkind = \"shear-building\"\nstoreys = 2\nmasses_kg = [1e3]\n", {"masses_kg", "1", "2"});
  refused("[superstructure]\nkind = \"shear-building\"\nstoreys = 2\nmasses_kg = [5e4, 4e4]\n",
          {"masses_kg", "90000", "86952"});
  refused(frame + "[excitation]\nkind = \"push\"\n", {"superstructure.kind", "push"});
  refused(frame + "[reduced]\nnormal_force = \"constant\"\n", {"superstructure.kind", "constant"});
  const auto scene = scene::parse_scene(frame + "post_yield_ratio = -0.05\n", "s.toml");
  EXPECT_EQ(scene::parse_scene(scene::to_toml(scene), "again").superstructure, scene.superstructure);
}
