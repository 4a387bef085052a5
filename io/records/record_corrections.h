/// What the records.csv of a folder or an archive says of its records.
#pragma once
#include "io/records/record_folder.h"
#include <optional>
#include <string>
#include <vector>

namespace rimpact {

/// Where the records.csv of a folder stands, FOLDER/records.csv, or that of an archive, records.zip: beside it,
/// records.records.csv, which takes the place of a records.csv among its members.
std::string corrections_path(const std::string &holder);
/// Whether a file is such a table by its name, and not a record.
bool is_corrections(const std::string &path);

/// The unit [m/s^2] that the records.csv of a record's folder or archive states for it; none: there is no such file, or
/// it says nothing of this record. Throws DataError naming its line for a unit that is not known.
std::optional<double> stated_unit(const std::string &record, double gravity);

/// The files that a record's numbers come from: its own or its archive, and the records.csv that states its unit.
std::vector<std::string> files_of_record(const std::string &record);

/// Replaces station and direction of the records that the records.csv of a folder or an archive names, in an archive by
/// their names alone or with the folders there; an empty cell says nothing, the
/// direction "none" leaves the record out, and a unit is kept as it is written. `headers`: the station that each
/// record's header names; a station of the file takes its place. Nothing happens where there is no such file. Throws
/// DataError naming its line.
void correct_by_file(const std::string &folder, std::vector<FolderRecord> &records, std::vector<std::string> &headers);

} // namespace rimpact
