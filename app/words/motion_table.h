/// What `rimpact motion` says of records: a row for each component.
#pragma once
#include "io/records/record.h"
#include "io/records/record_folder.h"
#include "io/records/rotated_spectrum.h"
#include "io/records/velocity_pulse.h"
#include <nlohmann/json.hpp>
#include <optional>

namespace rimpact::app {

struct MotionRow {
  FolderRecord record = {};                        ///< its doubts are all of them, of the folder and of the signal
  std::string pair = {};                           ///< the other horizontal component's file; empty: there is none
  std::optional<RecordInfo> info = {};             ///< none: it cannot be read, a doubt says why
  std::optional<ClassifiedPulse> pulse = {};       ///< of the pair
  std::optional<double> sa = {};                   ///< spectral acceleration at the period asked for [m/s^2]
  std::optional<RotatedAcceleration> rotated = {}; ///< the same of the pair
};

/// Of a file, its channels or a built-in record. Throws as read_record. `period` [s]: of the spectral accelerations
/// with 5 % damping, 0: none.
std::vector<MotionRow> rows_of_file(const std::string &name, double period);
/// Of every record of a folder, station by station; those without a known direction stand last.
std::vector<MotionRow> rows_of_folder(const RecordFolder &folder, double period);

nlohmann::ordered_json to_json(const MotionRow &row);
/// A line a row by itself, with its doubts below.
std::string motion_lines(const std::vector<MotionRow> &rows);
/// A line a row under a head line, doubts below their row: of a folder. Columns of S_a where one was asked for.
std::string motion_table(const std::vector<MotionRow> &rows);

} // namespace rimpact::app
