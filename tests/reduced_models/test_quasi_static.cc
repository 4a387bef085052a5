// Loops of 2.3.1 and the rim push against closed forms written from the thesis's equations, not from the
// module's.
#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/bearings/riding_height.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <algorithm>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using reduced::testing::Ellipse;

namespace {

constexpr double W = 853e3, mu = 0.07;

scene::Scene cyclic() {
  scene::Scene s;
  s.excitation.kind = scene::ExcitationKind::cyclic;
  s.excitation.amplitude = 0.39;
  return s;
}

/// Resisting force at x on the way out and back within the first quarter and second quarter of the cycle.
struct Loop {
  double loading, unloading, height;
};
Loop at(const Response &r, double x) {
  const auto &u = r.series("displacement_x"), &f = r.series("force_x"), &z = r.series("displacement_z");
  Loop loop{NAN, NAN, NAN};
  const std::size_t peak = std::max_element(u.begin(), u.end()) - u.begin();
  const auto between = [&](std::size_t i, const std::vector<double> &y) {
    const double s = (x - u[i - 1]) / (u[i] - u[i - 1]);
    return y[i - 1] + s * (y[i] - y[i - 1]);
  };
  for (std::size_t i = 1; i < u.size() / 2; ++i)
    if (u[i] != u[i - 1] && (u[i - 1] - x) * (u[i] - x) <= 0) {
      (i <= peak ? loop.loading : loop.unloading) = -between(i, f);
      loop.height = between(i, z);
    }
  return loop;
}

} // namespace

TEST(Cyclic, ClosedFormLoads) {
  const auto run = simulate(cyclic());
  const Ellipse e;
  struct Row { // published table of the closed form (kN), loading and unloading
    double x, loading, unloading;
  };
  for (const Row &row : {Row{0.10, 98.6, -21.1}, Row{0.31, 202.9, 80.2}}) {
    const Loop loop = at(run.response, row.x);
    EXPECT_NEAR(loop.loading / 1e3, row.loading, 0.06);
    EXPECT_NEAR(loop.unloading / 1e3, row.unloading, 0.06);
    const double theta = std::atan(e.slope(row.x));
    EXPECT_NEAR(loop.loading, W * std::tan(theta + std::atan(mu)), 1e-5 * W);
    EXPECT_NEAR(loop.unloading, W * std::tan(theta - std::atan(mu)), 1e-5 * W);
  }
  // at the turning point the last loading sample is the peak itself
  const auto &f = run.response.series("force_x"), &u = run.response.series("displacement_x");
  const std::size_t peak = std::max_element(u.begin(), u.end()) - u.begin();
  EXPECT_NEAR(-f[peak] / 1e3, 269.4, 0.05);
  EXPECT_NEAR(-f[peak + 1] / 1e3, 143.1, 0.1);
  EXPECT_NEAR(run.response.series("displacement_z")[peak] * 1e3, 39.29, 0.005);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
}

/// The socket's arm over its radius by a sum over the sphere in other coordinates (distance from the axis and
/// latitude).
TEST(Cyclic, SocketArmIsTheMomentOfACosinePressure) {
  const scene::Bearing bearing;
  const double c = bearing.slider.bottom / bearing.foot.cap_radius;
  double moment = 0, load = 0;
  const int n = 1500;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) { // plan coordinates: dA = dx dy / z
      const double x = -1 + (2 * i + 1.0) / n, y = -1 + (2 * j + 1.0) / n,
                   z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
      if (!(z > c)) continue;
      load += z;                          // pressure z, its vertical part z^2, over z
      moment += std::sqrt(x * x + z * z); // pressure z times the distance from the axis, over z
    }
  EXPECT_NEAR(socket_arm(bearing) / bearing.foot.cap_radius, moment / load, 1e-3);
  scene::Bearing narrow;
  narrow.slider.bottom = 0.0899;
  EXPECT_NEAR(socket_arm(narrow), 0.090, 1e-4);
}

TEST(Cyclic, SocketFrictionAddsItsMomentOverTheCurvature) {
  scene::Scene s = cyclic();
  s.reduced.socket_friction = true;
  const Ellipse e;
  const Loop loop = at(simulate(s).response, 0.31);
  const double share = 0.10 * socket_arm(s.bearing) * e.meridional(0.31), theta = std::atan(e.slope(0.31));
  EXPECT_NEAR(loop.loading, W * std::tan(theta + std::atan(mu + share)), 1e-5 * W);
  EXPECT_NEAR(loop.unloading, W * std::tan(theta - std::atan(mu + share)), 1e-5 * W);
}

