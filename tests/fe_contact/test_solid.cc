// Assembly of solids and of wall contact against independent numbers: patch, mass, differences.
#include "box_mesh.h"
#include "fe_contact/model/solid.h"
#include "fe_contact/model/wall_contact.h"

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
    return std::array<double, 3>{x[0] + 0.3 * x[1] * x[2], x[1] + 0.5 * x[0] * x[0],
                                 x[2] - 0.4 * x[0] * x[1]};
  });
  return mesh;
}

class SolidTest : public ::testing::TestWithParam<int> {};

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
  ASSERT_TRUE(solid.assemble(u, solid.virgin(), next, equations, forces, nullptr, energies));
  // The energy density of a uniform strain times the volume, by the law itself.
  const scene::Material steel = scene::Bearing{}.steel;
  const Matrix3 F = Matrix3::Identity() + gradient;
  const double density = HenckyJ2::from(steel).step(J2State{}, F).energy +
                         HenckyVolumetric::from(steel).at(F.determinant()).energy;
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
  SymmetricMatrix tangent(equations.n, solid.cliques(equations));
  SolidHistory next;
  SolidEnergies energies;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n), plus = forces, minus = forces;
  ASSERT_TRUE(solid.assemble(u, solid.virgin(), next, equations, forces, &tangent, energies));
  EXPECT_GT(energies.plastic, 0);
  const double h = 1e-4;
  ASSERT_TRUE(solid.assemble(u + h * direction, solid.virgin(), next, equations, plus, nullptr, energies));
  ASSERT_TRUE(solid.assemble(u - h * direction, solid.virgin(), next, equations, minus, nullptr, energies));
  const Eigen::VectorXd difference = (plus - minus) / (2 * h), exact = tangent.multiply(direction);
  EXPECT_LT((difference - exact).norm(), 1e-5 * exact.norm());
}

TEST_P(SolidTest, MassMovesAsARigidBody) {
  const Discretisation space(bent_box(), GetParam());
  const Solid solid(space, scene::Bearing{});
  const Equations equations = all_free(space);
  SymmetricMatrix mass(equations.n, solid.cliques(equations));
  solid.add_mass(equations, mass);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(equations.n);
  for (std::size_t a = 0; a < space.n_nodes; ++a) v.segment<3>(3 * a) = Eigen::Vector3d(1, 2, 3);
  EXPECT_NEAR(v.dot(mass.multiply(v)), 14 * solid.mass_of(Volume::rim),
              1e-9 * 14 * solid.mass_of(Volume::rim));
}

INSTANTIATE_TEST_SUITE_P(Degrees, SolidTest, ::testing::Values(1, 2));

/// A block resting askew on another with a non-matching mesh.
meshes::HexMesh two_blocks() {
  meshes::HexMesh mesh;
  test::add_box(
      mesh, {{0, 0, 0}, {0.1, 0.1, 0.05}, {3, 2, 1}, Volume::rim, {{5, Surface::rim_wall}}},
      [](std::array<double, 3> x) {
        return std::array<double, 3>{x[0], x[1], x[2] + 0.4 * x[2] / 0.05 * (x[0] - 0.05) * (x[0] - 0.05)};
      });
  test::add_box(mesh, {{0.013, 0.011, 0.05},
                       {0.083, 0.087, 0.09},
                       {2, 2, 1},
                       Volume::upper_slider,
                       {{4, Surface::slider_side}}});
  return mesh;
}

/// Moves all nodes of one body.
void move(const Discretisation &space, Volume volume, const Eigen::Vector3d &by, Eigen::VectorXd &u) {
  std::set<unsigned> nodes;
  for (std::size_t c = 0; c < space.n_cells; ++c)
    if (space.volumes[c] == volume)
      nodes.insert(&space.cell_nodes[c * space.nodes_per_cell],
                   &space.cell_nodes[(c + 1) * space.nodes_per_cell]);
  for (const unsigned node : nodes) u.segment<3>(3 * node) += by;
}

TEST(WallContact, ForcesBalanceAndTangentAgreesWithDifferences) {
  const Discretisation space(two_blocks(), 2);
  const WallContact contact(space, Surface::slider_side, Surface::rim_wall, {});
  const Equations equations = all_free(space);
  std::mt19937 generator(2);
  std::normal_distribution<double> normal(0, 1e-5);
  Eigen::VectorXd u(space.n_dofs()), direction(space.n_dofs());
  for (auto &value : u) value = normal(generator);
  for (auto &value : direction) value = normal(generator);
  move(space, Volume::upper_slider, {0, 0, -3e-4}, u); // pressed in by more than the roughness
  SymmetricMatrix tangent(equations.n, contact.cliques(u, equations));
  ContactState state = contact.open();
  contact.settle_edges(u, state);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n), plus = forces, minus = forces;
  const auto report = contact.assemble(u, state, equations, &forces, &tangent);
  ASSERT_GT(report.active, 10);
  ASSERT_TRUE(report.pattern_holds);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), moment = sum;
  for (std::size_t a = 0; a < space.n_nodes; ++a) {
    sum += forces.segment<3>(3 * a);
    const Eigen::Vector3d x = space.positions[a] + u.segment<3>(3 * a), f = forces.segment<3>(3 * a);
    moment += Eigen::Vector3d(x.y() * f.z() - x.z() * f.y(), x.z() * f.x() - x.x() * f.z(),
                              x.x() * f.y() - x.y() * f.x());
  }
  EXPECT_LT(sum.norm(), 1e-10 * forces.norm());
  EXPECT_LT(moment.norm(), 1e-10 * forces.norm());
  const double h = 1e-4;
  contact.assemble(u + h * direction, state, equations, &plus, nullptr);
  contact.assemble(u - h * direction, state, equations, &minus, nullptr);
  const Eigen::VectorXd difference = (plus - minus) / (2 * h), exact = tangent.multiply(direction);
  EXPECT_LT((difference - exact).norm(), 1e-6 * exact.norm());
}

TEST(WallContact, NothingOppositeGivesNothing) {
  const Discretisation space(two_blocks(), 2);
  const WallContact contact(space, Surface::slider_side, Surface::rim_wall, {});
  const Equations equations = all_free(space);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(space.n_dofs());
  move(space, Volume::upper_slider, {0.5, 0, -3e-4}, u); // far off the master's edge
  ContactState state = contact.open();
  contact.settle_edges(u, state);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n);
  const auto report = contact.assemble(u, state, equations, &forces, nullptr);
  EXPECT_EQ(report.active, 0);
  EXPECT_EQ(forces.norm(), 0);
}

} // namespace
} // namespace rimpact::fe
