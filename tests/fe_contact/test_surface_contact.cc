// Contact of a solid with exact surfaces: tangents against differences, cut-backs, the unsymmetric matrix.
#include "box_mesh.h"
#include "fe_contact/model/contact_steps.h"
#include "fe_contact/model/supports.h"
#include "fe_contact/solver/general_matrix.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace rimpact::fe {
namespace {

using Eigen::Vector3d;
using meshes::Surface;
using meshes::Volume;

constexpr double E = 1e9;

/// A block whose lower face rides on a carried sphere, held by its top.
struct Block {
  explicit Block(const FrictionCoefficient &friction, int degree = 2)
      : space(mesh(), degree), solid(space, {{Volume::rim, scene::Material{E, 0.3, 1000, {}, {}}}}), supports(space) {
    carrier = supports.add_body();
    for (int i = 0; i < 3; ++i) supports.fix(i, [](const Vector3d &x) { return x.z() > 0.1 - 1e-9; });
    system.emplace(space, solid, supports.number());
    SurfaceContactOptions options{{E / 0.05, E / 0.05, friction}};
    options.carrier_dof = carrier;
    system->add_contact(Surface::slider_side, sphere({0.1, 0.05, -20.0}, 20.0, Side::outside), options);
    system->add_mass(carrier, 5.0);
    for (int i = 0; i < 3; ++i) carrier_equations[i] = system->equations().of_dof[carrier + i];
  }
  static meshes::HexMesh mesh() {
    meshes::HexMesh result;
    test::add_box(result, {{0, 0, 0}, {0.2, 0.1, 0.1}, {2, 1, 1}, Volume::rim, {{4, Surface::slider_side}}});
    return result;
  }
  StepTerms drive(double dx, double dz, double dt) const {
    StepTerms terms{Eigen::VectorXd::Zero(system->equations().n)};
    terms.driven = {{carrier_equations[0], dx}, {carrier_equations[1], 0.3 * dx}, {carrier_equations[2], dz}};
    terms.dt = dt;
    return terms;
  }

  Discretisation space;
  Solid solid;
  Supports supports;
  int carrier = -1;
  int carrier_equations[3]{};
  std::optional<ContactSystem> system;
};

struct Tangent : ::testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(Tangent, IsTheDerivativeOfTheForcesWhereSomePointsStickAndOthersSlip) {
  const auto [degree, rate] = GetParam();
  Block block({0.3, rate > 0 ? 0.1 : 0.3, rate}, degree);
  const Equations &equations = block.system->equations();
  SurfaceContact &contact = block.system->contact(0);
  SurfaceContactState state = contact.open(Eigen::VectorXd::Zero(equations.of_dof.size()));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::VectorXd u(equations.n);
  for (int i = 0; i < equations.n; ++i) u[i] = 2e-5 * unit(random);
  for (int i = 0; i < 3; ++i) u[block.carrier_equations[i]] = i == 2 ? 3e-4 : 5e-5;
  for (auto &multiplier : state.tangential) multiplier = 3e5 * Vector3d(unit(random), unit(random), unit(random));

  auto cliques = contact.cliques(equations, equations.expand(u));
  for (int i = 0; i < equations.n; ++i) cliques.push_back({i});
  const SymmetricMatrix pattern(equations.n, cliques);
  GeneralMatrix tangent(pattern);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n);
  const auto report = contact.assemble(equations.expand(u), state, 1e-3, equations, forces, &tangent);
  ASSERT_GT(report.stick, 0);
  ASSERT_GT(report.slip, 0);
  for (int trial = 0; trial < 5; ++trial) {
    Eigen::VectorXd direction(equations.n);
    for (int i = 0; i < equations.n; ++i) direction[i] = unit(random);
    const double h = 1e-10;
    Eigen::VectorXd up = Eigen::VectorXd::Zero(equations.n), down = up;
    contact.assemble(equations.expand(u + h * direction), state, 1e-3, equations, up, nullptr);
    contact.assemble(equations.expand(u - h * direction), state, 1e-3, equations, down, nullptr);
    const Eigen::VectorXd expected = (up - down) / (2 * h);
    EXPECT_LT((tangent.multiply(direction) - expected).norm(), 1e-5 * expected.norm());
  }
  // What the body gets the carrier gives.
  Vector3d on_carrier, on_body = report.force;
  for (int i = 0; i < 3; ++i) on_carrier[i] = -forces[block.carrier_equations[i]];
  contact.assemble(equations.expand(u), state, 1e-3, equations, forces, nullptr);
  EXPECT_LT((on_carrier + on_body).norm(), 1e-9 * on_body.norm());
}
INSTANTIATE_TEST_SUITE_P(DegreeAndRate, Tangent,
                         ::testing::Combine(::testing::Values(1, 2), ::testing::Values(0.0, 20.0)));