TEST(Cyclic, PadAddsItsSlope) {
  scene::Scene s = cyclic();
  s.reduced.finite_pad = true;
  const RidingHeight ridden(s.bearing, W);
  const auto p = ridden.at(0.31, 0);
  const Loop loop = at(simulate(s).response, 0.31);
  EXPECT_GT(p.gradient[0], Ellipse().slope(0.31) + 0.002);
  EXPECT_NEAR(loop.loading, W * std::tan(std::atan(p.gradient[0]) + std::atan(mu)), 2e-5 * W);
  EXPECT_NEAR(loop.height, p.z, 1e-6);
}

/// Closed-form loops W tan(atan h' +- atan mu) on the other surfaces, slopes written down here.
TEST(Cyclic, ClosedFormOnEverySurface) {
  struct Row {
    scene::SurfaceKind kind;
    double (*slope)(double);
  };
  constexpr double s = 0.11, c = 0.11 * 0.3;
  for (const Row &row :
       {Row{scene::SurfaceKind::cone, [](double x) { return s * x / std::sqrt(x * x + c * c); }},
        Row{scene::SurfaceKind::polynomial, [](double x) { return 0.4 * x - 0.6 * x * x * x + 1.8 * std::pow(x, 5); }},
        Row{scene::SurfaceKind::table, [](double x) { return 0.5 * x - 0.15 * x * x; }}}) {
    SCOPED_TRACE(word(row.kind));
    scene::Scene scene = cyclic();
    auto &surface = scene.bearing.surface;
    surface.kind = row.kind, surface.R0 = 0.3, surface.slope = s;
    surface.coefficients = {0.2, 0, -0.15, 0, 0.3};
    for (const double r : {0.0, 0.1, 0.25, 0.4, 0.53}) {
      surface.table_radius.push_back(r);
      surface.table_height.push_back(r * r * (0.25 - 0.05 * r));
    }
    scene.validate();
    const auto run = simulate(scene);
    for (const double x : {0.05, 0.21, 0.36}) {
      const Loop loop = at(run.response, x);
      EXPECT_NEAR(loop.loading, W * std::tan(std::atan(row.slope(x)) + std::atan(mu)), 2e-5 * W);
      EXPECT_NEAR(loop.unloading, W * std::tan(std::atan(row.slope(x)) - std::atan(mu)), 2e-5 * W);
    }
    EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
  }
}

TEST(FigureEight, ForcesFromTheImplicitSurface) {
  scene::Scene s;
  s.excitation.kind = scene::ExcitationKind::figure_eight;
  s.excitation.amplitude = 0.31;
  const auto run = simulate(s);
  const auto &r = run.response;
  const auto surface = scene::make_surface(s.bearing.surface);
  double largest = 0, worst = 0;
  const double w = 2 * std::numbers::pi;
  for (std::size_t i = 1; i < r.size(); ++i) {
    const double t = r.series("time")[i];
    const Eigen::Vector3d x(r.series("displacement_x")[i], r.series("displacement_y")[i],
                            r.series("displacement_z")[i]);
    largest = std::max(largest, x.head<2>().norm());
    ASSERT_NEAR(surface->F(x), 0, 1e-12);
    // (2-14): unit normal from the implicit function, upwards; 2.3.1's angle atan(u_y'/u_x')
    Eigen::Vector3d n = surface->gradient(x).normalized();
    if (n[2] < 0) n = -n;
    const Eigen::Vector2d rate(std::cos(w * t), 2 * std::cos(2 * w * t));
    Eigen::Vector3d sliding(rate[0], rate[1], -n.head<2>().dot(rate) / n[2]);
    sliding.normalize();
    const double N = W / (n[2] - mu * sliding[2]);
    const Eigen::Vector3d force = N * n - mu * N * sliding;
    worst = std::max(worst, std::hypot(r.series("force_x")[i] - force[0], r.series("force_y")[i] - force[1]));
  }
  EXPECT_NEAR(largest, 0.387, 5e-4); // notes, item 9: no impact
  EXPECT_TRUE(run.summary.impacts.empty());
  EXPECT_LT(worst, 1e-4 * W);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
}

TEST(Push, SpringBeyondTouch) {
  scene::Scene s;
  s.excitation.kind = scene::ExcitationKind::push;
  s.excitation.travel = 0.008;
  s.excitation.direction_deg = 30;
  const auto run = simulate(s);
  EXPECT_NEAR(*run.summary.peak_impact_force, 4.5e8 * 0.008, 1e-6 * 4.5e8 * 0.008);
  EXPECT_NEAR(run.summary.peak_displacement, 0.408, 1e-9);
  EXPECT_EQ(run.summary.impacts.size(), 1u);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
  EXPECT_NEAR(run.summary.energy->impact, 0, 1e-6 * 0.5 * 4.5e8 * 0.008 * 0.008); // a spring gives all back
}
