/// Records kept after they are read, so that the runs of a fleet share them.
#pragma once
#include "io/records/record.h"
#include <memory>

namespace rimpact {

/// As read_record, shared and never changed. A file that was written since it was read (its time or length) is read
/// again. Safe to call from many threads; records are kept up to `largest_library`, the oldest ones go first.
std::shared_ptr<const SampledSignal> shared_record(const std::string &path, double gravity = standard_gravity);

/// The folder that the variable RIMPACT_RECORDS names; empty: none.
std::string records_shelf();

/// A record's absolute name: beside `folder`, or on the shelf where only that one is there. A built-in name stays.
std::string find_record(const std::string &name, const std::string &folder);

/// Samples that are kept, of all records together: 256 MB.
inline constexpr std::size_t largest_library = 32'000'000;

} // namespace rimpact
