// Serendipity cells against the projection of cells with 27 nodes, and which cells of a bearing they are.
#include "box_mesh.h"
#include "fe_contact/engine/supports.h"
#include "fe_contact/rungs/bearing_model.h"
#include "fe_contact/rungs/catalogue.h"
#include "fe_contact/rungs/rigid_dish.h"
#include "fe_contact/rungs/serendipity_cells.h"

#include <gtest/gtest.h>
#include <random>
#include <set>

namespace rimpact::fe {
namespace {

using meshes::Surface;
using meshes::Volume;

std::vector<char> pads(const Discretisation &space) {
  std::vector<char> result;
  for (const Volume volume : space.volumes) result.push_back(volume == Volume::pad);
  return result;
}

/// Two bodies side by side that share a face's nodes, bent a little unless `straight`: one of cells with 27 nodes, one
/// of serendipity cells, whose top may touch something and whose end is cut.
meshes::HexMesh two_bodies(bool straight = false) {
  meshes::HexMesh mesh;
  test::add_box(
      mesh, {{0, 0, 0}, {0.4, 0.1, 0.1}, {4, 1, 2}, Volume::rim, {{1, Surface::symmetry}, {5, Surface::dish}}},
      [&](std::array<double, 3> x) {
        if (straight) return x;
        return std::array<double, 3>{x[0] + 0.3 * x[1] * x[2], x[1] + 0.2 * x[0] * x[0], x[2] - 0.2 * x[0] * x[1]};
      });
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (cell % 4 >= 2) mesh.volumes[cell] = Volume::pad;
  return mesh;
}

class Serendipity : public ::testing::Test {
protected:
  const meshes::HexMesh mesh_ = two_bodies();
  const Discretisation space_{mesh_, 2, pads}, whole_{mesh_, 2};
  const std::map<Volume, scene::Material> steel_{{Volume::rim, scene::Bearing{}.steel},
                                                 {Volume::pad, scene::Bearing{}.steel}};
  const Solid solid_{space_, steel_}, whole_solid_{whole_, steel_};
  const Equations equations_ = Supports(space_).number(), whole_equations_ = Supports(whole_).number();
  std::mt19937 generator_{1};

