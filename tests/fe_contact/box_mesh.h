/// Structured boxes of 27-node hexahedra for tests: every face of a box can carry a group.
#pragma once
#include "meshes/hex_mesh.h"
#include <array>
#include <functional>
#include <map>

namespace rimpact::test {

struct Box {
  std::array<double, 3> low, high;
  std::array<int, 3> cells;
  meshes::Volume volume = meshes::Volume::rim;
  std::map<int, meshes::Surface> groups; ///< face (x-, x+, y-, y+, z-, z+ as 0..5) -> group
};

/// Appends a box to a mesh; `shape` moves every node (curved boxes).
inline void add_box(meshes::HexMesh &mesh, const Box &box,
                    const std::function<std::array<double, 3>(std::array<double, 3>)> &shape = {}) {
  const unsigned first = mesh.nodes.size();
  const auto [nx, ny, nz] = box.cells;
  const auto node = [&, nx = nx, ny = ny](int i, int j, int k) {
    return first + unsigned(i + (2 * nx + 1) * (j + (2 * ny + 1) * k));
  };
  for (int k = 0; k <= 2 * nz; ++k)
    for (int j = 0; j <= 2 * ny; ++j)
      for (int i = 0; i <= 2 * nx; ++i) {
        std::array<double, 3> x{};
        const int index[3] = {i, j, k};
        for (int d = 0; d < 3; ++d) x[d] = box.low[d] + (box.high[d] - box.low[d]) * index[d] / (2.0 * box.cells[d]);
        mesh.nodes.push_back(shape ? shape(x) : x);
      }
  // Offsets of gmsh's 27 nodes in half cells: 8 corners, 12 edges, 6 faces, centre.
  constexpr int at[27][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                             {0, 2, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0},
                             {2, 2, 1}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2}, {2, 1, 2}, {1, 2, 2}, {1, 1, 0},
                             {1, 0, 1}, {0, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {1, 1, 1}};
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        std::array<unsigned, 27> cell;
        for (int a = 0; a < 27; ++a) cell[a] = node(2 * i + at[a][0], 2 * j + at[a][1], 2 * k + at[a][2]);
        mesh.cells.push_back(cell);
        mesh.volumes.push_back(box.volume);
        const auto &c = cell;
        const std::array<std::array<unsigned, 4>, 6> quads{{{c[0], c[3], c[7], c[4]},
                                                            {c[1], c[2], c[6], c[5]},
                                                            {c[0], c[1], c[5], c[4]},
                                                            {c[3], c[2], c[6], c[7]},
                                                            {c[0], c[1], c[2], c[3]},
                                                            {c[4], c[5], c[6], c[7]}}};
        const bool outer[6] = {i == 0, i == nx - 1, j == 0, j == ny - 1, k == 0, k == nz - 1};
        for (const auto &[face, group] : box.groups)
          if (outer[face]) mesh.faces.push_back({quads[face], group});
      }
}

} // namespace rimpact::test
