/// K-NET's and KiK-net's tables (NIED): blocks of lines that begin with "#", then time, relative time and a column for
/// each component in gal.
#pragma once
#include "io/records/record_format.h"

namespace rimpact {

/// Whether a text's beginning is such a table's: "#K-NET CSV".
bool is_knet_table(std::string_view text);

/// One channel: its column in gal less its mean, the instrument's offset. Sampling and number of samples are held
/// against the header's, the latter to a second, and relative times against the sampling.
SampledSignal parse_knet_csv(const std::string &text, const std::string &path, const ReadAs &as);
/// Columns 1 to 3 of KiK-net are the borehole's, 4 to 6 the surface's: two stations.
RecordHead head_of_knet_csv(const Channel &channel);
std::vector<Channel> channels_of_knet_csv(std::string_view text);

} // namespace rimpact
