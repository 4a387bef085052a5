/// gmsh's order of the 27 nodes of a hexahedron: place of each in half cells along (xi, eta, zeta).
#pragma once

namespace rimpact::meshes {

inline constexpr int hex27[27][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                                     {0, 2, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0},
                                     {2, 2, 1}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2}, {2, 1, 2}, {1, 2, 2}, {1, 1, 0},
                                     {1, 0, 1}, {0, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {1, 1, 1}};

/// Corners of the twelve edges and of the six faces, in the order of their middles (nodes 8 to 19, 20 to 25).
inline constexpr int hex27_edges[12][2] = {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                                           {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
inline constexpr int hex27_faces[6][4] = {{0, 1, 2, 3}, {0, 1, 5, 4}, {0, 3, 7, 4},
                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}};

/// Corners of the faces xi-, xi+, eta-, eta+, zeta-, zeta+.
inline constexpr int hex_faces[6][4] = {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                        {3, 2, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}};

} // namespace rimpact::meshes
