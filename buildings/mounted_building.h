/// A building in the basis of its floors and nodes, on bearings of any kind that are stepped with it.
#pragma once
#include "buildings/structure.h"

namespace rimpact::buildings {

class MountedBuilding : public BuildingBasis {
public:
  /// `bearings`: a scene for each supported node, in their order; its bearing and [reduced] count. Throws InputError.
  MountedBuilding(const BuildingModel &model, const scene::Scene &scene, const std::vector<scene::Scene> &bearings,
                  std::unique_ptr<Structure> structure);
  NodeMotion node(int b, const Eigen::VectorXd &q, const Eigen::VectorXd &v) const;

  double elastic_energy(const Eigen::VectorXd &y) const override;

  std::unique_ptr<Structure> structure;
  std::vector<std::unique_ptr<BearingElement>> mounts;
  std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> over_q; ///< node's motion of each bearing over q
  scene::GroundMotion ground;
};

} // namespace rimpact::buildings
