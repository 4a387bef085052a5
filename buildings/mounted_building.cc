#include "buildings/mounted_building.h"
#include "buildings/dish_element.h"
#include "buildings/dynamics.h"
#include "buildings/rigid_element.h"
#include <algorithm>

namespace rimpact::buildings {

MountedBuilding::MountedBuilding(const BuildingModel &m, const scene::Scene &scene,
                                 const std::vector<scene::Scene> &bearings, std::unique_ptr<Structure> above)
    : BuildingBasis(m, scene.load.gravity), structure(std::move(above)), ground(scene.excitation, scene.load.gravity) {
  check_building_scene(scene);
  const auto rest = structure->at_rest();
  start_.head(n) = rest.q, reactions = rest.reactions;
  rigid_bodies = true;
  for (int b = 0; b < n_bearings(); ++b) {
    scene::Scene s = bearings[b];
    s.load.vertical = std::max(0.0, reactions[b]), s.load.gravity = gravity;
    s.load.mass = s.load.vertical > 0 ? s.load.vertical / gravity : scene.load.mass;
    s.superstructure = {}, s.excitation = scene.excitation;
    check_building_scene(s);
    mounts.push_back(s.rigid_bodies() ? rigid_element(s) : dish_element(s));
    capacity.push_back(mounts[b]->lateral_capacity), rim_stiffness.push_back(mounts[b]->rim_stiffness);
    over_q.push_back(m.nodal.middleRows(6 * m.bearings[b], 6));
    if (structure->turns_nodes()) // in the plane of x and z, and by unknowns of the structure's
      for (const int row : {1, 3, 4, 5}) over_q[b].row(row).setZero();
  }
}

double MountedBuilding::elastic_energy(const Eigen::VectorXd &y) const {
  return y[work(strain)];
}

NodeMotion MountedBuilding::node(int b, const Eigen::VectorXd &q, const Eigen::VectorXd &v) const {
  NodeMotion motion{over_q[b] * (q - start_.head(n)), over_q[b] * v};
  if (structure->turns_nodes()) {
    const NodeTurn turn = structure->turn(b);
    motion.u[4] = turn.angle, motion.v[4] = turn.rate;
  }
  return motion;
}

} // namespace rimpact::buildings
