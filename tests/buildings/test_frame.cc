#include "../scene/temporary_folder.h"
#include "buildings/assembly.h"
#include "buildings/beam_column.h"
#include "buildings/frame_doubts.h"
#include "buildings/frame_source.h"
#include "buildings/modes.h"
#include "buildings/regular_building.h"
#include "io/files/error.h"
#include <Eigen/Eigenvalues>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace rimpact;
using namespace rimpact::buildings;
using Eigen::Vector3d, Eigen::VectorXd, Eigen::MatrixXd;

namespace {

template <class Action> std::string refusal(const Action &action) {
  try {
    action();
  } catch (const InputError &error) {
    return error.what();
  }
  return "";
}

VectorXd block_motion(const BuildingModel &m, const Frame &f, int axis) { // translation, or tilt about x (4)
  VectorXd q = VectorXd::Zero(m.n_dofs());
  for (int d = 0; d < m.n_diaphragms; ++d) {
    if (axis < 2) q[3 * d + axis] = 1;
    if (axis == 4) q[3 * d + 1] = -f.nodes[f.diaphragms[d].nodes[0]].at.z();
  }
  for (int i = 0; i < m.n_nodes; ++i) q[m.vertical(i)] = axis == 2 ? 1 : axis == 4 ? f.nodes[i].at.y() : 0;
  return q;
}

} // namespace

TEST(BeamColumn, CantileverDeflectsAsTimoshenko) {
  const Section s = rectangle("s", 0.3, 0.5, 30e9, 0.2);
  const Vector3d far(2, 1, 0.5), up(0, 0, 1);
  const double L = far.norm(), P = 1e4;
  const ElementMatrix k = beam_column_stiffness(s, Vector3d::Zero(), far, up);
  const Vector3d x = far / L, y = up.cross(x).normalized(), z = x.cross(y);
  Eigen::Matrix<double, 6, 1> load = Eigen::Matrix<double, 6, 1>::Zero();
  load.head<3>() = P * z;
  const Eigen::Matrix<double, 6, 1> u = Eigen::Matrix<double, 6, 6>(k.bottomRightCorner<6, 6>()).ldlt().solve(load);
  const double expected = P * L * L * L / (3 * s.E * s.Iy) + P * L / (s.G * s.shear_z);
  EXPECT_NEAR(u.head<3>().dot(z) / expected, 1, 1e-12);
  EXPECT_NEAR(u.head<3>().dot(y) / expected, 0, 1e-12);
}

TEST(Building, ASlabStiffensItsBeamsInTheVerticalPlaneOnly) {
  const Frame bare = load_frame("thesis-3.5"), slab = load_frame("thesis-3.5-slab");
  EXPECT_NEAR(slab.sections[1].Iy / bare.sections[1].Iy, 1.7, 1e-14);
  EXPECT_EQ(slab.sections[1].Iz, bare.sections[1].Iz);
  EXPECT_EQ(slab.sections[0].Iy, bare.sections[0].Iy);
  EXPECT_EQ(slab.nodes.size(), bare.nodes.size());
}

