// The inelastic frame of thesis 2.5: against the linear building, its energies, convergence, files, refusals.
#include "../scene/temporary_folder.h"
#include "buildings/builtin_buildings.h"
#include "buildings/frame_tables.h"
#include "buildings/implicit_run.h"
#include "buildings/inelastic_frame.h"
#include "buildings/modes.h"
#include "buildings/plane_frame.h"
#include "buildings/simulate.h"
#include "by_implicit_steps.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>

using namespace rimpact;
using namespace rimpact::buildings;

namespace {

scene::Scene frame_pulse(double scale, double tolerance) {
  scene::Scene s =
      scene::parse_scene("[bearing]\nname = \"fps-225\"\n[excitation]\nkind = \"ricker\"\namplitude_g = 0.78\n"
                         "period_s = 1.0\ncentre_s = 2.0\nduration_s = 4.0\nscale = " +
                             std::to_string(scale) +
                             "\n[reduced]\nfriction = \"park-wen\"\nelastic_slip_mm = 1.0\n"
                             "impact_law = \"hunt-crossley\"\n",
                         "test");
  s.isolator.step_tolerance = tolerance;
  return s;
}

PlaneFrame thesis_plane() {
  return parse_plane_frame(building_text("thesis-2.5"), "thesis-2.5");
}
double peak_drift(const Summary &s, int floor) {
  return s.extra.at("building").at("floors")[floor].at("peak_drift_m").get<double>();
}
const nlohmann::json &section(const Summary &s, int i) {
  return s.extra.at("building").at("inelastic").at("sections")[i];
}

} // namespace

TEST(InelasticFrame, HasTheWeightAndAboutThePeriodOfTheThesis) {
  const Frame f = make_frame(thesis_plane());
  const BuildingModel m = assemble(f);
  double weight = 0;
  for (const auto &slab : f.diaphragms) weight += 9.81 * slab.mass;
  EXPECT_NEAR(weight, 2560e3, 1);
  EXPECT_NEAR(static_reactions(m, 9.81).sum(), 2560e3, 1);
  std::vector<int> plane;
  for (const int dof : m.above_base())
    if (dof >= 3 * m.n_diaphragms || dof % 3 == 0) plane.push_back(dof);
  const Eigen::MatrixXd K = m.stiffness(plane, plane), M = Eigen::VectorXd(m.mass(plane)).asDiagonal();
  const double w2 = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K, M).eigenvalues()[0];
  EXPECT_NEAR(2 * std::numbers::pi / std::sqrt(w2), 0.5, 0.1);
}

/// Far from yield it is the linear building of the same members but for P-Delta, half a percent of a storey's
/// stiffness.
TEST(InelasticFrame, FarFromYieldIsTheLinearBuilding) {
  PlaneFrame p = thesis_plane();
  p.column.yield_moment = p.beam.yield_moment = 1e9, p.column.axial_yield = p.beam.axial_yield = 1e10;
  const Frame inelastic = make_frame(p);
  const auto s = frame_pulse(1.0, 1e-4);
  const auto frame = simulate(inelastic, s).summary;
  ASSERT_EQ(frame.status, RunStatus::done) << frame.reason;
  const Summary linear = buildings::by_implicit_steps(assemble(inelastic), s, 3);
  EXPECT_LT(section(frame, 0)["peak_ductility"].get<double>(), 1e-2);
  EXPECT_LT(std::abs(frame.energy->plastic), 1e-4 * frame.energy->external);
  EXPECT_GT(frame.peak_displacement, 0.05);
  EXPECT_NEAR(frame.peak_displacement, linear.peak_displacement, 5e-3 * linear.peak_displacement);
  for (int floor = 0; floor < 3; ++floor)
    EXPECT_NEAR(peak_drift(frame, floor), peak_drift(linear, floor), 0.03 * peak_drift(linear, floor));
}

