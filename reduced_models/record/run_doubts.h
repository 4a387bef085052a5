/// What a reduced run says of itself besides its numbers.
#pragma once
#include "reduced_models/bearings/physical_model.h"

namespace rimpact::reduced {

/// Fills summary.extra: `warnings` (the element where the rim was touched, rebounds, the ledger) and the limits that
/// the run passed. Where no response was kept, whether the scene ends with the rim pressed is not looked at.
void add_doubts(const scene::Scene &scene, const Response &response, Summary &summary);

} // namespace rimpact::reduced
