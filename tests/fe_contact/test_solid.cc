// Assembly of solids and of wall contact against independent numbers: patch, mass, differences.
#include "box_mesh.h"
#include "fe_contact/engine/solid_fields.h"

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace rimpact::fe {
namespace {

using meshes::Surface;
using meshes::Volume;

Equations all_free(const Discretisation &space) {
  Equations equations;
  equations.n = space.n_dofs();
  equations.weight.assign(equations.n, 1.0);
  for (int i = 0; i < equations.n; ++i) equations.of_dof.push_back(i);
  return equations;
}

/// A box bent a little, so that cells are not parallelepipeds.
meshes::HexMesh bent_box() {
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, 0}, {0.2, 0.1, 0.1}, {2, 1, 2}, Volume::rim, {}}, [](std::array<double, 3> x) {
    return std::array<double, 3>{x[0] + 0.3 * x[1] * x[2], x[1] + 0.5 * x[0] * x[0], x[2] - 0.4 * x[0] * x[1]};
  });
  return mesh;
}

class SolidTest : public ::testing::TestWithParam<int> {};

TEST(SolidOfParts, EachVolumeHasTheSteelOfItsPart) {
  scene::Bearing bearing;
  double yield = 300e6;
  std::map<scene::SteelPart, double> yields;
  for (const auto part : {scene::SteelPart::rim, scene::SteelPart::dish, scene::SteelPart::slider}) {
    yields[part] = yield += 100e6;
    bearing.part_steels.emplace(part, bearing.steel).first->second.yield = yield;
  }
  const std::map<Volume, scene::SteelPart> parts{{Volume::rim, scene::SteelPart::rim},
                                                 {Volume::plate, scene::SteelPart::dish},
                                                 {Volume::foot, scene::SteelPart::slider},
                                                 {Volume::upper_slider, scene::SteelPart::slider}};
  for (const auto &[volume, part] : parts) {
    meshes::HexMesh mesh;
    test::add_box(mesh, {{0, 0, 0}, {0.1, 0.1, 0.1}, {1, 1, 1}, volume, {}});
    const Discretisation space(mesh, 1);
    EXPECT_EQ(Solid(space, bearing).law_of(0).isochoric.hardening.stress(0), yields[part]);
  }
}

TEST_P(SolidTest, FieldsShowTheStressOfAUniformStretch) {
  const Discretisation space(bent_box(), GetParam());
  const scene::Material steel = scene::Bearing{}.steel;
  const Solid solid(space, scene::Bearing{});
  constexpr double stretch = 5e-4; // along x, held across
  Eigen::VectorXd u = Eigen::VectorXd::Zero(space.n_dofs());
  for (std::size_t a = 0; a < space.n_nodes; ++a) u[3 * a] = stretch * space.positions[a].x();
  const SolidFields fields = fields_of(solid, space, u, solid.initial_history());
  const double K = steel.E / (3 * (1 - 2 * steel.nu)), G = steel.E / (2 * (1 + steel.nu)), l = std::log1p(stretch);
  const double along = (K + 4 * G / 3) * l / (1 + stretch), across = (K - 2 * G / 3) * l / (1 + stretch);
  for (std::size_t c = 0; c < space.n_cells; ++c) {
    const double expected[] = {along, across, across, 0, 0, 0};
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(fields.stress[i][c], expected[i], 1e-9 * along) << i;
    EXPECT_NEAR(fields.von_mises[c], 2 * G * l / (1 + stretch), 1e-9 * along);
  }
}

TEST_P(SolidTest, UniformDeformationGivesUniformStressOnABentMesh) {
  const Discretisation space(bent_box(), GetParam());
  const Solid solid(space, scene::Bearing{});
  const Equations equations = all_free(space);
  Matrix3 gradient;
  gradient << 1e-4, 2e-4, 0, -1e-4, 3e-4, 1e-4, 0, 0, -2e-4;
  Eigen::VectorXd u(space.n_dofs());
  for (std::size_t a = 0; a < space.n_nodes; ++a) u.segment<3>(3 * a) = gradient * space.positions[a];
  SolidHistory next;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n);
  SolidEnergies energies;
  ASSERT_TRUE(solid.assemble(u, solid.initial_history(), next, equations, forces, nullptr, energies));
  // The energy density of a uniform strain times the volume, by the law itself.
  const scene::Material steel = scene::Bearing{}.steel;
  const Matrix3 F = Matrix3::Identity() + gradient;
  const double density =
      HenckyJ2::from(steel).step(J2State{}, F).energy + HenckyVolumetric::from(steel).at(F.determinant()).energy;
  double volume = 0;
  for (const double w : space.full.weights) volume += w;
  EXPECT_NEAR(energies.elastic, density * volume,
              1e-3 * density * volume); // the reduced rule integrates a bent volume closely, not exactly
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t a = 0; a < space.n_nodes; ++a) sum += forces.segment<3>(3 * a);
  EXPECT_LT(sum.norm(), 1e-9 * forces.norm());
}

