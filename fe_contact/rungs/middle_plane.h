/// The middle plane of a slider between two like dishes, one half of which is solved. Inversion in its middle maps the
/// bearing on itself: what is below moves to one side as what is above does to the other. So the plane's points p move
/// about the middle oddly, u(-p) - u(0) = -(u(p) - u(0)), while the slider turns and bends as it likes.
///
/// Where the slider is two halves, the one that is solved presses on its own image instead. The middle belongs to
/// neither and moves with three dofs of its own. The halves slide, part and lean as their friction lets them; it stays
/// where a window leaves the dishes' friction out, for nothing else holds them.
#pragma once
#include "fe_contact/engine/contact_system.h"
#include "fe_contact/rungs/bearing_model.h"

namespace rimpact::fe {

/// The node of the model's group `top` on the slider's axis. Throws std::logic_error where it has none.
unsigned middle_node(const Discretisation &space);
/// Ties the nodes of the group `top` in pairs; on a half model (y >= 0) with their images in its plane.
void tie_middle_plane(ContactSystem &system, const BearingModel &model);
/// First of the three dofs of the middle that carries the mass: a node's, or, between halves that slide, a body's of
/// its own, behind the nodes'.
int middle_dof(const BearingModel &model);
/// Faces of a slider between two dishes, on a dish or on one another: steel on steel rings. Multipliers that follow an
/// oscillating pressure by a step feed it, the less the stiffer. After a hit at 0.1 m/s contact gave back 4.7 % of the
/// energy with the stiffness of a cell, 0.2 % with 4 times that and 0.1 % with 16 times.
SurfaceContactOptions steel_on_steel(const BearingModel &model, const FrictionCoefficient &mu);
/// Between halves that slide: the group `top` on its own image.
Pair halves_pair(const BearingModel &model);

} // namespace rimpact::fe
