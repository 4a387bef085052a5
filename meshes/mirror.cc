#include "meshes/mirror.h"

#include "meshes/hex_order.h"

namespace rimpact::meshes {

HexMesh mirrored(const HexMesh &half) {
  HexMesh whole = half;
  std::vector<unsigned> image(half.nodes.size());
  for (std::size_t k = 0; k < half.nodes.size(); ++k) {
    image[k] = k;
    if (half.nodes[k][1] == 0) continue;
    image[k] = whole.nodes.size();
    whole.nodes.push_back({half.nodes[k][0], -half.nodes[k][1], half.nodes[k][2]});
  }
  int swap[27];
  for (int a = 0; a < 27; ++a)
    for (int b = 0; b < 27; ++b)
      if (hex27[b][0] == hex27[a][0] && hex27[b][1] == 2 - hex27[a][1] && hex27[b][2] == hex27[a][2]) swap[a] = b;
  for (std::size_t c = 0; c < half.cells.size(); ++c) {
    std::array<unsigned, 27> cell;
    for (int a = 0; a < 27; ++a) cell[a] = image[half.cells[c][swap[a]]];
    whole.cells.push_back(cell);
    whole.volumes.push_back(half.volumes[c]);
  }
  whole.faces.clear();
  for (const auto &face : half.faces) {
    if (face.group == Surface::symmetry) continue;
    whole.faces.push_back(face);
    whole.faces.push_back(
        {{image[face.corners[0]], image[face.corners[3]], image[face.corners[2]], image[face.corners[1]]}, face.group});
  }
  return whole;
}

} // namespace rimpact::meshes
