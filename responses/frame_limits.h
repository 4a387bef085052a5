/// What a frame's hysteresis no longer stands for: bounds, assumptions of ours, beyond which a run is doubted.
#pragma once
#include <optional>
#include <string>

namespace rimpact {

/// Largest displacement over the yield's; frames are rarely tested beyond it, and no law here loses strength by cycles.
inline constexpr double most_ductility = 10;
/// Of a storey [m]: a twentieth of one 3 m high.
inline constexpr double most_drift = 0.15;

inline bool is_beyond_frame(std::optional<double> ductility, std::optional<double> drift) {
  return ductility.value_or(0) > most_ductility || drift.value_or(0) > most_drift;
}
/// A sentence with both numbers and bounds; none: within them, or without a frame.
std::optional<std::string> doubt_of_frame(std::optional<double> ductility, std::optional<double> drift);

} // namespace rimpact
