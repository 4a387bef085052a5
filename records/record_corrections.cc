#include "records/record_corrections.h"
#include "files/error.h"
#include "files/file.h"
#include "files/loose_csv.h"
#include "files/text.h"
#include "records/record_file.h"
#include "records/record_units.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr const char *leave_out = "none";

/// A cell of a table: in quotes where it needs them.
std::string cell_of(const std::string &text) {
  if (text.find_first_of(",;\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

Direction corrected(const std::string &written, const std::string &where) {
  const Direction direction = direction_written(written);
  if (direction.kind != DirectionKind::unknown) return direction;
  throw DataError(fmt::format("{}: the direction \"{}\" is not known; an azimuth from 0 to 360, N, E, N55W, L, T, UP "
                              "or none (left out)",
                              where, written.substr(0, 40)));
}

/// The unit [m/s^2] that a row states; none: it states none, or there is no such column.
std::optional<double> unit_in(const LooseTable &table, const LooseRow &row, const std::string &where, double gravity) {
  if (!table.has("unit") || table.text(row, "unit").empty()) return std::nullopt;
  const std::string &name = table.text(row, "unit");
  if (const auto unit = acceleration_unit(name, gravity)) return unit;
  throw DataError(
      fmt::format("{}: the unit \"{}\" is not known (g, m/s2, cm/s2, gal, mm/s2)", where, name.substr(0, 40)));
}

} // namespace

std::vector<std::string> files_of_record(const std::string &record) {
  const RecordName name = record_name(record);
  std::vector<std::string> files{name.file};
  if (name.member.empty() && stated_unit(record, 1))
    files.push_back((std::filesystem::path(name.file).parent_path() / records_csv_name).string());
  return files;
}

std::optional<double> stated_unit(const std::string &record, double gravity) {
  const std::filesystem::path path(record);
  const std::string file = (path.parent_path() / records_csv_name).string();
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return std::nullopt;
  const LooseTable table(read_file(file), file, {"file", "station", "direction"});
  for (const auto &row : table.rows())
    if (table.text(row, "file") == path.filename().string())
      return unit_in(table, row, fmt::format("{}:{}", file, row.line), gravity);
  return std::nullopt;
}

void correct_by_file(const std::string &folder, std::vector<FolderRecord> &records, std::vector<std::string> &headers) {
  const std::string path = (std::filesystem::path(folder) / records_csv_name).string();
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return;
  const LooseTable table(read_file(path), path, {"file", "station", "direction"});
  for (const auto &row : table.rows()) {
    const std::string where = fmt::format("{}:{}", path, row.line), &file = table.text(row, "file");
    const auto record = std::find_if(records.begin(), records.end(), [&](const auto &r) { return r.file == file; });
    if (record == records.end()) throw DataError(fmt::format("{}: \"{}\" is no record of this folder", where, file));
    const std::string &station = table.text(row, "station"), &direction = table.text(row, "direction");
    if (!station.empty()) record->station = headers[static_cast<std::size_t>(record - records.begin())] = station;
    record->left_out = direction == leave_out;
    if (unit_in(table, row, where, 1)) record->unit = table.text(row, "unit");
    if (direction.empty() || record->left_out) continue;
    record->direction = corrected(direction, where);
    record->doubts.clear(); // of header and name, which count no longer
  }
}

std::string records_csv(const RecordFolder &folder) {
  std::string text = "# What `rimpact motion` understood. Correct station and direction; an empty direction is not "
                     "known, \"none\" leaves the record out. A unit (g, m/s2, cm/s2, gal, mm/s2) takes the place of "
                     "the header's; empty: the header's counts.\nfile,station,direction,unit\n";
  for (const auto &record : folder.records)
    text += fmt::format("{},{},{},{}\n", cell_of(record.file), cell_of(record.station),
                        record.left_out ? leave_out : record.direction.spelling, cell_of(record.unit));
  return text;
}

} // namespace rimpact
