/// Section of plate and rim in (r, z), to be revolved about the vertical axis.
#pragma once
#include "meshes/section.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

struct PlateSection {
  double inner_radius;        ///< [m]; the cut carries `sector_end`
  double inner_size;          ///< of the cells there [m]
  std::vector<double> layers; ///< shares of the height between base and dish at which they end: 0 .. 1
};
/// Outwards of the inner radius; sizes in the rim are those of level 1 times h.
std::vector<Quad9> plate_and_rim(const scene::Bearing &bearing, const PlateSection &plate, double h);
/// Layers fine enough below the rim.
std::vector<double> plate_layers(const scene::Bearing &bearing, double h);

} // namespace rimpact::meshes
