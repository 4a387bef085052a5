/// Headers held against the data behind them: where they disagree one of both is damaged; an instrument's offset.
#pragma once
#include "io/records/sampled_signal.h"
#include <string>

namespace rimpact {

/// The offset of an instrument is no motion. Nothing happens to a signal without samples.
void take_mean_off(SampledSignal &signal);

/// Throws DataError with both figures unless `stated` values, of the header's `key`, are there.
void require_count(const std::string &path, const char *key, double stated, std::size_t found);

/// The same for a largest absolute value [m/s^2], in either sign. Headers round, and filters and offsets differ:
/// `slack` of it is allowed.
void require_peak(const std::string &path, const char *key, double stated, const SampledSignal &record,
                  double slack = 0.02);

} // namespace rimpact
