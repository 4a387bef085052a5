/// Whether a record's force and displacement have one clock, by momentum alone: whatever the rim's law, the flights
/// before and after an impact fix the centre of its impulse in time. With T from the one's end to the other's begin,
///   t_F = t_after - (u_before + v_before T + a T^2 / 2 - u_after) / (v_before + a T - v_after),
/// radial, a the other forces' acceleration, taken from the flights. The force channel has a centre of its own.
#pragma once
#include "calibration/data/measured_record.h"
#include <optional>

namespace rimpact::calibration {

struct ChannelLag {
  double lag;    ///< of the force behind the displacement [s]
  double unsure; ///< of it, by the noise of both, the samples and what the flights' accelerations differ in [s]
};

/// Of one contact, along its outward unit vector. Empty where a flight beside it is too short.
std::optional<ChannelLag> channel_lag(const MeasuredRecord &record, const std::vector<double> &times,
                                      std::size_t contact, const Eigen::Vector2d &direction);

} // namespace rimpact::calibration
