/// Where --allow-script is remembered for this process and those it starts.
#pragma once

namespace rimpact::scene {

inline constexpr const char *script_permission = "RIMPACT_ALLOW_SCRIPT";

} // namespace rimpact::scene
