// Cells of fewer nodes than 27 are completed.
#include "meshes/cell_nodes.h"
#include "meshes/hex_order.h"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace rimpact::meshes {
namespace {

/// Corners, edges and the rest of a cell under a quadratic map: 20 nodes determine it but for the highest products.
TEST(CellNodes, TwentyNodesAreCompletedBySerendipity) {
  const auto place = [](double x, double y, double z) {
    return std::array{x + 0.1 * y * y, y + 0.05 * x * z, z + 0.1 * x * y};
  };
  HexMesh mesh;
  std::vector<unsigned> twenty;
  for (int a = 0; a < 20; ++a) {
    mesh.nodes.push_back(place(hex27[a][0], hex27[a][1], hex27[a][2]));
    twenty.push_back(a);
  }
  CellNodes complete(mesh);
  const auto cell = complete(twenty);
  for (int a = 20; a < 27; ++a) {
    const auto wanted = place(hex27[a][0], hex27[a][1], hex27[a][2]);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(mesh.nodes[cell[a]][i], wanted[i], 1e-14) << a;
  }
}

} // namespace
} // namespace rimpact::meshes
