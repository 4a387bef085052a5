// The stack's mesh: volumes, tied and touching parts, nodes on the exact sphere of cap and socket.
#include "meshes/stack_mesh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace rimpact::meshes {
namespace {

std::set<unsigned> nodes_of(const HexMesh &mesh, Volume volume) {
  std::set<unsigned> result;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.volumes[c] == volume) result.insert(mesh.cells[c].begin(), mesh.cells[c].end());
  return result;
}

TEST(StackMesh, PadAndFootShareTheSeatAndNothingElse) {
  const HexMesh mesh = stack_mesh(scene::Bearing{}, {});
  const auto pad = nodes_of(mesh, Volume::pad), foot = nodes_of(mesh, Volume::foot);
  int shared = 0;
  for (const unsigned node : pad) {
    const auto &x = mesh.nodes[node];
    const bool on_the_seat = std::abs(x[2] - 0.040) < 1e-9;
    EXPECT_EQ(foot.count(node) > 0, on_the_seat) << x[0] << ' ' << x[1] << ' ' << x[2];
    shared += on_the_seat;
  }
  EXPECT_GT(shared, 50);
}

TEST(StackMesh, CapAndSocketLieOnOneSphere) {
  for (const int level : {1, 2}) {
    StackMeshOptions options;
    options.level = level;
    const HexMesh mesh = stack_mesh(scene::Bearing{}, options);
    int cap = 0, socket = 0;
    for (const auto &face : mesh.faces) {
      if (face.group != Surface::foot_cap && face.group != Surface::socket) continue;
      for (const unsigned node : face.corners) {
        const auto &x = mesh.nodes[node];
        EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), 0.090, 1e-9);
      }
      ++(face.group == Surface::foot_cap ? cap : socket);
    }
    EXPECT_GT(cap, 20);
    EXPECT_GT(socket, 12);
  }
}

TEST(StackMesh, CellsAreSoundAtEveryLevelWholeAndHalfWithAndWithoutRim) {
  for (const bool half : {true, false})
    for (const bool rim : {false, true})
      for (const int level : {1, 2, 3}) {
        if (level == 3 && !half) continue;
        const HexMesh mesh = stack_mesh(scene::Bearing{}, {level, half, rim, rim, 1.0, half ? M_PI : 0.3});
        const MeshQuality q = quality(mesh);
        EXPECT_GT(q.min_scaled_jacobian, 0.1) << level << half << rim;
        EXPECT_LT(q.worst_aspect, 100) << level << half << rim;
      }
}

} // namespace
} // namespace rimpact::meshes