/// Three steps of 1 ms pressing and dragging the block; `spoil`: every step is first tried over a far longer way.
SystemState dragged(bool spoil) {
  Block block(FrictionCoefficient::constant(0.3));
  SystemState state = block.system->at_rest();
  for (int k = 1; k <= 3; ++k) {
    if (spoil) {
      SystemState trial = state;
      static_step(*block.system, trial, block.drive(20e-3 * k, 5e-4 * k, 1e-3), {});
    }
    EXPECT_TRUE(static_step(*block.system, state, block.drive(2e-4 * k, 1e-4 * k, 1e-3), {}).converged);
  }
  return state;
}

TEST(CutBack, LeavesNothingBehind) {
  const SystemState straight = dragged(false), cut = dragged(true);
  EXPECT_GT(straight.reports[0].slip, 0);
  EXPECT_LT((straight.u - cut.u).norm(), 1e-8 * straight.u.norm()); // Newton's tolerance: the factor may be another
  EXPECT_LT((straight.reports[0].force - cut.reports[0].force).norm(), 1e-9 * straight.reports[0].force.norm());
}

TEST(CutBack, AFailedStepLeavesTheStateAsItWas) {
  Block block(FrictionCoefficient::constant(0.3));
  SystemState state = block.system->at_rest();
  ASSERT_TRUE(static_step(*block.system, state, block.drive(1e-4, 1e-4, 1e-3), {}).converged);
  const SystemState before = state;
  const auto step = static_step(*block.system, state, block.drive(0, 0.2, 1e-3), {}); // through the whole block
  EXPECT_FALSE(step.converged);
  EXPECT_FALSE(step.reason.empty());
  EXPECT_EQ((state.u - before.u).norm(), 0);
  EXPECT_EQ(state.contacts[0].pressure, before.contacts[0].pressure);
}

TEST(SlidingBlock, PenaltyAndMultiplierAgreeOnTheFrictionForce) {
  for (const int augmentations : {0, 10}) {
    Block block(FrictionCoefficient::constant(0.3));
    SystemState state = block.system->at_rest();
    StepOptions options;
    options.max_augmentations = augmentations;
    for (int k = 1; k <= 4; ++k)
      ASSERT_TRUE(static_step(*block.system, state, block.drive(1e-3 * k, 1e-4, 1e-3), options).converged);
    const Vector3d force = state.reports[0].force;
    // Every point slips: the tangential force is mu times the normal one, but for the sphere's small slope.
    EXPECT_EQ(state.reports[0].stick, 0);
    EXPECT_NEAR(force.head<2>().norm() / force.z(), 0.3, 0.01) << augmentations;
  }
}

/// Two blocks that meet on a sphere of radius 2 m, the lower one's deformed face carrying it; meshes do not match.
struct TwoBlocks {
  explicit TwoBlocks(int degree)
      : space(mesh(), degree),
        solid(space, {{Volume::rim, scene::Material{E, 0.3, 1000, {}, {}}}, {Volume::plate, scene::Material{E, 0.3, 1000, {}, {}}}}),
        supports(space), equations(supports.number()) {
    SurfaceContactOptions options{{E / 0.05, E / 0.05, FrictionCoefficient::constant(0.3)}};
    options.carrier_faces = Surface::dish;
    contact.emplace(space, Surface::slider_side, sphere(Vector3d(0, 0, -2), 2.0, Side::outside), options);
  }
  static meshes::HexMesh mesh() {
    const auto bent = [](std::array<double, 3> x) {
      return std::array<double, 3>{x[0], x[1], x[2] + std::sqrt(4 - x[0] * x[0] - x[1] * x[1]) - 2};
    };
    meshes::HexMesh result;
    test::add_box(result, {{-0.1, -0.1, 0}, {0.1, 0.1, 0.1}, {2, 2, 1}, Volume::rim, {{4, Surface::slider_side}}}, bent);
    test::add_box(result, {{-0.15, -0.15, -0.1}, {0.15, 0.15, 0}, {3, 3, 1}, Volume::plate, {{5, Surface::dish}}}, bent);
    return result;
  }
  /// Upper block moved by `slide`, all nodes off by noise, the lower block sheared.
  Eigen::VectorXd moved(const Vector3d &slide, double noise) const {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    Eigen::VectorXd u(equations.n);
    std::vector<char> upper(space.n_nodes, 0);
    for (std::size_t c = 0; c < space.n_cells; ++c)
      for (int a = 0; a < space.nodes_per_cell; ++a)
        upper[space.cell_nodes[c * space.nodes_per_cell + a]] = space.volumes[c] == Volume::rim;
    for (std::size_t a = 0; a < space.n_nodes; ++a) {
      const Vector3d x = space.positions[a];
      u.segment<3>(3 * a) = (upper[a] ? slide : Vector3d(0.02 * x.z(), 0, 0.01 * x.x())) +
                            noise * Vector3d(unit(random), unit(random), unit(random));
    }
    return u;
  }
  Discretisation space;
  Solid solid;
  Supports supports;
  Equations equations;
  std::optional<SurfaceContact> contact;
};

