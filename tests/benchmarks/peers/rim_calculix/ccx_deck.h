/// A hexahedral mesh in the words of a CalculiX input deck: elements, node sets and element-face surfaces.
/// Lengths in mm (the deck is in mm, N, MPa).
#pragma once
#include "meshes/hex_mesh.h"
#include "scene/material.h"
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rimpact::verification {

/// ccx's order of the 20-node hexahedron, as places in gmsh's 27: corners, edges of the bottom, of the top,
/// uprights.
inline constexpr int ccx_order[20] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
/// Corners of ccx's faces S1..S6.
inline constexpr int ccx_faces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                        {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

/// A boundary face as ccx names it: element (from 1) and face (1..6), with the nodes an element of `n_nodes`
/// has there.
struct DeckFace {
  std::size_t element;
  int face;
  std::vector<unsigned> nodes;
};

class DeckMesh {
public:
  /// `n_nodes`: 8 or 20 a hexahedron; the others of the 27 are left out. Throws std::invalid_argument for
  /// another number or a boundary face that no cell owns.
  DeckMesh(const meshes::HexMesh &mesh, int n_nodes);
  /// *NODE and *ELEMENT, the latter with one set a volume, named as the mesh names it. `others`: volumes of another
  /// element type (with as many nodes).
  std::string nodes_and_elements(const std::string &element_type,
                                 const std::map<meshes::Volume, std::string> &others = {}) const;
  std::set<unsigned> nodes_of(meshes::Surface group) const;
  std::set<unsigned> nodes_of(meshes::Volume volume) const;
  /// *SURFACE of a group's faces.
  std::string surface(meshes::Surface group) const;

private:
  const meshes::HexMesh &mesh_;
  int n_nodes_;
  std::map<meshes::Surface, std::vector<DeckFace>> faces_;
};

/// *NSET; nodes are counted from 1 in a deck.
std::string node_set(const std::string &name, const std::set<unsigned> &nodes);

/// *MATERIAL: Cauchy stress over logarithmic plastic strain, linear far beyond what a push reaches.
std::string material(const char *name, const scene::Material &data);
/// *SURFACE INTERACTION and *CONTACT PAIR, surface to surface, penalty [MPa/mm]; mu 0: no friction.
std::string contact(const char *name, const char *slave, const char *master, double stiffness, double mu);

} // namespace rimpact::verification
