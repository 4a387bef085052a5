/// [plausible] of sweeps and studies: the largest values that are believed of a run. A run beyond one is no result that
/// the model stands for, and is doubted.
///
///   [plausible]
///   ductility = 15
///   peak_drift_m = 0.2
#pragma once
#include "io/files/toml_reader.h"
#include "studies/fleets/hit_shares.h"
#include <map>

namespace rimpact::fleets {

/// Bounds by column of a fleet's table, in the column's unit, > 0.
using PlausibleBounds = std::map<std::string, double>;

/// Columns that may be bounded.
const std::vector<std::string> &bounded_quantities();
/// Reads [plausible]; none: empty. Throws InputError with file, line and column for an unknown name, and for a bound
/// that is no number > 0.
PlausibleBounds read_plausible(const TomlFile &file);

class ImplausibleRuns {
public:
  ImplausibleRuns() = default; ///< without bounds
  explicit ImplausibleRuns(PlausibleBounds bounds) : bounds_(std::move(bounds)) {}
  /// A run whose cell is empty is beyond nothing.
  void add(const CellReader &run);
  /// Whether the frame's usual bounds (responses/frame_limits.h) give way to these.
  bool bound_the_frame() const;
  /// By quantity: its bound, the runs beyond it and the largest value of all; null: no run has one.
  nlohmann::ordered_json json() const;
  /// A sentence for each bound that runs are beyond.
  std::vector<std::string> doubts() const;

private:
  struct Beyond {
    std::size_t n = 0;
    std::optional<double> largest; ///< of all runs
  };
  PlausibleBounds bounds_;
  std::map<std::string, Beyond> found_;
};

} // namespace rimpact::fleets
