/// Which records were taken together.
#pragma once
#include "io/records/record_folder.h"

namespace rimpact {

/// Records of known direction, grouped by the station that their headers name, else by that of their names. Where
/// several records of one header point one way, their names part them. Components that are not at right angles get a
/// doubt.
std::vector<Station> stations_of(std::vector<FolderRecord> &records, const std::vector<std::string> &headers);

} // namespace rimpact
