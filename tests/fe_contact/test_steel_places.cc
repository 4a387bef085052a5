// Where the steel was strained, under which triaxiality, and how near it is to a crack.
#include "box_mesh.h"
#include "fe_contact/drive/steel_places.h"
#include "fe_contact/laws/crack_measure.h"
#include "meshes/rim_mesh.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

using meshes::Volume;

TEST(CrackMeasure, IsJohnsonAndCooksAndEndsInCompression) {
  const CrackMeasure steel;
  EXPECT_NEAR(steel.fracture_strain(0), 0.0705 + 1.732, 1e-12);
  EXPECT_NEAR(steel.fracture_strain(1.0 / 3), 0.0705 + 1.732 * std::exp(-0.18), 1e-12);
  EXPECT_TRUE(std::isfinite(steel.fracture_strain(-0.33)));
  EXPECT_TRUE(std::isinf(steel.fracture_strain(-0.34)));
  const CrackMeasure own({.D1 = 0.05, .D2 = 3.44, .D3 = -2.12});
  EXPECT_NEAR(own.fracture_strain(1), 0.05 + 3.44 * std::exp(-2.12), 1e-12);
}

TEST(CrackMeasure, LocusOfBaoAndWierzbickiIsWholeAndEndsInCompression) {
  const CrackMeasure own({.C1 = 0.27, .C2 = 0.47});
  EXPECT_DOUBLE_EQ(own.locus_strain(0), 0.27);
  EXPECT_DOUBLE_EQ(own.locus_strain(1.0 / 3), 0.47);
  EXPECT_DOUBLE_EQ(own.locus_strain(1.0), 0.47 / 3);
  EXPECT_NEAR(own.locus_strain(1.0 / 6), 0.27 + 0.20 / 4, 1e-12);
  EXPECT_NEAR(own.locus_strain(-1.0 / 6), 2 * 0.27, 1e-12);
  EXPECT_TRUE(std::isinf(own.locus_strain(-0.34)));
  for (const double joint :
       {-1.0 / 3 + 1e-6, 0.0, 1.0 / 3}) // no branch jumps to the next; at the cut-off it grows without end
    EXPECT_NEAR(own.locus_strain(joint + 1e-12) / own.locus_strain(joint), 1, 1e-5) << joint;
  EXPECT_GT(own.locus_strain(-1.0 / 3 + 1e-6), 1e4);
  // Estimated: in tension Johnson and Cook's, in shear where sigma / sqrt(3) there is sigma / 2 here for sigma = K
  // eps^0.2.
  const CrackMeasure weldox;
  const double tension = weldox.locus_strain(1.0 / 3), shear = weldox.locus_strain(0);
  EXPECT_NEAR(tension, weldox.fracture_strain(1.0 / 3), 1e-12);
  EXPECT_NEAR(std::pow(shear, 0.2) / std::sqrt(3.0), std::pow(tension, 0.2) / 2, 1e-12);
}

class Remembered : public ::testing::TestWithParam<int> {};

/// A uniform stretch held across: mean stress kappa ln J over the flow stress, at every point of a bent mesh alike.
TEST_P(Remembered, TriaxialityAndDamageOfAUniformStretch) {
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, 0}, {0.2, 0.1, 0.1}, {2, 1, 2}, Volume::rim, {}}, [](std::array<double, 3> x) {
    return std::array<double, 3>{x[0] + 0.3 * x[1] * x[2], x[1] + 0.5 * x[0] * x[0], x[2] - 0.4 * x[0] * x[1]};
  });
  const Discretisation space(mesh, GetParam());
  const scene::Material steel = scene::Bearing{}.steel;
  const Solid solid(space, scene::Bearing{});
  Equations equations;
  equations.n = static_cast<int>(space.n_dofs());
  for (int k = 0; k < equations.n; ++k) equations.of_dof.push_back(k), equations.weight.push_back(1);
  SolidHistory history = solid.initial_history();
  double triaxiality = 0, damage = 0, locus_damage = 0;
  for (const double stretch : {0.01, 0.02}) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(space.n_dofs()), forces = Eigen::VectorXd::Zero(equations.n);
    for (std::size_t a = 0; a < space.n_nodes; ++a) u[3 * a] = stretch * space.positions[a].x();
    SolidEnergies energies;
    SolidHistory next;
    ASSERT_TRUE(solid.assemble(u, history, next, equations, forces, nullptr, energies));
    const double K = steel.E / (3 * (1 - 2 * steel.nu)), before = history[0].alpha, flow = next[0].alpha - before;
    const double eta = K * std::log1p(stretch) / (*steel.yield + scene::hardening_modulus(steel) * next[0].alpha);
    triaxiality += eta * flow, damage += flow / CrackMeasure{}.fracture_strain(eta);
    locus_damage += flow / CrackMeasure{}.locus_strain(eta);
    history = next;
  }
  ASSERT_GT(triaxiality, 0);
  for (const J2State &point : history) {
    EXPECT_NEAR(point.triaxiality, triaxiality, 1e-9 * triaxiality);
    EXPECT_NEAR(point.damage, damage, 1e-9 * damage);
    EXPECT_NEAR(point.locus_damage, locus_damage, 1e-9 * locus_damage);
    EXPECT_NEAR(point.lode, point.alpha, 1e-9 * point.alpha); // a stretch along one axis: 1
  }
}
INSTANTIATE_TEST_SUITE_P(Degrees, Remembered, ::testing::Values(1, 2));

