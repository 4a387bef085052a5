/// What a folder's records.csv says of its records.
#pragma once
#include "records/record_folder.h"

namespace rimpact {

/// Replaces station and direction of the records that FOLDER/records.csv names; an empty cell says nothing, the
/// direction "none" leaves the record out. `headers`: the station that each record's header names; a station of the
/// file takes its place. Nothing happens where there is no such file. Throws DataError naming its line.
void correct_by_file(const std::string &folder, std::vector<FolderRecord> &records, std::vector<std::string> &headers);

} // namespace rimpact
