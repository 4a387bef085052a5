// Gates of a building on bearings: closed forms, equivalences, orders, and a second method.
#include "buildings/regular_building.h"
#include "buildings/simulate.h"
#include "plain_cvode.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::buildings;

namespace {

scene::Scene pulse(double scale, double slip_mm, double tolerance) {
  scene::Scene s =
      scene::parse_scene("[load]\nvertical_kN = 853.0\n[excitation]\nkind = \"ricker\"\namplitude_g = 0.78\n"
                         "period_s = 1.0\ncentre_s = 2.0\nduration_s = 4.0\n"
                         "[reduced]\nfriction = \"park-wen\"\n",
                         "test");
  s.excitation.scale = scale, s.reduced.elastic_slip = 1e-3 * slip_mm, s.reduced.tolerance = tolerance;
  return s;
}

RegularBuilding thesis() {
  return load_building("thesis-2.4");
}

} // namespace

// A block of width B and centre of mass at z tips over its edge from a = g (B / 2) / z on.
TEST(RigidBlock, LiftsOffAtTheClosedFormsAcceleration) {
  RegularBuilding b;
  b.x = {0, 2}, b.y = {0, 2}, b.storeys = {10};
  b.E = 2e12; // next to rigid
  scene::Scene s = pulse(1, 0.05, 1e-8);
  s.reduced.mu_fast = s.reduced.mu_slow = 0.9; // does not slide
  s.excitation.kind = scene::ExcitationKind::record;
  const double g = s.load.gravity, slope = 0.0125 * g; // a grows to g / 4 in 20 s
  s.excitation.x = {.dt = 20.0, .values = {0.0, 20 * slope}};
  s.excitation.duration = 18;
  const auto run = simulate(make_frame(b), s);
  // The pair on the lifting side: equilibrium says nothing of how the two share what they bear.
  const auto &t = run.response.series("time"), &N = run.response.series("bearing_2_normal_force"),
             &other = run.response.series("bearing_4_normal_force");
  const double at_rest = N.front() + other.front();
  std::size_t i = 0;
  while (i < N.size() && N[i] + other[i] > 1e-3 * at_rest) ++i;
  ASSERT_LT(i, N.size()) << run.summary.reason;
  EXPECT_NEAR(t[i] * slope / g, 1.0 / 5, 0.0015); // centre of mass at 5 m, half width 1 m
}

TEST(BuildingGates, HalvesSideBySideRespondAsOne) {
  RegularBuilding half;
  half.x = {0, 8}, half.y = {0, 8}, half.storeys = {3.5, 3.5};
  const Frame one = make_frame(half);
  Frame both = one;
  const int n = static_cast<int>(one.nodes.size());
  const Eigen::Vector3d aside(0, 20, 0);
  for (auto node : one.nodes) node.at += aside, both.nodes.push_back(node);
  for (auto e : one.elements) e.i += n, e.j += n, both.elements.push_back(e);
  for (auto &slab : both.diaphragms) {
    const auto own = slab.nodes;
    for (const int node : own) slab.nodes.push_back(node + n);
    slab.inertia = 2 * (slab.inertia + slab.mass * 100), slab.mass *= 2, slab.centre += aside.head<2>() / 2;
  }
  const scene::Scene s = pulse(1.05, 1, 1e-11);
  const auto a = simulate(one, s), b = simulate(both, s);
  ASSERT_EQ(a.summary.status, RunStatus::done);
  ASSERT_GT(a.summary.impacts.size(), 0u);
  EXPECT_EQ(2 * a.summary.impacts.size(), b.summary.impacts.size());
  EXPECT_NEAR(b.summary.peak_lateral_force / a.summary.peak_lateral_force, 2, 1e-6);
  EXPECT_NEAR(b.summary.impacts[0].touch_time, a.summary.impacts[0].touch_time, 1e-8);
  for (const char *name : {"floor_1_displacement_x", "floor_2_displacement_x"})
    EXPECT_NEAR(b.response.series(name).back(), a.response.series(name).back(), 1e-7) << name;
}

