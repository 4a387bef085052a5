/// To which plastic strain the steel at a place of a bearing is trusted: that of the part it belongs to.
#pragma once
#include "responses/steel_report.h"
#include "scene/bearing.h"

namespace rimpact {

/// The rim's wall and root are the rim's, the slider's edge is the slider's.
scene::SteelPart part_of(SteelPlace place);
/// [-]; none: not judged.
std::optional<double> limit_at(const scene::Bearing &bearing, SteelPlace place);
/// The key that has it, "material.rim.strain_limit", or the bearing's own where the part has no table.
std::string limit_key(const scene::Bearing &bearing, SteelPlace place);
bool limit_is_assumed(const scene::Bearing &bearing, SteelPlace place);

/// Of rim and plate, the one that is trusted less: what a strain of an unknown place is held against.
SteelPlace weakest_of_the_rim(const scene::Bearing &bearing);

} // namespace rimpact