struct Carried : ::testing::TestWithParam<int> {};

TEST_P(Carried, TangentIsTheDerivativeAndActionIsReaction) {
  TwoBlocks blocks(GetParam());
  SurfaceContact &contact = *blocks.contact;
  const Equations &equations = blocks.equations;
  const Eigen::VectorXd u = blocks.moved({0.021, -0.013, -4e-4}, 2e-5);
  SurfaceContactState state = contact.open(blocks.moved({0.0209, -0.013, 0}, 0));
  auto cliques = contact.cliques(equations, u);
  for (int i = 0; i < equations.n; ++i) cliques.push_back({i});
  const SymmetricMatrix pattern(equations.n, cliques);
  GeneralMatrix tangent(pattern);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n);
  const auto report = contact.assemble(u, state, 1e-3, equations, forces, &tangent);
  ASSERT_TRUE(report.pattern_holds);
  ASSERT_GT(report.stick, 0);
  ASSERT_GT(report.slip, 0);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t a = 0; a < blocks.space.n_nodes; ++a) sum += forces.segment<3>(3 * a);
  EXPECT_LT(sum.norm(), 1e-9 * report.force.norm());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 3; ++trial) {
    Eigen::VectorXd direction(equations.n);
    for (int i = 0; i < equations.n; ++i) direction[i] = unit(random);
    const double h = 1e-10;
    Eigen::VectorXd up = Eigen::VectorXd::Zero(equations.n), down = up;
    contact.assemble(u + h * direction, state, 1e-3, equations, up, nullptr);
    contact.assemble(u - h * direction, state, 1e-3, equations, down, nullptr);
    const Eigen::VectorXd expected = (up - down) / (2 * h);
    // The turning of the normal by the carrier's own strain is left out: penetration over cell size, 0.8 % here.
    EXPECT_LT((tangent.multiply(direction) - expected).norm(), 1e-2 * expected.norm());
  }
}
INSTANTIATE_TEST_SUITE_P(Degree, Carried, ::testing::Values(1, 2));

TEST(Carried, MovedTogetherNothingSlips) {
  TwoBlocks blocks(2);
  SurfaceContactState state = blocks.contact->open(blocks.moved({0.021, 0, -1e-4}, 0));
  Eigen::VectorXd u = blocks.moved({0.021, 0, -1e-4}, 0);
  for (std::size_t a = 0; a < blocks.space.n_nodes; ++a) u.segment<3>(3 * a) += Vector3d(0.3, -0.2, 0.05);
  blocks.contact->cliques(blocks.equations, u);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(blocks.equations.n);
  const auto report = blocks.contact->assemble(u, state, 1e-3, blocks.equations, forces, nullptr);
  EXPECT_GT(report.stick, 0);
  EXPECT_EQ(report.slip, 0);
  EXPECT_LT(report.force.head<2>().norm(), 0.06 * report.force.z()); // the sphere's slope there is 0.01
}

TEST(GeneralMatrix, MultipliesSolvesAndRefusesEntriesOutsideItsPattern) {
  const SymmetricMatrix pattern(4, {{0, 1, 2}, {2, 3}});
  GeneralMatrix matrix(pattern);
  Eigen::Matrix4d dense = Eigen::Matrix4d::Zero();
  for (const auto &[i, j, value] : std::vector<std::tuple<int, int, double>>{
           {0, 0, 4}, {0, 1, 1}, {1, 0, -2}, {1, 1, 5}, {2, 2, 3}, {2, 3, 1}, {3, 2, 0.5}, {3, 3, 6}, {0, 2, 0.7}}) {
    matrix.add(i, j, value);
    dense(i, j) += value;
  }
  const Eigen::Vector4d x(1, -2, 0.5, 3);
  EXPECT_LT((matrix.multiply(x) - dense * x).norm(), 1e-14);
  EXPECT_THROW(matrix.add(0, 3, 1.0), std::logic_error);
  matrix.make_unit_row(1, 2.0);
  dense.row(1) << 0, 2, 0, 0;
  EXPECT_LT((matrix.multiply(x) - dense * x).norm(), 1e-14);
}

} // namespace
} // namespace rimpact::fe