TEST(BuildingGates, ErrorFallsWithTheTolerance) {
  const Frame f = make_frame(thesis());
  const auto end = [&](double tolerance) {
    scene::Scene s = pulse(0.7, 1, tolerance); // no impact: the branches stay
    const auto run = simulate(f, s);
    return Eigen::Vector2d(run.response.series("floor_3_displacement_x").back(), run.summary.peak_displacement);
  };
  const Eigen::Vector2d exact = end(1e-12);
  double last = 0;
  std::vector<double> errors;
  for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
    last = (end(tolerance) - exact).cwiseAbs().maxCoeff();
    errors.push_back(last);
    EXPECT_LT(last, 100 * tolerance) << tolerance;
  }
  const double order = std::log(errors[0] / errors[2]) / std::log(1e4);
  std::printf("errors %.1e %.1e %.1e m at 1e-5, 1e-7, 1e-9: order %.2f in the tolerance\n", errors[0], errors[1],
              errors[2], order);
  // The kinks of Park and Wen's law end no step, and the elastic slip bounds the steps: less than a smooth system's
  // 0.8.
  EXPECT_GT(order, 0.25);
}

TEST(BuildingGates, PlainEquationsByCvodeAgree) {
  Frame f = make_frame(thesis());
  for (auto &slab : f.diaphragms) slab.centre += Eigen::Vector2d(0.8, 0.8); // the weights stay, so it turns
  scene::Scene s = pulse(1.02, 1, 1e-9);
  s.excitation.direction_deg = 30;
  s.reduced.impact_law = &laws::impact_law("hunt-crossley");
  const auto ours = simulate(f, s);
  ASSERT_EQ(ours.summary.status, RunStatus::done);
  const PlainAnswer theirs = plain_cvode(assemble(f), s, 1e-9);
  ASSERT_GT(theirs.smallest_normal, 0) << "a bearing lifts off: the plain equations do not hold";
  ASSERT_GT(theirs.rim_force, 0);
  ASSERT_GT(ours.summary.impacts.size(), 0u);
  EXPECT_NEAR(ours.summary.peak_displacement / theirs.travel, 1, 1e-4);
  EXPECT_NEAR(ours.summary.peak_lateral_force / theirs.base_shear, 1, 1e-3);
  EXPECT_NEAR(*ours.summary.peak_impact_force / theirs.rim_force, 1, 1e-3);
  const double drift = ours.summary.extra["building"]["floors"][0]["peak_drift_m"];
  EXPECT_NEAR(drift / theirs.drift, 1, 1e-3);
  EXPECT_NEAR(ours.response.series("floor_3_displacement_x").back(), theirs.final[9], 1e-4 * 0.4);
}

// End forces of the columns hold what stands above them, at rest and at any instant.
TEST(Members, CarryTheStoreysWeightAndShear) {
  const Frame f = make_frame(thesis());
  const BuildingModel m = assemble(f);
  const MemberForces members(f, m);
  const Eigen::VectorXd at_rest = members.at(static_displacements(m, 9.81));
  Eigen::VectorXd q = static_displacements(m, 9.81);
  q[3] = 0.01, q[4] = -0.004; // the first floor aside
  const Eigen::VectorXd pushed = members.at(q), force = m.stiffness * q;
  double axial = 0;
  Eigen::Vector3d shear = Eigen::Vector3d::Zero();
  for (std::size_t e = 0; e < f.elements.size(); ++e) {
    const auto &column = f.elements[e];
    if (f.nodes[column.i].at.z() != 0 || column.section != 0) continue; // of the first storey
    axial += at_rest[12 * e];
    const auto axes = local_axes(f.nodes[column.i].at, f.nodes[column.j].at, column.up);
    shear += axes.transpose() * pushed.segment<3>(12 * e);
  }
  EXPECT_NEAR(axial, 0.75 * 5120e3, 1e-3); // three of four levels: compression pushes end i upwards
  EXPECT_NEAR(shear[0], force[0], 1e-6 * std::abs(force[0]));
  EXPECT_NEAR(shear[1], force[1], 1e-6 * std::abs(force[1]));
}

TEST(BuildingSimulation, LeavesItsHardestInstantAndPictures) {
  scene::Scene s = pulse(1.05, 1, 1e-8);
  const auto result = simulate_whole(make_frame(thesis()), s, {}, 0.5);
  EXPECT_EQ(result.trace.instants.size(), 9u); // 0, 0.5, ... 4 s
  const auto &rims = result.trace.hardest.rim_force;
  EXPECT_NEAR(*std::max_element(rims.begin(), rims.end()), *result.run.summary.peak_impact_force,
              1e-9 * *result.run.summary.peak_impact_force);
  EXPECT_LE((result.trace.members.least - result.trace.members.at_rest).maxCoeff(), 0);
  EXPECT_GE((result.trace.members.largest - result.trace.members.at_rest).minCoeff(), 0);
}
