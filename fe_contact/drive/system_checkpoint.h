/// A ContactSystem's state in a checkpoint. Whoever writes or reads one calls start_afresh_at.
#pragma once
#include "fe_contact/drive/checkpoint.h"
#include "fe_contact/engine/contact_steps.h"

namespace rimpact::fe {

void put(Checkpoint &file, const SystemState &state, const std::string &prefix = "");
/// Into a state of the same system. Throws DataError when the file is damaged, or of another mesh.
void get(const Checkpoint &file, SystemState &state, const std::string &prefix = "");

/// Where a run in time stands.
void put(Checkpoint &file, const TransientPoint &point);
void get(const Checkpoint &file, TransientPoint &point);

} // namespace rimpact::fe
