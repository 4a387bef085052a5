/// Records that are another one, scaled or not.
#pragma once
#include "io/records/record_library.h"
#include <optional>
#include <vector>

namespace rimpact {

struct ScaledCopy {
  std::size_t of; ///< an earlier record of the list
  double factor;  ///< of its values; negative: turned round
};

/// For each record the first earlier one of which it is a multiple, sample by sample within a thousandth of its peak.
/// Null pointers are no record.
std::vector<std::optional<ScaledCopy>> scaled_copies(const std::vector<std::shared_ptr<const SampledSignal>> &records);

} // namespace rimpact
