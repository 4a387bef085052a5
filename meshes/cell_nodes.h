/// Pieces of a mesh made from corners alone: the 27 nodes of its cells, and which faces are outside.
#pragma once
#include "meshes/hex_mesh.h"
#include <map>
#include <set>

namespace rimpact::meshes {

std::array<unsigned, 4> sorted(std::array<unsigned, 4> corners);

/// Nodes of gmsh's element type if it is a hexahedron of 8, 20 or 27 nodes, else 0.
std::size_t nodes_of_hexahedron(int gmsh_type);

/// Puts faces' middles and the centre where the serendipity functions of corners and edges have them.
void complete_from_edges(HexMesh &mesh, const std::array<unsigned, 27> &cell);

/// Completes cells to 27 nodes: edges' middles halfway where they are missing, faces and centre from the edges.
/// Neighbours share the nodes that were added.
class CellNodes {
public:
  explicit CellNodes(HexMesh &mesh) : mesh_(mesh) {}
  std::array<unsigned, 27> operator()(const std::vector<unsigned> &nodes);

private:
  using Key = std::array<unsigned, 4>; ///< sorted corners, of an edge with the first two twice
  unsigned shared(Key corners, const std::array<double, 3> &place);
  HexMesh &mesh_;
  std::map<Key, unsigned> added_;
};

/// Faces, by their corners in any order, that belong to one cell only.
class BoundaryOfCells {
public:
  explicit BoundaryOfCells(const HexMesh &mesh);
  bool has(std::array<unsigned, 4> corners) const;

private:
  std::set<std::array<unsigned, 4>> faces_;
};

} // namespace rimpact::meshes
