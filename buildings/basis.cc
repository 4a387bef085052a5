#include "buildings/basis.h"

namespace rimpact::buildings {

using Eigen::VectorXd;

BuildingBasis::BuildingBasis(const BuildingModel &m, double g)
    : model(m), slider(sliders(m)), reactions(static_reactions(m, g)), gravity(g),
      total_mass(m.mass.tail(m.n_nodes).sum()), weight(g * total_mass), n(m.n_dofs()) {
  start_ = VectorXd::Zero(n_state());
  start_.head(n) = static_displacements(m, gravity);
}

double BuildingBasis::kinetic_energy(const VectorXd &y) const {
  return 0.5 * y.segment(n, n).dot(model.mass.cwiseProduct(y.segment(n, n)));
}
double BuildingBasis::elastic_energy(const VectorXd &y) const {
  return 0.5 * y.head(n).dot(model.stiffness * y.head(n));
}
double BuildingBasis::potential_energy(const VectorXd &y) const {
  return gravity * model.mass.tail(model.n_nodes).dot(y.segment(3 * model.n_diaphragms, model.n_nodes));
}

} // namespace rimpact::buildings
