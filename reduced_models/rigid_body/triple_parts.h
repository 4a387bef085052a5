/// A triple friction pendulum's slide plates, inner slider and four faces (docs/theory/triple-pendulum.md).
#pragma once
#include "reduced_models/rigid_body/bearing_parts.h"
#include <array>

namespace rimpact::reduced::rigid {

Parts triple_parts(const scene::Scene &scene, bool slow);

/// Friction of the four faces at every point, from the ground up [-].
using FaceFriction = std::array<double, 4>;
/// Friction as tests give it, force over load where a body begins to slide (bottom plate, inner slider's lower and
/// upper face, top plate), as that of the faces' points.
FaceFriction face_friction(const scene::Isolator &bearing, const FaceFriction &loops);

/// Moment of a sliding face's friction about its sphere's centre, over mu R and the load on it [-]; 1 / cos(phi) for
/// two points in the plane. The points' normal forces are those of equal springs pressed along the axis.
double moment_factor(const scene::Isolator &bearing, const scene::TripleFace &face);

} // namespace rimpact::reduced::rigid
