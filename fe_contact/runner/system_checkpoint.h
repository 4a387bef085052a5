/// A ContactSystem's state in a checkpoint.
#pragma once
#include "fe_contact/model/contact_system.h"
#include "fe_contact/runner/checkpoint.h"

namespace rimpact::fe {

void put(Checkpoint &file, const SystemState &state);
/// Into a state of the same system. Throws DataError when the file is of another mesh.
void get(const Checkpoint &file, SystemState &state);

} // namespace rimpact::fe
