#include "meshes/tetrahedra.h"

#include <algorithm>

namespace rimpact::meshes {

unsigned TetrahedraDivision::middle(std::vector<unsigned> corners) {
  std::sort(corners.begin(), corners.end());
  const auto [entry, is_new] = added_.try_emplace(corners, static_cast<unsigned>(mesh_.nodes.size()));
  if (!is_new) return entry->second;
  std::array<double, 3> x{};
  for (const unsigned corner : corners)
    for (int i = 0; i < 3; ++i) x[i] += mesh_.nodes[corner][i] / static_cast<double>(corners.size());
  mesh_.nodes.push_back(x);
  return entry->second;
}

std::array<std::array<unsigned, 8>, 4> TetrahedraDivision::hexahedra(const std::array<unsigned, 4> &t) {
  constexpr int turns[4][4] = {
      {0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}; // one for each corner, of the same sense
  std::array<std::array<unsigned, 8>, 4> result;
  const unsigned centre = middle({t[0], t[1], t[2], t[3]});
  for (int k = 0; k < 4; ++k) {
    const unsigned a = t[turns[k][0]], b = t[turns[k][1]], c = t[turns[k][2]], d = t[turns[k][3]];
    result[k] = {a,      middle({a, b}),   middle({a, b, c}), middle({a, c}), middle({a, d}), middle({a, b, d}),
                 centre, middle({a, c, d})};
  }
  return result;
}

std::array<std::array<unsigned, 4>, 3> TetrahedraDivision::quadrangles(const std::array<unsigned, 3> &t) {
  std::array<std::array<unsigned, 4>, 3> result;
  for (int k = 0; k < 3; ++k) {
    const unsigned a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    result[k] = {a, middle({a, b}), middle({a, b, c}), middle({a, c})};
  }
  return result;
}

} // namespace rimpact::meshes