TEST(Building, AWrongUnitIsDoubted) {
  for (const char *name : {"thesis-2.4", "thesis-2.5", "thesis-3.5", "thesis-3.5-slab"})
    EXPECT_TRUE(doubts_of(load_frame(name)).empty());
  const auto doubted = [](const auto &change) {
    Frame frame = load_frame("thesis-2.5");
    change(frame);
    const auto found = doubts_of(frame);
    return found.size() == 1 ? found[0] : fmt::format("{} doubts", found.size());
  };
  const auto sections = [&](const auto &change) {
    return doubted([&](Frame &f) {
      for (auto &section : f.sections) change(section);
    });
  };
  EXPECT_EQ(sections([](Section &s) { s.E *= 1000, s.G *= 1000, s.inelastic.reset(); }),
            "section column: E = 2.34e+04 GPa, where 3 to 300 is usual (1 more): are the units right?");
  EXPECT_EQ(sections([](Section &s) { s.G *= 1e-6; }),
            "section column: G over E = 4.167e-07, where 0.02 to 1 is usual (1 more): are the units right?");
  EXPECT_EQ(sections([](Section &s) { s.inelastic->axial_yield *= 1e-3; }).substr(0, 40),
            "section column: strain at axial_yield = ");
  EXPECT_EQ(sections([](Section &s) { s.inelastic->yield_moment *= 1e3; }).substr(0, 40),
            "section column: strain at the edge where");
  EXPECT_EQ(sections([](Section &s) { s.inelastic->hinge_length *= 1e-3; }).substr(0, 40),
            "section column: hinge length over depth ");
  EXPECT_EQ(doubted([](Frame &f) {
              for (auto &node : f.nodes) node.vertical_mass *= 1e-3;
            }),
            "frame: vertical masses of nodes over masses of slabs = 0.001, where 0.5 to 2 is usual: are the units "
            "right?");
  EXPECT_EQ(doubted([](Frame &f) { f.damping_ratio = 0.5; }),
            "frame: damping_ratio = 0.5, where 0 to 0.2 is usual: are the units right?");
  const auto building = [](const auto &change) {
    RegularBuilding b = load_building("thesis-2.4");
    change(b);
    const auto found = doubts_of(make_frame(b));
    return found.size() == 1 ? found[0] : fmt::format("{} doubts", found.size());
  };
  EXPECT_EQ(building([](RegularBuilding &b) { b.column_x = b.column_y = 0.04; }), // 40 cm, written as mm
            "section column: depth = 0.04 m, where 0.08 to 5 is usual: are the units right?");
  EXPECT_EQ(building([](RegularBuilding &b) { b.column_x = 5e-4; }), // half a metre, where mm are asked for
            "section column: width = 0.0005 m, where 0.02 to 5 is usual: are the units right?");
  EXPECT_EQ(building([](RegularBuilding &b) { b.load = 800; }), // tonnes
            "level 0: mass over its plan = 81.55 kg/m2, where 100 to 10000 is usual (3 more): are the units right?");
  EXPECT_EQ(building([](RegularBuilding &b) { b.storeys.front() = 1.2; }), "0 doubts"); // a mezzanine
}

TEST(Building, OfTheThesisWeighs5120kNOnSixBearings) {
  const Frame f = make_frame(load_building("thesis-2.4"));
  const BuildingModel m = assemble(f);
  const VectorXd R = static_reactions(m, 9.81);
  ASSERT_EQ(R.size(), 6);
  EXPECT_NEAR(R.sum(), 5120e3, 1e-3);
  EXPECT_GT(R.minCoeff(), 0);
  for (const auto &[a, b] : {std::pair{0, 2}, {0, 3}, {0, 5}, {1, 4}}) EXPECT_NEAR(R[a], R[b], 1e-4); // by symmetry
  EXPECT_GT(R[1], R[0]); // the middle line carries more
  double mass = 0;
  for (int d = 0; d < m.n_diaphragms; ++d) mass += m.mass[3 * d];
  EXPECT_NEAR(mass * 9.81, 5120e3, 1e-3);
}

TEST(Building, RigidMotionsAreNeitherStrainedNorDamped) {
  const Frame f = make_frame(load_building("thesis-2.4"));
  const BuildingModel m = assemble(f);
  for (const int axis : {0, 1, 2, 4}) {
    const VectorXd q = block_motion(m, f, axis);
    EXPECT_LT((m.stiffness * q).cwiseAbs().maxCoeff(), 1e-10 * m.stiffness.diagonal().maxCoeff()) << axis;
    EXPECT_LT((m.damping * q).cwiseAbs().maxCoeff(), 1e-9 * m.damping.diagonal().maxCoeff()) << axis;
  }
}

TEST(Building, EveryModeHasItsDampingRatio) {
  const BuildingModel m = assemble(make_frame(load_building("thesis-2.4")));
  const auto free = m.above_base();
  const Modes modes = fixed_base_modes(m);
  const MatrixXd C = modes.shapes.transpose() * MatrixXd(m.damping(free, free)) * modes.shapes;
  const MatrixXd expected = MatrixXd((0.04 * modes.omega).asDiagonal());
  EXPECT_LT((C - expected).cwiseAbs().maxCoeff(), 1e-10 * expected.maxCoeff());
}

