/// Where the shooting of a measured impact begins: the state at a sample before touch, and how well it is known. It
/// comes from the flight before the touch (flight_fit.h), or from the scene where a window record begins at touch.
#pragma once
#include "calibration/data/measured_record.h"
#include <optional>

namespace rimpact::calibration {

struct ShotStart {
  std::size_t sample = 0, flown = 0; ///< where the shot begins; first sample behind those it is fitted to
  Eigen::Vector2d u, v;
  Eigen::Matrix2d covariance; ///< radial (u, v)
  double capacity;            ///< where the reduced rim begins [m]
  bool dented = false;        ///< the rim was touched surely beyond L_c
  double touch = 0;           ///< travel at the first force [m]
  double touch_noise = 0;     ///< its standard error [m]
  double touch_late = 0;      ///< how far it moves between samples around the touch [m]
};

/// Of the record's contact `index`; none, with the `reason`, where the state cannot be told.
std::optional<ShotStart> shot_start(const StoredRun &run, const MeasuredRecord &record, const WindowOptions &options,
                                    std::size_t index, std::string &reason);

} // namespace rimpact::calibration
