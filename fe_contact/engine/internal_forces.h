/// Internal forces of single cells in a committed state: what a section through the mesh carries.
///
/// Summed over the cells on one side of a section, the forces on the section's nodes are what the other side does to
/// it. They balance the contacts, the inertia and the supports of that side to the solver's last digits. So do their
/// moments about any point, taken where the nodes are displaced to.
#pragma once
#include "fe_contact/engine/solid.h"

namespace rimpact::fe {

/// On the cell's local nodes, one a column [N]; u: displacements by dof [m]. The state is taken as it is: nothing
/// flows, overstress stays.
Eigen::Matrix3Xd internal_forces(const Solid &solid, const Discretisation &space, std::size_t cell,
                                 const Eigen::VectorXd &u, const SolidHistory &history);

} // namespace rimpact::fe