TEST(Building, WeightStandsWhereItsMassDoes) {
  RegularBuilding b;
  b.x = {0, 3, 11, 16}, b.y = {0, 8}, b.storeys = {3.5};
  const double level = b.load * 16 * 8;
  for (const Eigen::Vector2d &off : {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.3, -0.1), Eigen::Vector2d(-0.45, 0.45)}) {
    b.eccentricity = off;
    const Frame f = make_frame(b);
    const VectorXd R = static_reactions(assemble(f), b.gravity);
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (int i = 0; i < 8; ++i) moment += R[i] * f.nodes[i].at.head<2>();
    EXPECT_NEAR(R.sum() / (2 * level), 1, 1e-9);
    EXPECT_NEAR((moment / R.sum() - f.diaphragms[0].centre).norm(), 0, 1e-8);
    for (const auto &node : f.nodes) EXPECT_GT(node.vertical_mass, 0);
    for (const auto &doubt : doubts_of(f)) EXPECT_EQ(doubt.find("centre of mass"), std::string::npos) << doubt;
  }
}

TEST(Building, AWeightBesideItsMassIsDoubted) {
  Frame f = make_frame(load_building("thesis-2.4"));
  for (auto &slab : f.diaphragms) slab.centre.x() += 2;
  const auto found = doubts_of(f);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("distance of the centre of mass from that of the weights"), std::string::npos) << found[0];
}

TEST(Building, EccentricMassTwistsTheFirstMode) {
  RegularBuilding b = load_building("thesis-2.4");
  const auto twist = [&] { return std::abs(fixed_base_modes(assemble(make_frame(b))).shapes.topRows(9).col(0)[2]); };
  const double straight = twist();
  b.eccentricity = {0.3, 0.3};
  EXPECT_LT(straight, 1e-12);
  EXPECT_GT(twist(), 1e-6);
}

TEST(Building, IsRefusedWithASentence) {
  const auto frame = [](auto change) {
    Frame f = make_frame(load_building("thesis-2.4"));
    change(f);
    return refusal([&] { assemble(f); });
  };
  EXPECT_EQ(frame([](Frame &f) { f.nodes[6].vertical_mass = 0; }), "node 7 has the mass 0 kg; it must be above 0");
  EXPECT_EQ(frame([](Frame &f) { f.nodes[7].supported = true; }),
            "node 8 stands on a bearing but not in the base, diaphragm 1");
  EXPECT_EQ(frame([](Frame &f) {
              for (auto &n : f.nodes) n.supported = false;
            }),
            "no node stands on a bearing");
  EXPECT_EQ(frame([](Frame &f) { f.elements[0].j = 99; }), "element 1 ends at node 100; the frame has nodes 1 to 24");
  EXPECT_EQ(frame([](Frame &f) { f.diaphragms[2].mass = 0; }), "diaphragm 3 has the mass 0 kg; it must be above 0");
  EXPECT_NE(frame([](Frame &f) {
              std::erase_if(f.elements, [](const Element &e) { return e.section == 0; });
            }).find("is a mechanism"),
            std::string::npos);
  EXPECT_NE(frame([](Frame &f) {
              std::erase_if(f.elements, [](const Element &e) { return e.i == 23 || e.j == 23; });
            }).find("the building is a mechanism: node 24"),
            std::string::npos);
  EXPECT_NE(refusal([] { parse_building("x_m = [0, 8]\ny_m = [8, 0]\n", "b.toml"); }).find("b.toml:2:"),
            std::string::npos);
  EXPECT_NE(refusal([] {
              parse_building("x_m = [0, 8]\ny_m = [0, 8]\ncolum_x_mm = 3\n", "b.toml");
            }).find("did you mean \"column_x_mm\""),
            std::string::npos);
  EXPECT_NE(refusal([] { load_building("nowhere.toml"); }).find("no such file"), std::string::npos);
}

TEST(Building, ABearingsFileIsSoughtBesideTheFrame) {
  const TemporaryFolder kept;
  const std::string folder = kept.path();
  kept.write("mine.toml", "[rim]\nheight_mm = 60\n");
  const auto frame = parse_building("x_m = [0, 8]\ny_m = [0, 8]\n[bearings]\n1 = \"mine.toml\"\n2 = \"fps-225\"\n",
                                    folder + "/frame.toml");
  EXPECT_EQ(frame.bearings.at(1), folder + "/mine.toml");
  EXPECT_EQ(frame.bearings.at(2), "fps-225");
}
