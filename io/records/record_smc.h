/// SMC: the form of the USGS' strong-motion discs.
#pragma once
#include <string_view>

namespace rimpact {

/// Whether a text's first line is one of this form: "2 CORRECTED ACCELEROGRAM".
bool opens_smc(std::string_view line);

} // namespace rimpact
