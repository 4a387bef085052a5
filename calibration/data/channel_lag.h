/// Whether a record's force and displacement have one clock, by momentum alone: whatever the rim's law, the flights
/// before and after an impact fix the centre of its impulse in time. With T from the one's end to the other's begin,
///   t_F = t_after - (u_before + v_before T + int (t_after - t) a dt - u_after) / (v_before + int a dt - v_after),
/// radial, a the acceleration by dish, friction and ground along the recorded path, by the reduced model. The force
/// channel has a centre of its own.
#pragma once
#include "calibration/data/measured_record.h"
#include <optional>

namespace rimpact::calibration {

struct ChannelLag {
  double lag;    ///< of the force behind the displacement [s]
  double unsure; ///< of it, by the noise of both, the samples and what the model's acceleration may be off in [s]
};

/// Of one contact, along its outward unit vector. Needs velocities in the run's response. Empty where a flight beside
/// it is too short, or the impact lifts the slider off the dish.
std::optional<ChannelLag> channel_lag(const StoredRun &run, const MeasuredRecord &record, std::size_t contact,
                                      const Eigen::Vector2d &direction);

} // namespace rimpact::calibration
