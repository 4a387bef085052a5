// Loads, start and outlook of a ContactSystem: what is asked of it outside Newton's iterations.
#include "fe_contact/engine/contact_system.h"

#include <cmath>

namespace rimpact::fe {

int SystemState::bearing_points() const {
  int points = 0;
  for (const auto &report : reports) points += report.stick + report.slip;
  return points;
}

Eigen::VectorXd ContactSystem::translation(const Eigen::Vector3d &way) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(equations_.n);
  for (std::size_t dof = 0; dof < equations_.of_dof.size(); ++dof) {
    const int equation = equations_.of_dof[dof];
    if (equation >= 0) result[equation] = way[dof % 3]; // of_dof is 3 by 3 throughout, bodies included
  }
  return result;
}

Eigen::VectorXd ContactSystem::surface_load(meshes::Surface group, const Traction &traction) const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(equations_.n);
  const auto faces = space_.faces_of(group);
  for (const auto &point : face_points(space_, faces, space_.degree + 2)) {
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (int a = 0; a < point.shapes.n; ++a) x += point.shapes.N[a] * space_.positions[faces[point.face]->nodes[a]];
    const Eigen::Vector3d t = point.area * traction(x, point.normal);
    for (int a = 0; a < point.shapes.n; ++a)
      for (int i = 0; i < 3; ++i) {
        const unsigned dof = 3 * faces[point.face]->nodes[a] + i;
        if (const int equation = equations_.of_dof[dof]; equation >= 0)
          load[equation] += equations_.weight[dof] * point.shapes.N[a] * t[i];
      }
  }
  return load;
}

double ContactSystem::time_to_touch(const SystemState &state) const {
  const Eigen::VectorXd u = equations_.expand(state.u), v = equations_.expand(state.v);
  double time = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (state.reports[i].stick + state.reports[i].slip > 0) return std::numeric_limits<double>::infinity();
    time = std::min(time, contacts_[i].search().time_to_touch(u, v, state.contacts[i].opposite));
  }
  return time;
}

} // namespace rimpact::fe
