#include "meshes/cell_nodes.h"

#include "meshes/hex_order.h"
#include <algorithm>

namespace rimpact::meshes {

std::array<unsigned, 4> sorted(std::array<unsigned, 4> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

std::size_t nodes_of_hexahedron(int gmsh_type) {
  return gmsh_type == 5 ? 8 : gmsh_type == 17 ? 20 : gmsh_type == 12 ? 27 : 0;
}

unsigned CellNodes::shared(Key corners, const std::array<double, 3> &place) {
  const auto [entry, is_new] = added_.try_emplace(sorted(corners), static_cast<unsigned>(mesh_.nodes.size()));
  if (is_new) mesh_.nodes.push_back(place);
  return entry->second;
}

std::array<unsigned, 27> CellNodes::operator()(const std::vector<unsigned> &nodes) {
  std::array<unsigned, 27> cell{};
  std::copy(nodes.begin(), nodes.end(), cell.begin());
  if (nodes.size() == 27) return cell;
  if (nodes.size() < 20)
    for (int e = 0; e < 12; ++e) {
      const unsigned a = cell[hex27_edges[e][0]], b = cell[hex27_edges[e][1]];
      const auto &x = mesh_.nodes[a], &y = mesh_.nodes[b];
      cell[8 + e] = shared({a, a, b, b}, {0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])});
    }
  for (int f = 0; f < 6; ++f) {
    const auto &c = hex27_faces[f];
    cell[20 + f] = shared({cell[c[0]], cell[c[1]], cell[c[2]], cell[c[3]]}, {});
  }
  cell[26] = static_cast<unsigned>(mesh_.nodes.size());
  mesh_.nodes.push_back({});
  complete_from_edges(mesh_, cell);
  return cell;
}

void complete_from_edges(HexMesh &mesh, const std::array<unsigned, 27> &cell) {
  for (int n = 20; n < 27; ++n) {
    const auto around = [&](int a) { // on the same face; everything is around the centre
      for (int i = 0; i < 3; ++i)
        if (hex27[n][i] != 1 && hex27[a][i] != hex27[n][i]) return false;
      return true;
    };
    std::array<double, 3> x{};
    for (int a = 0; a < 20; ++a)
      for (int i = 0; i < 3 && around(a); ++i) x[i] += (a < 8 ? -0.25 : n < 26 ? 0.5 : 0.25) * mesh.nodes[cell[a]][i];
    mesh.nodes[cell[n]] = x;
  }
}

BoundaryOfCells::BoundaryOfCells(const HexMesh &mesh) {
  for (const auto &cell : mesh.cells)
    for (const auto &face : hex_faces) {
      const auto corners = sorted({cell[face[0]], cell[face[1]], cell[face[2]], cell[face[3]]});
      if (!faces_.insert(corners).second) faces_.erase(corners); // met from its other side
    }
}

bool BoundaryOfCells::has(std::array<unsigned, 4> corners) const {
  return faces_.count(sorted(corners)) > 0;
}

} // namespace rimpact::meshes
