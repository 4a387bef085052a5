// The moment of an end section beside its axial force: the diagram against a sum over fibres, members that follow it.
#include "buildings/plane_beam_column.h"
#include "buildings/plane_frame.h"
#include "buildings/simulate.h"
#include "io/files/error.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::buildings;

namespace {

constexpr double width = 0.5, depth = 0.5, concrete = 0.85 * 25e6, steel = 900e3; ///< [m], [Pa], yield force of a layer

AxialBending section() {
  return {.crush = concrete * width * depth, .plain = steel * AxialBending::lever * depth, .depth = depth};
}

/// The concrete column of these tests, which does not wear.
PlaneBeamColumn column() {
  PlaneBeamColumn m;
  m.from = {0, 0}, m.to = {0, 3.5}, m.hinge_length = 0.25;
  const double My = section().plain;
  m.bending = {My, My / 122e6, 0, 2, 0.5, 0, 0}, m.axial = {section().crush, section().crush / 5.85e9, 1};
  m.interaction = section();
  return m;
}

} // namespace

TEST(AxialBending, IsTheSumOverFibresOfABlockAndTwoLayers) {
  constexpr int n = 20000;
  const AxialBending diagram = section();
  for (const double share : {0.05, 0.2, 0.5, 0.8, 0.95}) { // of the depth that is pressed
    double force = 0, moment = 0;
    for (int i = 0; i < n; ++i) {
      const double y = depth * ((i + 0.5) / n - 0.5);
      if (y < depth * (0.5 - share)) continue;
      force += concrete * width * depth / n, moment += concrete * width * depth / n * y;
    }
    moment += 2 * steel * AxialBending::lever * depth / 2; // a layer pressed, one pulled
    EXPECT_NEAR(diagram.factor(-force).value * diagram.plain / moment, 1, 1e-3) << share;
  }
  EXPECT_NEAR(diagram.pull() / (2 * steel), 1, 1e-12);
  EXPECT_EQ(diagram.factor(0).value, 1);
  EXPECT_NEAR(diagram.factor(0.5 * diagram.pull()).value, 0.5, 1e-12);
  EXPECT_NEAR(diagram.factor(-diagram.crush).value, 1, 1e-12);
  EXPECT_EQ(diagram.factor(2 * diagram.pull()).value, AxialBending::least);
  EXPECT_GE(diagram.largest(), diagram.factor(-0.4 * diagram.crush).value);
  for (const double axial : {-2e6, -0.3e6, 0.4e6, -1.01 * section().crush}) {
    const double h = 1, slope = (diagram.factor(axial + h).value - diagram.factor(axial - h).value) / (2 * h);
    EXPECT_NEAR(diagram.factor(axial).slope / slope, 1, 1e-6) << axial;
  }
}

TEST(AxialBending, AMembersEndsYieldAtTheMomentOfItsAxialForce) {
  const PlaneBeamColumn m = column();
  for (const double axial : {-1.5e6, -3e6, 0.0, 0.6e6}) {
    const double stretch = axial * 3.5 / 5.85e9;
    SectionPoints p{};
    PlaneBeamColumn::Basic answer{};
    for (int i = 1; i <= 400; ++i) {
      answer = m.basic({stretch, 0.08 * i / 400, 0.08 * i / 400}, p, p);
      p = answer.points;
    }
    const double expected = section().factor(axial).value * section().plain;
    EXPECT_NEAR(answer.force[0], axial, 1e-6 * section().crush);
    EXPECT_NEAR(answer.force[1] / expected, 1, 2e-3) << axial;
    EXPECT_NEAR(answer.force[2] / expected, 1, 2e-3) << axial;
  }
}

