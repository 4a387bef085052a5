// A body that presses on its own image: tangents against differences, and against both bodies solved.
#include "blocks.h"

#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

const FrictionCoefficient friction = FrictionCoefficient::constant(0.3);
const StepOptions closely = [] {
  StepOptions options;
  options.max_augmentations = 20;
  options.gap_tolerance = options.slip_tolerance = 1e-7;
  return options;
}();

/// The lower of two blocks whose faces meet at z = 0.1 m, the upper one its image; a half of it beyond y = 0.
struct LowerBlock {
  explicit LowerBlock(bool half, int degree = 2)
      : space(mesh(half), degree), solid(space, {{Volume::rim, scene::Material{block_modulus, 0.3, 1000, {}, {}}}}),
        supports(space) {
    for (int i = 0; i < 3; ++i) supports.fix(i, [](const Vector3d &x) { return x.z() < 1e-9; });
    const int middle = supports.add_body();
    if (half) {
      supports.fix(1, [](const Vector3d &x) { return x.y() < 1e-9; });
      supports.fix_dof(middle + 1);
    }
    system.emplace(space, solid, supports.number());
    SurfaceContactOptions options{{block_modulus / 0.05, block_modulus / 0.05, friction}};
    options.carrier_faces = Surface::top;
    options.image = OwnImage{{0, 0, 0.1}, {-1, half ? 1.0 : -1.0, -1}, middle};
    system->add_contact(Surface::top, plane({0, 0, 0.1}, Vector3d::UnitZ()), options);
    for (int i = 0; i < 3; ++i) at[i] = system->equations().of_dof[middle + i];
  }
  static meshes::HexMesh mesh(bool half) {
    meshes::HexMesh result;
    test::add_box(
        result,
        {{-0.1, half ? 0.0 : -0.1, 0}, {0.1, 0.1, 0.1}, {4, half ? 2 : 4, 1}, Volume::rim, {{5, Surface::top}}});
    return result;
  }
  /// With the middle driven; the force that it needs, of the whole face [N].
  Vector3d driven_to(SystemState &state, const Vector3d &way) {
    StepTerms terms{Eigen::VectorXd::Zero(system->equations().n)};
    for (int i = 0; i < 3; ++i)
      if (at[i] >= 0) terms.driven.push_back({at[i], way[i]});
    EXPECT_TRUE(static_step(*system, state, terms, closely).converged);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(system->equations().n);
    SurfaceContactState contact = state.contacts[0];
    system->contact(0).assemble(system->expand(state), contact, 0, system->equations(), forces, nullptr);
    Vector3d result = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      if (at[i] >= 0) result[i] = forces[at[i]];
    return result;
  }
  Discretisation space;
  Solid solid;
  Supports supports;
  std::optional<ContactSystem> system;
  int at[3]{};
};

/// Both of them, the upper one's top driven.
struct BothBlocks {
  BothBlocks() : space(mesh(), 2), solid(space, TwoBlocks::materials()), supports(space) {
    for (int i = 0; i < 3; ++i) {
      supports.fix(i, [](const Vector3d &x) { return x.z() < 1e-9; });
      top[i] = supports.tie(i, [](const Vector3d &x) { return x.z() > 0.2 - 1e-9; });
    }
    system.emplace(space, solid, supports.number());
    SurfaceContactOptions options{{block_modulus / 0.05, block_modulus / 0.05, friction}};
    options.carrier_faces = Surface::dish;
    system->add_contact(Surface::slider_side, plane({0, 0, 0.1}, Vector3d::UnitZ()), options);
  }
  static meshes::HexMesh mesh() {
    meshes::HexMesh result;
    test::add_box(result, {{-0.1, -0.1, 0.1}, {0.1, 0.1, 0.2}, {4, 4, 1}, Volume::rim, {{4, Surface::slider_side}}});
    test::add_box(result, {{-0.1, -0.1, 0}, {0.1, 0.1, 0.1}, {4, 4, 1}, Volume::plate, {{5, Surface::dish}}});
    return result;
  }
  Vector3d driven_to(SystemState &state, const Vector3d &way) {
    StepTerms terms{Eigen::VectorXd::Zero(system->equations().n)};
    for (int i = 0; i < 3; ++i) terms.driven.push_back({top[i], way[i]});
    EXPECT_TRUE(static_step(*system, state, terms, closely).converged);
    return -state.reports[0].force;
  }
  Discretisation space;
  Solid solid;
  Supports supports;
  std::optional<ContactSystem> system;
  int top[3]{};
};

struct ImageTangent : ::testing::TestWithParam<std::tuple<bool, int>> {};

TEST_P(ImageTangent, IsTheDerivativeOfTheForces) {
  const auto [half, degree] = GetParam();
  LowerBlock block(half, degree);
  const Equations &equations = block.system->equations();
  SurfaceContact &contact = block.system->contact(0);
  SurfaceContactState state = contact.open(Eigen::VectorXd::Zero(equations.of_dof.size()));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::VectorXd u(equations.n);
  for (int i = 0; i < equations.n; ++i) u[i] = 2e-5 * unit(random);
  u[block.at[0]] = 3e-3; // the faces are past one another's cells
  u[block.at[2]] = -3e-4;
  for (std::size_t k = 0; k < state.start.size(); ++k) {
    state.start[k] = contact.search().relative_position(k, equations.expand(u), -1);
    state.tangential[k] = 6e6 * Vector3d(unit(random), unit(random), unit(random));
  }
  ContactAtU here{contact, state, equations, u};
  ASSERT_NO_FATAL_FAILURE(here.expect_tangent(random));
}
INSTANTIATE_TEST_SUITE_P(HalfAndDegree, ImageTangent, ::testing::Combine(::testing::Bool(), ::testing::Values(1, 2)));

/// Pressed, sheared while the faces stick, then slid, in the end past the edges: as if both blocks were there.
TEST(OwnImage, StandsForTheOtherBlock) {
  BothBlocks both;
  SystemState two = both.system->at_rest();
  for (const bool half : {true, false}) {
    LowerBlock block(half);
    SystemState one = block.system->at_rest();
    SCOPED_TRACE(half ? "half" : "whole");
    two = both.system->at_rest();
    for (const double way : {0.0, 5e-6, 2e-5, 1e-4, 5e-4, 2e-3, 4e-3, 7e-3, 0.01, 0.013}) {
      const Vector3d middle(way, 0, -1e-4), force = (half ? 2 : 1) * block.driven_to(one, middle),
                                            expected = both.driven_to(two, 2 * middle);
      // Beyond a few points' width of the edge it matters which of them bear: in one pass one body's, here both's.
      const double within = way < 1e-3 ? 2e-3 : 0.05;
      EXPECT_NEAR(force.z(), expected.z(), within * std::abs(expected.z())) << way;
      EXPECT_NEAR(force.x() / force.z(), expected.x() / expected.z(), way < 1e-3 ? 0.01 : 0.02) << way;
    }
  }
}

} // namespace
} // namespace rimpact::fe
