/// Two horizontal components turned into fault-normal and fault-parallel ones.
#pragma once
#include "io/records/direction.h"
#include "io/records/sampled_signal.h"

namespace rimpact {

struct FaultComponents {
  SampledSignal normal, parallel; ///< along strike + 90 and along strike
};

/// `first` and `second` [m/s^2] along azimuths [deg] clockwise from north, which need not be at right angles; `strike`
/// likewise. The motion is resolved into north and east, then turned. The common part of both is kept. Throws DataError
/// for an azimuth that is not known, azimuths less than 20 degrees apart, and different steps.
FaultComponents fault_components(const SampledSignal &first, const Direction &first_direction,
                                 const SampledSignal &second, const Direction &second_direction, double strike);

} // namespace rimpact
