/// What a run asks of its mesh, whatever the rung.
#pragma once
#include "scene/own_mesh_settings.h"
#include <cmath>
#include <vector>

namespace rimpact::meshes {

struct MeshOrder {
  int level = 1;                  ///< 0 to 3: every size divided by 1.5 a level
  bool half = true;               ///< y >= 0 only, with the group `symmetry` on y = 0
  bool rim = false;               ///< of a stack: with sectors of rim and plate about the directions
  double sector_half_angle = 1.0; ///< of each [rad]; the ends carry `sector_end`
  bool whole_plate = false;       ///< of a stack: the dish is meshed as well, from its middle, with the sectors' rim
  /// In which slider and rim may meet, the first the mesh's own x axis [rad]; a half model's are 0 and pi apart.
  std::vector<double> directions{0};
  scene::OwnMesh own = {}; ///< drawn elsewhere; then `half`, `rim`, `whole_plate` and `directions` count
};
/// Sizes of a level over those of level 1.
inline double size_factor(int level) {
  return std::pow(1.5, -(level - 1));
}

} // namespace rimpact::meshes
