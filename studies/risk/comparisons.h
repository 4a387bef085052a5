/// Systems alike in all but one key.
#pragma once
#include "studies/risk/results.h"

namespace rimpact::risk {

/// Keys that change together with a difference's key (its case or device, what is linked to them) may differ.
std::vector<Comparison> comparisons(const Study &study, const Systems &systems);

} // namespace rimpact::risk
