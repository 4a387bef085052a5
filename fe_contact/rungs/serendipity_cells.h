/// Which cells of a bearing have the serendipity shapes of 20 nodes (engine/serendipity.h). Pad and foot have them, and
/// the slider's body farther than a sixth of its diameter from its side. The plate has them farther from the wall than
/// the rim is high and than half of the plate's thickness there. The rest, where walls dent and steel flows, has 27.
///
/// Assumption of ours, by measurement: closer to the slider's side force and rebound move by 0.1 to 0.3 %
/// (docs/decisions/0031-twenty-nodes-where-little-happens.md).
#pragma once
#include "fe_contact/engine/discretisation.h"
#include "scene/bearing.h"

namespace rimpact::fe {

std::vector<char> serendipity_cells(const Discretisation &space, const scene::Bearing &bearing); ///< [cell], 1: they do

} // namespace rimpact::fe
