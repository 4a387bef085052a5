/// What a building does during a run: signals, peaks of each storey, ductility, collapse; the same for every
/// isolator beneath it.
#pragma once
#include "reduced_models/structures/superstructure.h"
#include "responses/response.h"
#include "responses/summary.h"

namespace rimpact::reduced {

/// One instant. Lateral parts but for the roof.
struct BuildingSnapshot {
  std::array<Eigen::Vector2d, max_floors> drift,
      shear; ///< of the storeys [m]; restoring and damping force on the floor above [N]
  std::array<Eigen::Vector3d, max_floors> acceleration; ///< of the floors, absolute [m/s^2]
  Eigen::Vector3d roof;                                 ///< relative to the base [m]
};
/// `floors` and `z` from the base up, as many as the building has.
BuildingSnapshot snapshot(const Superstructure &building, const FloorMotion &base, const FloorMotion *floors,
                          const Eigen::Vector2d *z);
/// The same from the physical model's state.
BuildingSnapshot snapshot(const Superstructure &building, const State &y, const FloorMotion &base);

class BuildingRecorder {
public:
  explicit BuildingRecorder(const Superstructure &building) : building_(building) {}
  void watch(const BuildingSnapshot &now);
  double peak_drift(int storey) const { return drift_[storey]; }
  void raise_drift(int storey, double value) { drift_[storey] = std::max(drift_[storey], value); }
  /// Signals drift_x|y (first storey), storey_shear_x|y (what it does to the base), roof_x|y|z,
  /// roof_acceleration_x|y|z.
  static const std::vector<std::string> &signals();
  static void append(const BuildingSnapshot &now, int n_floors, Response &response);
  /// Adds peak_drift_m, ductility (inelastic), peak_storey_shear_N, peak_floor_acceleration_m_s2, collapsed,
  /// and `superstructure` with the list of storeys, to summary.extra; `last` is the run's end. A collapse
  /// sets the status "stopped".
  void summarise(const BuildingSnapshot &last, std::optional<double> collapse_time, Summary &summary) const;

private:
  const Superstructure &building_;
  std::array<double, max_floors> drift_{}, shear_{}, acceleration_{};
};

} // namespace rimpact::reduced
