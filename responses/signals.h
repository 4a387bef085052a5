/// The signals that a response may hold: names, units, meaning. A new one is a line in signals.cc.
#pragma once
#include <string>
#include <vector>

namespace rimpact {

/// One stored signal, e.g. {"displacement_x", "m", "of the upper slider, relative to the plate"}.
struct SignalInfo {
  std::string name, units, description;
};
/// The signals every model may write, in the order they are stored (docs/interface.md).
const std::vector<SignalInfo> &known_signals();
bool is_signal(const std::string &name); ///< whether it is one of known_signals()

} // namespace rimpact
