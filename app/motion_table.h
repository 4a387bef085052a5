/// What `rimpact motion` says of records: a row for each component.
#pragma once
#include "records/record.h"
#include "records/record_folder.h"
#include <nlohmann/json.hpp>
#include <optional>

namespace rimpact::app {

struct MotionRow {
  FolderRecord record;            ///< its doubts are all of them, of the folder and of the signal
  std::string pair;               ///< the other horizontal component's file; empty: there is none
  std::optional<RecordInfo> info; ///< none: it cannot be read, a doubt says why
};

/// Of a file, its channels or a built-in record. Throws as read_record.
std::vector<MotionRow> rows_of_file(const std::string &name);
/// Of every record of a folder, station by station; those without a known direction stand last.
std::vector<MotionRow> rows_of_folder(const RecordFolder &folder);

nlohmann::ordered_json to_json(const MotionRow &row);
/// A line a row by itself, with its doubts below.
std::string motion_lines(const std::vector<MotionRow> &rows);
/// A line a row under a head line, doubts below their row: of a folder.
std::string motion_table(const std::vector<MotionRow> &rows);

} // namespace rimpact::app