TEST_P(SolidTest, TangentAgreesWithDifferencesInThePlasticRange) {
  const Discretisation space(bent_box(), GetParam());
  const Solid solid(space, scene::Bearing{});
  const Equations equations = all_free(space);
  std::mt19937 generator(1);
  std::normal_distribution<double> normal(0, 2e-4);
  Eigen::VectorXd u(space.n_dofs()), direction(space.n_dofs());
  for (auto &value : u) value = normal(generator);
  for (auto &value : direction) value = normal(generator);
  SymmetricMatrix tangent(equations.n, solid.couplings(equations));
  SolidHistory next;
  SolidEnergies energies;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n), plus = forces, minus = forces;
  ASSERT_TRUE(solid.assemble(u, solid.initial_history(), next, equations, forces, &tangent, energies));
  EXPECT_GT(energies.plastic, 0);
  const double h = 1e-4;
  ASSERT_TRUE(solid.assemble(u + h * direction, solid.initial_history(), next, equations, plus, nullptr, energies));
  ASSERT_TRUE(solid.assemble(u - h * direction, solid.initial_history(), next, equations, minus, nullptr, energies));
  const Eigen::VectorXd difference = (plus - minus) / (2 * h), exact = tangent.multiply(direction);
  EXPECT_LT((difference - exact).norm(), 1e-5 * exact.norm());
}

TEST_P(SolidTest, MassMovesAsARigidBody) {
  const Discretisation space(bent_box(), GetParam());
  const Solid solid(space, scene::Bearing{});
  const Equations equations = all_free(space);
  const SymmetricMatrix mass = solid.mass(equations);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(equations.n);
  for (std::size_t a = 0; a < space.n_nodes; ++a) v.segment<3>(3 * a) = Eigen::Vector3d(1, 2, 3);
  EXPECT_NEAR(v.dot(mass.multiply(v)), 14 * solid.mass_of(Volume::rim), 1e-9 * 14 * solid.mass_of(Volume::rim));
}

/// Assembles at a stretch along x of a box; the tangent's values.
std::vector<double> tangent_at(const Discretisation &space, const Solid &solid, double stretch,
                               Eigen::VectorXd &forces) {
  const Equations equations = all_free(space);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(space.n_dofs());
  for (std::size_t a = 0; a < space.n_nodes; ++a) u[3 * a] = stretch * space.positions[a].x();
  SymmetricMatrix tangent(equations.n, solid.couplings(equations));
  SolidHistory next;
  SolidEnergies energies;
  forces = Eigen::VectorXd::Zero(equations.n);
  EXPECT_TRUE(solid.assemble(u, solid.initial_history(), next, equations, forces, &tangent, energies));
  return tangent.values();
}

TEST_P(SolidTest, ATangentIsKeptWhileACellHardlyDeforms) {
  const Discretisation space(bent_box(), GetParam());
  const Solid kept(space, scene::Bearing{}), fresh(space, scene::Bearing{});
  Eigen::VectorXd forces, forces_afresh;
  const double elastic = 5e-4, past = 2.5 * KeptTangents::as_before; // steel yields at 1.8e-3
  const auto first = tangent_at(space, kept, 0, forces);
  EXPECT_EQ(tangent_at(space, kept, elastic, forces), first);
  const auto other = tangent_at(space, fresh, elastic, forces_afresh);
  EXPECT_NE(other, first);
  EXPECT_LT((forces - forces_afresh).norm(), 1e-14 * forces.norm()) << "residuals are exact, to rounding";
  kept.forget_tangents();
  EXPECT_EQ(tangent_at(space, kept, elastic, forces), other);
  fresh.forget_tangents();
  const auto flowing = tangent_at(space, fresh, past, forces_afresh);
  EXPECT_EQ(tangent_at(space, kept, past, forces), flowing);
  EXPECT_EQ(tangent_at(space, kept, past * 1.01, forces), tangent_at(space, fresh, past * 1.01, forces_afresh));
  EXPECT_NE(tangent_at(space, kept, past * 1.02, forces), flowing) << "a cell that flows gets its own";
}

INSTANTIATE_TEST_SUITE_P(Degrees, SolidTest, ::testing::Values(1, 2));

/// A block resting askew on another with a non-matching mesh.

} // namespace
} // namespace rimpact::fe
