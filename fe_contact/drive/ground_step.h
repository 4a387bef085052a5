/// What the ground does over a step in time.
#pragma once
#include "fe_contact/engine/contact_system.h"
#include "scene/excitation.h"

namespace rimpact::fe {

/// From t over dt [s], by Gauss's rule on pieces so short that the kinks of a record leave nothing.
GroundStep ground_step(const scene::GroundMotion &ground, double t, double dt);

} // namespace rimpact::fe
