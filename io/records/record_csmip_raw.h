/// CSMIP V1: the uncorrected accelerograms of California's network.
#pragma once
#include <string_view>

namespace rimpact {

/// Whether a file, or a channel of one, begins with this line. In corrected ones (V2) it stands second.
bool opens_csmip_raw(std::string_view line);

} // namespace rimpact
