/// Built-in records.
#pragma once
#include "io/records/record.h"

namespace rimpact {

/// Built-in records: "builtin:near-fault-x", "builtin:near-fault-y" (see near_fault_pulse.cc).
bool is_builtin_record(const std::string &name);
SampledSignal builtin_record(const std::string &name); ///< throws InputError with the nearest name

} // namespace rimpact