/// A closed portal of one bay under its own weight: every end has the same moment M. Its closed form is the M at which
/// ends of beam and column turn alike, with M = r E I kappa + (1 - r) M_y tanh(kappa / kappa_y) in their end sections.
TEST(InelasticFrame, APortalAtRestHasTheMomentOfItsClosedForm) {
  constexpr double L = 6, h = 4, load = 50e3, E = 30e9, lp = 0.25, r = 0.02;
  constexpr double column = E * 0.5 * 0.5 * 0.5 * 0.5 / 12, beam = E * 0.4 * 0.6 * 0.6 * 0.6 / 12; // E I
  const auto root_of = [](double high, const auto &below) {
    double low = 0;
    for (int i = 0; i < 200; ++i) (below((low + high) / 2) ? low : high) = (low + high) / 2;
    return low;
  };
  for (const double My : {140e3, 270e3}) {
    PlaneFrame p = parse_plane_frame("x_m = [0.0, 6.0]\nstoreys_m = [4.0]\nload_kN_per_m = 50.0\nE_GPa = 30.0\n"
                                     "beam_width_mm = 400.0\nbeam_depth_mm = 600.0\n",
                                     "portal");
    p.column.yield_moment = p.beam.yield_moment = My;
    for (MemberClass *c : {&p.column, &p.beam}) c->law.strength_loss = c->law.stiffness_loss = 0;
    const auto softening = [&](double M, double EI) { // curvature beyond the elastic one
      return root_of(1.0, [&](double k) { return r * EI * k + (1 - r) * My * std::tanh(k * EI / My) < M; }) - M / EI;
    };
    const double expected = root_of(load * L * L / 12, [&](double M) {
      const double of_beam = load * L * L * L / (24 * beam) - M * L / (2 * beam) - lp * softening(M, beam);
      return of_beam > M * h / (6 * column) + lp * softening(M, column);
    });
    const Frame frame = make_frame(p);
    const BuildingModel model = assemble(frame);
    const auto structure = inelastic_structure(frame, model, 9.81);
    const auto rest = structure->members(structure->at_rest().q);
    for (int end = 0; end < rest.forces.size() / 6; ++end)
      EXPECT_NEAR(rest.forces.segment(6 * end + 3, 3).lpNorm<Eigen::Infinity>(), expected, 1e-4 * expected);
  }
}

TEST(InelasticFrame, YieldsAndKeepsItsEnergy) {
  const auto run = simulate(make_frame(thesis_plane()), frame_pulse(1.3, 1e-5));
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_GT(run.summary.impacts.size(), 0u);
  EXPECT_GT(section(run.summary, 0)["peak_ductility"].get<double>(), 2);
  EXPECT_LT(section(run.summary, 0)["strength_left"].get<double>(), 1);
  EXPECT_GT(run.summary.energy->plastic, 0);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
  const auto &plastic = run.response.series("energy_plastic");
  for (std::size_t i = 1; i < plastic.size(); ++i) EXPECT_GE(plastic[i], plastic[i - 1]);
  for (int floor = 1; floor <= 3; ++floor)
    for (const double y : run.response.series("floor_" + std::to_string(floor) + "_displacement_y")) EXPECT_EQ(y, 0);
}

/// Local errors of third order are kept, so global ones fall as two thirds of the tolerance's order; observed 0.76.
TEST(InelasticFrame, ConvergesWithTheTolerance) {
  const Frame f = make_frame(thesis_plane());
  const auto answer = [&](double tolerance) {
    return peak_drift(simulate(f, frame_pulse(1.3, tolerance), {}, false).summary, 1);
  };
  const double fine = answer(1e-6), coarse = std::abs(answer(1e-4) - fine), middle = std::abs(answer(1e-5) - fine);
  EXPECT_LT(coarse, 5e-4 * fine);
  const double order = std::log10(coarse / middle);
  EXPECT_GT(order, 0.4);
  EXPECT_LT(order, 1.1);
}

/// Sliders on contact points below the joints, which turn with the frame and take the bearings' moments.
scene::Scene on_rigid_bodies(scene::ModelKind kind, double scale) {
  auto s = frame_pulse(scale, 1e-4);
  s.reduced.model = kind;
  s.isolator.space = scene::Space::spatial, s.isolator.points = 8;
  return s;
}

TEST(InelasticFrame, OnRigidBodiesFarFromYieldIsTheLinearBuildingOnThem) {
  PlaneFrame p = thesis_plane();
  p.column.yield_moment = p.beam.yield_moment = 1e9, p.column.axial_yield = p.beam.axial_yield = 1e10;
  const Frame inelastic = make_frame(p);
  for (const auto kind : {scene::ModelKind::dcfp, scene::ModelKind::lir_dcfp}) {
    const auto s = on_rigid_bodies(kind, 0.6);
    const auto run = simulate(inelastic, s);
    const auto &frame = run.summary;
    ASSERT_EQ(frame.status, RunStatus::done) << frame.reason;
    EXPECT_LT(std::abs(frame.energy->imbalance_relative()), 1e-4);
    const Summary linear = buildings::by_implicit_steps(assemble(inelastic), s, 3);
    EXPECT_GT(frame.peak_displacement, 0.05);
    EXPECT_NEAR(frame.peak_displacement / linear.peak_displacement, 1, 0.01) << word(kind);
    for (int floor = 0; floor < 3; ++floor)
      EXPECT_NEAR(peak_drift(frame, floor) / peak_drift(linear, floor), 1, 0.05) << word(kind) << floor;
    for (const double y : run.response.series("floor_1_displacement_y")) EXPECT_EQ(y, 0);
  }
}