TEST(AxialBending, TheTangentIsThatOfTheForces) {
  PlaneBeamColumn m = column();
  m.bending.post_yield = 0.02, m.bending.strength_loss = 0.02, m.bending.stiffness_loss = 0.05;
  SectionPoints base;
  base[0] = {0.003, 0.4, 2}, base[1] = {-0.01, -0.7, 5}, base[2] = {-1e-4, 0, 0};
  const Vector3 deformation(-1.2e-3, 0.02, -0.03);
  const auto at = m.basic(deformation, base, base);
  ASSERT_TRUE(at.force.allFinite());
  EXPECT_GT(std::abs(at.slopes(1, 0)), 0);
  for (int c = 0; c < 3; ++c) {
    Vector3 plus = deformation, minus = deformation;
    const double h = c == 0 ? 1e-8 : 1e-7;
    plus[c] += h, minus[c] -= h;
    const Vector3 slope = (m.basic(plus, base, at.points).force - m.basic(minus, base, at.points).force) / (2 * h);
    EXPECT_LT((slope - at.slopes.col(c)).norm(), 1e-4 * at.slopes.col(c).norm()) << c;
  }
}

TEST(AxialBending, AForceThatComesAndGoesDoesNoWorkOfItsOwn) {
  const PlaneBeamColumn m = column();
  SectionPoints p{};
  Vector3 v = Vector3::Zero(), force = Vector3::Zero();
  double work = 0, lost = 0;
  constexpr int n = 40000;
  for (int i = 1; i <= n; ++i) {
    const double t = 2 * M_PI * i / n;
    const Vector3 next(-1e-3 * std::sin(5 * t), 0.03 * std::sin(2 * t), 0.02 * std::sin(3 * t));
    const auto answer = m.basic(next, p, p, 1e-4);
    SectionPoints rates;
    for (int k = 0; k < 3; ++k)
      rates[k] = {answer.points[k].d - p[k].d, answer.points[k].z - p[k].z, answer.points[k].e - p[k].e};
    work += 0.5 * (force + answer.force).dot(next - v), lost += m.loss(answer.points, rates);
    p = answer.points, force = answer.force, v = next;
  }
  EXPECT_GT(lost, 1e4);
  EXPECT_NEAR(work, m.stored(p) + lost, 2e-3 * lost);
}

TEST(AxialBending, AFrameKeepsItsEnergyAndItsColumnsBearMoreThanTheirPlainMoment) {
  const auto run = [](const char *interaction) {
    const auto frame = make_frame(parse_plane_frame(
        std::string("x_m = [0.0, 6.0]\nstoreys_m = [4.0, 3.5]\nload_kN_per_m = 60.0\n[column]\nyield_kN_m = 150\n"
                    "interaction = \"") +
            interaction + "\"\n",
        "frame"));
    return simulate(frame,
                    scene::parse_scene("[bearing]\nname = \"fps-225\"\n[excitation]\nkind = \"ricker\"\n"
                                       "amplitude_g = 0.78\nperiod_s = 1.0\nscale = 1.2\nduration_s = 5\n[reduced]\n"
                                       "friction = \"park-wen\"\nelastic_slip_mm = 1.0\n[isolator]\n"
                                       "step_tolerance = 1e-5\n",
                                       "test"))
        .summary;
  };
  const Summary without = run("none"), with = run("stress-block");
  for (const auto &summary : {without, with}) {
    ASSERT_EQ(summary.status, RunStatus::done) << summary.reason;
    EXPECT_LT(std::abs(summary.energy->imbalance_relative()), 1e-4);
  }
  const auto ductility = [](const Summary &s) {
    return s.extra.at("building").at("inelastic").at("sections")[0].at("peak_ductility").get<double>();
  };
  EXPECT_GT(ductility(without), 2);
  EXPECT_LT(ductility(with), 0.9 * ductility(without));
}

TEST(AxialBending, AWearThatCouldGiveEnergyIsRefused) {
  try {
    make_frame(parse_plane_frame("x_m = [0.0, 6.0]\nstoreys_m = [4.0]\nload_kN_per_m = 40.0\n[column]\ninteraction = "
                                 "\"stress-block\"\nyield_kN_m = 100\n"
                                 "stiffness_degradation = 1.9\n",
                                 "f.toml"))
        .validate();
    FAIL() << "taken";
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("stiffness degradation 1.9; it must be in 0.."), std::string::npos)
        << error.what();
  }
}
