/// Where a bearing's steel was strained, and by how much: what decides whether its rim survives.
#pragma once
#include "fe_contact/engine/solid.h"
#include "responses/steel_report.h"

namespace rimpact::fe {

/// The rim's volume is its root up to a quarter of its
/// thickness above the plate, and its wall above; `dish` is the plate; `slider_edge` the foot and the upper slider. The
/// elastic pad has none.
SteelReport steel_by_place(const Discretisation &space, const scene::Bearing &bearing, const SolidHistory &history);

} // namespace rimpact::fe
