/// What a folder's records are: station, direction, pair; by their headers first, by their names second.
#pragma once
#include "io/records/direction.h"
#include <string>
#include <vector>

namespace rimpact {

/// One component: a file of a folder, or a channel of it.
struct FolderRecord {
  std::string path = {};                ///< as read_record takes it
  std::string file = {};                ///< its name in the folder, with the channel where there are several
  std::string form = {};                ///< of record_format.h
  std::string station = {};             ///< what the names of its components have in common, or the header's station
  Direction direction = {};             ///< unknown: it is not used, and asked about
  std::string rsn = {};                 ///< PEER's record sequence number, of its name; empty: none
  std::string unit = {};                ///< what records.csv says; empty: the header's
  bool left_out = false;                ///< records.csv says so
  std::vector<std::string> doubts = {}; ///< sentences
};

/// Components that were recorded together.
struct Station {
  std::string name;
  std::vector<std::size_t> horizontal; ///< of RecordFolder::records, by azimuth
  std::vector<std::size_t> vertical;
  /// The two horizontal components; empty: there are none or one, or more than two, of which two are not chosen.
  bool is_pair() const { return horizontal.size() == 2; }
};

struct RecordFolder {
  std::string path = {};
  std::vector<FolderRecord> records; ///< by name
  std::vector<Station> stations;     ///< by name; of records whose direction is known
  /// A sentence that names the records whose direction is not known, and says how to tell it; empty: there are none.
  std::string question() const;
  void require_any() const; ///< throws InputError where there is no record
};

/// Every record of a folder or of a zip archive, of every form. Its `records.csv` (record_corrections.h; columns file,
/// station, direction, and if wanted unit) has the last word: "none" as direction leaves a record out. Throws
/// InputError for what is neither, DataError naming the line for a records.csv with a file that is not there, a
/// direction or a unit that is not known.
RecordFolder read_record_folder(const std::string &folder);
/// Whether a name is a folder's or an archive's.
bool holds_records(const std::string &name);

/// The components of one file; a name with a channel (record_file.h) is that one alone. Throws DataError where it
/// cannot be read.
std::vector<FolderRecord> records_of_file(const std::string &name);

/// What a records.csv says of a folder as it was understood, to be corrected by hand.
std::string records_csv(const RecordFolder &folder);

} // namespace rimpact
