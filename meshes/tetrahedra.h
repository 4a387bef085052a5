/// Tetrahedra divided into four hexahedra each. Private to the meshes.
#pragma once
#include "meshes/hex_mesh.h"
#include <map>

namespace rimpact::meshes {

/// Nodes are added at the middles of edges, faces and cells, shared by neighbours: straight tetrahedra that are not
/// inverted give hexahedra that are not.
class TetrahedraDivision {
public:
  explicit TetrahedraDivision(HexMesh &mesh) : mesh_(mesh) {}
  /// `corners`: the fourth lies on the side to which 1, 2, 3 turn counter-clockwise (gmsh's order).
  std::array<std::array<unsigned, 8>, 4> hexahedra(const std::array<unsigned, 4> &corners);
  std::array<std::array<unsigned, 4>, 3> quadrangles(const std::array<unsigned, 3> &corners);

private:
  unsigned middle(std::vector<unsigned> corners);
  HexMesh &mesh_;
  std::map<std::vector<unsigned>, unsigned> added_;
};

} // namespace rimpact::meshes