  Eigen::VectorXd random(double size) {
    std::normal_distribution<double> normal(0, size);
    return Eigen::VectorXd::NullaryExpr(equations_.n, [&] { return normal(generator_); });
  }
  /// What acts on the nodes of the whole, on the equations of the serendipity mesh.
  Eigen::VectorXd projected(const Eigen::VectorXd &by_dof) const {
    Eigen::VectorXd result(equations_.n);
    for (int k = 0; k < equations_.n; ++k)
      result[k] = equations_.expand(Eigen::VectorXd::Unit(equations_.n, k)).dot(by_dof);
    return result;
  }
  Eigen::VectorXd by_whole_equation(const Eigen::VectorXd &u) const {
    return whole_equations_.gather(equations_.expand(u));
  }
};

TEST_F(Serendipity, ForcesTangentAndMassAreTheProjectionOfThoseOfCellsWith27Nodes) {
  const Eigen::VectorXd u = random(2e-4), direction = random(1);
  SymmetricMatrix tangent(equations_.n, solid_.couplings(equations_));
  SymmetricMatrix whole_tangent(whole_equations_.n, whole_solid_.couplings(whole_equations_));
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations_.n);
  Eigen::VectorXd whole_forces = Eigen::VectorXd::Zero(whole_equations_.n);
  SolidEnergies energies, whole_energies;
  SolidHistory next, whole_next;
  const SolidHistory fresh = solid_.initial_history();
  ASSERT_TRUE(solid_.assemble(equations_.expand(u), fresh, next, equations_, forces, &tangent, energies));
  ASSERT_TRUE(whole_solid_.assemble(whole_equations_.expand(by_whole_equation(u)), fresh, whole_next, whole_equations_,
                                    whole_forces, &whole_tangent, whole_energies));
  ASSERT_GT(energies.plastic, 0);
  EXPECT_NEAR(energies.plastic, whole_energies.plastic, 1e-10 * energies.plastic);
  const auto expect_projected = [&](const Eigen::VectorXd &result, const Eigen::VectorXd &whole) {
    const Eigen::VectorXd expected = projected(whole_equations_.expand(whole)); // every weight is 1
    EXPECT_LT((result - expected).norm(), 1e-10 * expected.norm());
  };
  expect_projected(forces, whole_forces);
  expect_projected(tangent.multiply(direction), whole_tangent.multiply(by_whole_equation(direction)));
  expect_projected(solid_.mass(equations_).multiply(direction),
                   whole_solid_.mass(whole_equations_).multiply(by_whole_equation(direction)));
}

TEST_F(Serendipity, AMiddleStaysWhereANeighbourHas27NodesOrSomethingMayTouch) {
  int left_out = 0;
  for (std::size_t c = 0; c < space_.n_cells; ++c)
    for (int a = 0; a < 27; ++a) {
      const unsigned node = space_.cell_nodes[27 * c + a];
      left_out += space_.is_interpolated[node];
      if (space_.volumes[c] != Volume::pad || middles_of(space_.node_places[a]) < 2) {
        EXPECT_FALSE(space_.is_interpolated[node]);
      }
    }
  // Of four cells: the middle of the one below at the end, which keeps no face's; four faces across the length, of
  // which two are shared; four to the front and the back each, two below, two between the layers.
  EXPECT_EQ(left_out, 1 + (2 * 2 + 2) + 4 + 4 + 2 + 2 * 2);
  for (const Face *face : space_.faces_of(Surface::dish)) EXPECT_FALSE(space_.is_interpolated[face->nodes[4]]);
  for (const Face *face : space_.faces_of(Surface::symmetry)) EXPECT_TRUE(space_.is_interpolated[face->nodes[4]]);
  EXPECT_EQ(equations_.n, 3 * static_cast<int>(space_.n_nodes - space_.interpolated.size()));
}

TEST_F(Serendipity, InterpolatedNodesHaveWhatTheShapesOf20NodesHaveThere) {
  const Discretisation straight(two_bodies(true), 2, pads);
  const Equations equations = Supports(straight).number();
  const auto missed = [&](auto &&field) { // at the nodes, by the field at the others
    Eigen::VectorXd exact(straight.n_dofs());
    for (std::size_t k = 0; k < straight.n_nodes; ++k)
      exact.segment<3>(3 * k).setConstant(field(straight.positions[k] / 0.1));
    return (equations.expand(equations.gather(exact)) - exact).norm() / exact.norm();
  };
  using X = Eigen::Vector3d;
  EXPECT_LT(missed([](const X &x) { return 1 + x[0] * x[0] - x[1] * x[2] + 2 * x[2] * x[2]; }), 1e-13);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(missed([&](const X &x) { return x.prod() * x[i]; }), 1e-13) << "the cell's other quadratic shapes";
  EXPECT_GT(missed([](const X &x) { return x[0] * x[0] * x[2] * x[2]; }), 1e-4) << "only 27 nodes have that one";
}

TEST(SerendipityCells, AreFarFromTheWallsAndNoneIsOfTheRim) {
  meshes::MeshOrder order{.half = true, .rim = true};
  order.level = 0;
  const scene::Bearing bearing;
  for (const auto name : {scene::Rung::rigid_dish, scene::Rung::full}) {
    const Rung *rung = &rung_of(name);
    const BearingModel model(*rung, bearing, order);
    const Discretisation &space = model.space;
    const std::vector<char> chosen = serendipity_cells(space, bearing);
    std::map<Volume, std::array<int, 2>> count;
    for (std::size_t c = 0; c < space.n_cells; ++c) ++count[space.volumes[c]][chosen[c]];
    EXPECT_EQ(count[Volume::rim][1], 0);
    EXPECT_EQ(count[Volume::pad][0], 0);
    EXPECT_EQ(count[Volume::foot][0], 0);
    EXPECT_GT(count[Volume::upper_slider][0], 0);
    EXPECT_GT(count[Volume::upper_slider][1], 0);
    EXPECT_GT(count[Volume::plate][0], 0);
    if (rung->dish == DishKind::solid) {
      EXPECT_GT(count[Volume::plate][1], 0);
    }
    for (const Face &face : space.faces) {
      const bool cut = face.group == Surface::symmetry || face.group == Surface::sector_end;
      if (!cut && face.group != Surface::fixed) {
        EXPECT_FALSE(space.is_interpolated[face.nodes[4]]) << "contacts and loads act on nine nodes";
      }
    }
  }
}

TEST(SerendipityCells, GoAlongWithABodyThatIsMoved) {
  const BearingModel model(rungs::rigid_dish, scene::Bearing{}, {.half = false, .rim = true});
  ASSERT_FALSE(model.space.interpolated.empty());
  BearingSystem system(model, 80e3);
  SystemState state = system.at_rest();
  const Eigen::Vector3d way(0.01, -0.02, 0.03);
  system.set_position(state, way, way, way);
  const Eigen::VectorXd u = system.expand(state);
  std::set<unsigned> of_plate;
  for (std::size_t k = 0; k < model.space.cell_nodes.size(); ++k)
    if (model.space.volumes[k / 27] == Volume::plate) of_plate.insert(model.space.cell_nodes[k]);
  for (const InterpolatedNode &middle : model.space.interpolated) {
    const Eigen::Vector3d expected = of_plate.contains(middle.node) ? Eigen::Vector3d::Zero() : way;
    EXPECT_LT((u.segment<3>(3 * middle.node) - expected).norm(), 1e-15);
  }
}

} // namespace
} // namespace rimpact::fe
