/// The bearing's section through its axis as it is drawn, for a program of drawing: DXF of release 12, in mm, x along
/// the travel, y up from the dish's vertex, at rest. Arcs are arcs; a dish that is no sphere is a polyline within 1
/// micrometre. Layers: PLATE, RIM, SLIDER, of one dish FOOT and PAD, SLIDER_AT_TOUCH (dashed, where it first meets the
/// rim), of two UPPER_PLATE and UPPER_RIM; AXIS, TEXT.
#pragma once
#include "scene/bearing.h"
#include <string>
#include <vector>

namespace rimpact::calibration {

/// `head`: comments at the file's head.
std::string section_dxf(const scene::Bearing &bearing, const std::vector<std::string> &head);

} // namespace rimpact::calibration
