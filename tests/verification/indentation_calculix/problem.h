/// Indentation of a quarter block by a rigid sphere driven straight down: what both programs compute.
/// The block lies at x, y >= 0 >= z, held on its bottom and its two planes of symmetry; the sphere's lowest
/// point starts at the origin. SI units.
#pragma once
#include "meshes/hex_mesh.h"
#include "scene/material.h"
#include <string>

namespace rimpact::verification {

struct Problem {
  std::string name;
  scene::Material material;
  double mu;
  double radius; ///< of the sphere [m]
  double depth;  ///< of its travel [m]
  // Contact's stiffness, so that the pressure overlaps by less than about 0.3 % of the depth in either code.
  double penalty_factor; ///< ours, over E / cell, before augmentation
  double ccx_stiffness;  ///< [Pa/m]; a tenth of it is ccx's stick slope

  double contact() const; ///< radius of contact by order of magnitude, sqrt(radius depth) [m]: sets the mesh
  double side() const;    ///< of the block [m]
};

/// `elastic` or `steel`; throws std::invalid_argument for another name.
Problem problem(const std::string &name);

/// Edge of the cells below the sphere [m] with `cells` a direction.
double smallest_cell(const Problem &problem, int cells);
/// The block; its top is the group slider_side.
meshes::HexMesh block(const Problem &problem, int cells);
/// Adds the part of the sphere that may touch, one layer of `cells` by `cells` (volume upper_slider, its
/// lower face the group rim_wall).
void add_cap(meshes::HexMesh &mesh, const Problem &problem, int cells);

} // namespace rimpact::verification
