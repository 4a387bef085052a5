/// A mesh of 27-node hexahedra as deal.II holds it: a triangulation of its corners, and a mapping to its curved cells.
#pragma once
#include "meshes/hex_mesh.h"
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/tria.h>

namespace rimpact::fe {

/// A cell's material is its volume, a boundary face's id its group; 0: no group.
void make_curved_mesh(const meshes::HexMesh &mesh, dealii::Triangulation<3> &triangulation,
                      dealii::MappingQCache<3> &mapping);

} // namespace rimpact::fe
