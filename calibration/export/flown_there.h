/// What OpenSees itself had of such files. The tests fly exported files there (tests/peers/opensees_table.py), hold
/// them against these numbers, and keep the rows in docs/results/peers.md.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace rimpact::calibration {

/// Largest relative differences of touch speed and peak force [-].
struct FlownThere {
  const char *program = "OpenSees 3.7.1";
  double springs = 0.002; ///< of every law's springs over this file's self-check: peak, depth, rebound, a second hit
  double bearing = 0.04;  ///< of the whole bearing over the self-check
  double model = 0.06;    ///< over the reduced model
  double solids = 0.06;   ///< over kept finite-element runs
  std::string sentence() const;
  nlohmann::json json() const {
    return {{"program", program}, {"springs", springs}, {"bearing", bearing}, {"model", model}, {"solids", solids}};
  }
};

} // namespace rimpact::calibration
