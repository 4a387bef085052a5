/// Sizes of the cells that gmsh makes of a drawn geometry. Private to the meshes.
#pragma once
#include "scene/bearing.h"
#include "scene/own_mesh_settings.h"

namespace rimpact::meshes {

/// A size of cells on a level circle (a place, if its radius is 0), an upright cylinder or a ball; it grows by a third
/// of the distance from there.
struct SizeOn {
  enum class Shape { circle, cylinder, ball };
  Shape shape;
  std::array<double, 3> centre; ///< [m]
  double radius, size;          ///< [m]
};

/// Of cells meshed from a geometry: fine at first touch, on the wall and on a slider drawn at rest. Elsewhere round
/// walls get 30 edges a turn, so that straight edges stay near them. At the slider's edge they leave its circle by a
/// sixteenth of its rounding. with_pad: of a pad at rest too.
std::vector<SizeOn> sizes_of(const scene::OwnMesh &own, const scene::Bearing &bearing, bool with_pad);

/// Largest edge of tetrahedra at (x, y, z), in the file's unit, as gmsh's MathEval reads it: twice the size, for a
/// tetrahedron's edges are halved when it is divided. Nowhere above own.size.
std::string size_expression(const scene::OwnMesh &own, const std::vector<SizeOn> &sizes);

} // namespace rimpact::meshes
