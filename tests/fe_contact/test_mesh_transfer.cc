// What a new mesh of the same bearing takes over from an old one.
#include "fe_contact/engine/mesh_transfer.h"
#include "meshes/stack_mesh.h"
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

meshes::MeshOrder draft(const std::vector<double> &directions) {
  meshes::MeshOrder options;
  options.level = 0, options.half = false, options.rim = true, options.directions = directions;
  return options;
}

Eigen::Vector3d field(const Eigen::Vector3d &x) {
  return {1 + 2 * x.x() - x.y(), x.z() - 3, 0.5 * x.x() + x.z()};
}

class MeshesOfOneBearing : public testing::Test {
protected:
  const scene::Bearing bearing_;
  const Discretisation before_{meshes::stack_mesh(bearing_, draft({0})), 2},
      after_{meshes::stack_mesh(bearing_, draft({0, 1.3})), 2};
  const MeshTransfer transfer_{before_, after_};
};

TEST_F(MeshesOfOneBearing, ALinearFieldIsCarriedOverAndWhatIsNewIsAsMade) {
  Eigen::VectorXd values(before_.n_dofs());
  for (std::size_t k = 0; k < before_.n_nodes; ++k) values.segment<3>(3 * k) = field(before_.positions[k]);
  const Eigen::VectorXd carried = transfer_.nodal(values);
  int none = 0;
  for (std::size_t k = 0; k < after_.n_nodes; ++k) {
    const Eigen::Vector3d x = after_.positions[k], u = carried.segment<3>(3 * k);
    if (x.head<2>().norm() > 0.43 && std::abs(std::atan2(x.y(), x.x())) > 1.02) {
      none += u.norm() == 0;
      EXPECT_EQ(u.norm(), 0) << x.transpose();
    } else if (x.head<2>().norm() < 0.43) {
      EXPECT_LT((u - field(x)).norm(), 1e-9) << x.transpose();
    }
  }
  EXPECT_GT(none, 500);
}

TEST_F(MeshesOfOneBearing, MaterialMemoryStaysWhereItIsInPadFootAndTheOldDent) {
  const auto strain = [](const Eigen::Vector3d &x) { return 0.01 + 0.001 * x.x() + 0.002 * x.y() + 0.003 * x.z(); };
  const auto place = [](const Discretisation &space, std::size_t k) {
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (int a = 0; a < 27; ++a)
      x += space.full_values[k % 27 * 27 + a] * space.positions[space.cell_nodes[k / 27 * 27 + a]];
    return x;
  };
  SolidHistory old(27 * before_.n_cells);
  for (std::size_t k = 0; k < old.size(); ++k) old[k].alpha = strain(place(before_, k));
  const SolidHistory carried = transfer_.history(old);
  ASSERT_EQ(carried.size(), 27 * after_.n_cells);
  int same = 0, initial_history = 0;
  for (std::size_t k = 0; k < carried.size(); ++k) {
    const Eigen::Vector3d x = place(after_, k);
    const auto volume = after_.volumes[k / 27];
    const double angle = std::abs(std::atan2(x.y(), x.x())), r = x.head<2>().norm();
    const bool dent = r > 0.43 && angle < 0.03,
               kept = volume == meshes::Volume::pad || volume == meshes::Volume::foot || dent;
    if (kept) {
      EXPECT_NEAR(carried[k].alpha, strain(x), 1e-12) << x.transpose();
    }
    if (r > 0.43 && angle > 1.02) {
      EXPECT_EQ(carried[k].alpha, 0);
    }
    same += kept, initial_history += carried[k].alpha == 0;
  }
  EXPECT_GT(same, 1000);
  EXPECT_GT(initial_history, 1000);
}

} // namespace
} // namespace rimpact::fe
