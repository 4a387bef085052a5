/// What memory there is, before a run takes it.
#pragma once
#include <optional>
#include <string>

namespace rimpact::app {

/// [bytes]: what the kernel says it can give without swapping, within this process's own limit; empty: not known.
std::optional<double> available_memory();
/// A sentence where a run is expected to need more than there is; empty: it fits, or is not known.
std::string doubt_of_memory(double expected_bytes);

} // namespace rimpact::app