TEST(InelasticFrame, YieldsOnRigidBodiesAndDishesSideBySide) {
  Frame f = make_frame(thesis_plane());
  f.nodes[0].bearing = f.nodes[2].bearing = "lir-dcfp"; // the one in the middle has a dish
  const auto lir = on_rigid_bodies(scene::ModelKind::lir_dcfp, 1.1), dish = frame_pulse(1.1, 1e-4);
  const auto run = simulate(f, dish, {lir, dish, lir});
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_GT(run.summary.energy->plastic, 0);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
  const auto &moment = run.response.series("bearing_1_moment_y");
  EXPECT_GT(*std::max_element(moment.begin(), moment.end()), 1e3);
}

TEST(InelasticFrame, AWeakerOneDriftsMore) {
  PlaneFrame p = thesis_plane();
  p.design.overstrength = 0.6;
  const auto s = frame_pulse(1.3, 1e-4);
  const double weak = peak_drift(simulate(make_frame(p), s, {}, false).summary, 0),
               strong = peak_drift(simulate(make_frame(thesis_plane()), s, {}, false).summary, 0);
  EXPECT_GT(weak, 1.1 * strong);
}

TEST(InelasticFrame, DesignScalesWithTheShear) {
  PlaneFrame p = thesis_plane();
  const double before = make_frame(p).sections[0].inelastic->yield_moment;
  p.design.overstrength *= 2;
  EXPECT_NEAR(make_frame(p).sections[0].inelastic->yield_moment, 2 * before, 1e-6 * before);
  p.column.yield_moment = 123e3;
  EXPECT_DOUBLE_EQ(make_frame(p).sections[0].inelastic->yield_moment, 123e3);
}

TEST(InelasticFrame, ItsTablesAreTheFrame) {
  const Frame f = make_frame(thesis_plane());
  const TemporaryFolder folder;
  write_tables(f, folder.path());
  const Frame again = read_tables(folder.path());
  EXPECT_TRUE(again.inelastic());
  EXPECT_EQ(tables_of(again), tables_of(f));
}

TEST(InelasticFrame, RefusesWhatItsPlaneHasNot) {
  const auto refuses = [](const Frame &f, const scene::Scene &s, const std::string &word) {
    try {
      simulate(f, s);
      FAIL() << "taken: " << word;
    } catch (const InputError &error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  auto s = frame_pulse(1, 1e-4);
  s.excitation.direction_deg = 45;
  refuses(make_frame(thesis_plane()), s, "excitation.direction_deg 45");
  s = frame_pulse(1, 1e-4), s.reduced.model = scene::ModelKind::lir_dcfp;
  refuses(make_frame(thesis_plane()), s, "isolator.space = \"spatial\"");
  Frame bent = make_frame(thesis_plane());
  bent.nodes[3].at.y() = 1;
  refuses(bent, frame_pulse(1, 1e-4), "node 4");
  Frame soft = make_frame(thesis_plane());
  soft.sections[0].inelastic->hinge_length = 0.6;
  refuses(soft, frame_pulse(1, 1e-4), "hinge length");
}

TEST(InelasticFrame, FilesSayWhereTheyAreWrong) {
  for (const auto &[text, word] : {std::pair{"load_kN_per_m = 40.0\nx_m = [0.0, 8.0]\nstoreys_m = [3.5]\n[column]\n"
                                             "hinge_length_mm = 700.0\n",
                                             "f.toml:5"},
                                   std::pair{"load_kN_per_m = 40.0\nx_m = [8.0, 0.0]\nstoreys_m = [3.5]\n", "f.toml:2"},
                                   std::pair{"load_kN_per_m = 40.0\n[beam]\nbeta = 0.2\n", "f.toml:3"},
                                   std::pair{"load_kN_per_m = 40.0\n[design]\nshare = 0.2\n", "did you mean"}})
    try {
      make_frame(parse_plane_frame(text, "f.toml"));
      FAIL() << "taken: " << text;
    } catch (const InputError &error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

TEST(InelasticFrame, NamesItsAssumptions) {
  const auto &assumed = make_frame(thesis_plane()).assumed;
  const auto has = [&](const std::string &text) {
    return std::find(assumed.begin(), assumed.end(), text) != assumed.end();
  };
  EXPECT_TRUE(has("column.yield_kN_m by [design]"));
  EXPECT_TRUE(has("design.overstrength = 1.25"));
  EXPECT_FALSE(has("design.shear = 0.17"));
  const auto marked = parse_plane_frame("x_m = [0.0, 8.0]\nstoreys_m = [3.5]\n[design]\nshear = 0.2 # assumption\n"
                                        "[beam]\nyield_kN_m = 5.0\n",
                                        "f.toml")
                          .assumed;
  EXPECT_NE(std::find(marked.begin(), marked.end(), "design.shear = 0.2"), marked.end());
  EXPECT_EQ(std::find(marked.begin(), marked.end(), "beam.yield_kN_m by [design]"), marked.end());
}