TEST(SteelPlaces, EachPartIsToldApartAndASpikeIsAveraged) {
  const scene::Bearing bearing;
  meshes::MeshOrder order;
  order.level = 0, order.half = true;
  const Discretisation space(meshes::rim_mesh(bearing, order), 2);
  SolidHistory history(space.n_cells * 27);
  const std::map<Volume, double> strains{{Volume::plate, 0.02}, {Volume::rim, 0.02}, {Volume::upper_slider, 0.04}};
  for (std::size_t c = 0; c < space.n_cells; ++c)
    for (int q = 0; q < 27; ++q) {
      J2State &point = history[27 * c + q];
      point.alpha = strains.at(space.volumes[c]), point.damage = 2 * point.alpha, point.lode = -0.5 * point.alpha;
      point.locus_damage = 3 * point.alpha;
    }
  const SteelReport even = steel_by_place(space, bearing, history);
  ASSERT_EQ(even.size(), 4u);
  for (const auto &[place, strain] : {std::pair{SteelPlace::dish, 0.02},
                                      {SteelPlace::rim_root, 0.02},
                                      {SteelPlace::rim_wall, 0.02},
                                      {SteelPlace::slider_edge, 0.04}}) {
    EXPECT_EQ(even.at(place).largest, strain) << word(place);
    EXPECT_NEAR(even.at(place).averaged, strain, 1e-12) << word(place);
    EXPECT_NEAR(even.at(place).averaged_damage, 2 * strain, 1e-12) << word(place);
    EXPECT_NEAR(even.at(place).averaged_locus_damage, 3 * strain, 1e-12) << word(place);
    EXPECT_NEAR(even.at(place).lode, -0.5, 1e-12) << word(place);
  }
  // A point of the rim's highest cell.
  std::size_t spike = 0;
  double highest = 0;
  for (std::size_t c = 0; c < space.n_cells; ++c)
    if (const double z = space.positions[space.cell_nodes[27 * c]].z(); space.volumes[c] == Volume::rim && z > highest)
      highest = z, spike = 27 * c;
  history[spike].alpha = 0.5, history[spike].triaxiality = 0.1, history[spike].damage = 0.3;
  history[spike].locus_damage = 0.9;
  const SteelReport spiked = steel_by_place(space, bearing, history);
  const SteelAtPlace &wall = spiked.at(SteelPlace::rim_wall);
  EXPECT_EQ(wall.largest, 0.5);
  EXPECT_GT(wall.averaged, 0.02);
  EXPECT_LE(wall.averaged, 0.5);
  EXPECT_NEAR(wall.triaxiality, 0.2, 1e-12);
  EXPECT_EQ(wall.damage, 0.3);
  EXPECT_GT(wall.averaged_damage, 0.04);
  EXPECT_LT(wall.averaged_damage, 0.3);
  EXPECT_EQ(wall.locus_damage, 0.9);
  EXPECT_GT(wall.averaged_locus_damage, 0.06);
  EXPECT_LT(wall.averaged_locus_damage, 0.9);
  EXPECT_NEAR(std::hypot(wall.place.x(), wall.place.y()), bearing.surface.planar_radius + bearing.rim.ledge, 0.05);
  EXPECT_EQ(spiked.at(SteelPlace::rim_root).largest, 0.02);
  EXPECT_EQ(judged_strain(spiked, {})->place, SteelPlace::rim_wall);
}

} // namespace
} // namespace rimpact::fe
