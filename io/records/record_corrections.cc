#include "io/records/record_corrections.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/loose_csv.h"
#include "io/files/text.h"
#include "io/files/zip_archive.h"
#include "io/records/record_file.h"
#include "io/records/record_units.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact {
namespace {

namespace fs = std::filesystem;
constexpr const char *leave_out = "none", *table_name = "records.csv";

/// A records.csv: where it stands, and its text.
struct Corrections {
  std::string path, text;
  LooseTable table() const { return {text, path, {"file", "station", "direction"}}; }
};

/// Of a folder, or of an archive: the file beside it, else the member that lies in the fewest folders.
std::optional<Corrections> corrections_of(const std::string &holder) {
  std::error_code none;
  const std::string file = corrections_path(holder);
  if (fs::is_regular_file(file, none)) return Corrections{file, read_file(file)};
  if (!is_zip_archive(holder)) return std::nullopt;
  const ZipArchive archive(holder);
  std::string member;
  const auto depth = [](const std::string &name) { return std::count(name.begin(), name.end(), '/'); };
  for (const auto &name : archive.names())
    if (fs::path(name).filename() == table_name && (member.empty() || depth(name) < depth(member))) member = name;
  if (member.empty()) return std::nullopt;
  return Corrections{holder + "/" + member, archive.read(member)};
}

/// What a row may call a record: its name, in an archive also with the folders there.
std::vector<std::string> names_of(const std::string &record) {
  const RecordName name = record_name(record);
  std::vector<std::string> names{fs::path(record).filename().string()};
  if (!name.member.empty()) names.push_back(record.substr(name.file.size() + 1));
  return names;
}

bool is_called(const std::string &record, const std::string &cell) {
  const auto names = names_of(record);
  return std::find(names.begin(), names.end(), cell) != names.end();
}

/// The record that a row names; none would be a mistake, two as well.
std::size_t named_record(const std::vector<FolderRecord> &records, const std::string &cell, const std::string &where) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < records.size(); ++i)
    if (is_called(records[i].path, cell)) found.push_back(i);
  if (found.empty()) throw DataError(fmt::format("{}: \"{}\" is no record of this folder", where, cell));
  if (found.size() > 1)
    throw DataError(fmt::format("{}: \"{}\" is the name of {} records; with its folder, as \"{}\", it is one", where,
                                cell, found.size(), names_of(records[found[0]].path).back()));
  return found[0];
}

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

std::string corrections_path(const std::string &holder) {
  if (!is_zip_archive(holder)) return (fs::path(holder) / table_name).string();
  return (fs::path(holder).parent_path() / (fs::path(holder).stem().string() + "." + table_name)).string();
}

bool is_corrections(const std::string &path) {
  const std::string name = fs::path(path).filename().string();
  return name == table_name || name.ends_with(std::string(".") + table_name);
}

std::vector<std::string> files_of_record(const std::string &record) {
  const RecordName name = record_name(record);
  std::vector<std::string> files{name.file};
  std::error_code none;
  const std::string table =
      corrections_path(name.member.empty() ? fs::path(name.file).parent_path().string() : name.file);
  if (fs::is_regular_file(table, none) && stated_unit(record, 1)) files.push_back(table);
  return files;
}

std::optional<double> stated_unit(const std::string &record, double gravity) {
  const RecordName name = record_name(record);
  const auto corrections = corrections_of(name.member.empty() ? fs::path(record).parent_path().string() : name.file);
  if (!corrections) return std::nullopt;
  const LooseTable table = corrections->table();
  for (const auto &row : table.rows())
    if (is_called(record, table.text(row, "file")))
      return unit_in(table, row, fmt::format("{}:{}", corrections->path, row.line), gravity);
  return std::nullopt;
}

void correct_by_file(const std::string &folder, std::vector<FolderRecord> &records, std::vector<std::string> &headers) {
  const auto corrections = corrections_of(folder);
  if (!corrections) return;
  const LooseTable table = corrections->table();
  for (const auto &row : table.rows()) {
    const std::string where = fmt::format("{}:{}", corrections->path, row.line);
    const std::size_t i = named_record(records, table.text(row, "file"), where);
    FolderRecord &record = records[i];
    const std::string &station = table.text(row, "station"), &direction = table.text(row, "direction");
    if (!station.empty()) record.station = headers[i] = station;
    record.left_out = direction == leave_out;
    if (unit_in(table, row, where, 1)) record.unit = table.text(row, "unit");
    if (direction.empty() || record.left_out) continue;
    record.direction = corrected(direction, where);
    record.doubts.clear(); // of header and name, which count no longer
  }
}

std::string records_csv(const RecordFolder &folder) {
  std::string text = "# What `rimpact motion` understood. Correct station and direction; an empty direction is not "
                     "known, \"none\" leaves the record out. A unit (g, m/s2, cm/s2, gal, mm/s2) takes the place of "
                     "the header's; empty: the header's counts.\nfile,station,direction,unit\n";
  for (const auto &record : folder.records)
    text += fmt::format("{},{},{},{}\n", cell_of(names_of(record.path).back()), cell_of(record.station),
                        record.left_out ? leave_out : record.direction.spelling, cell_of(record.unit));
  return text;
}

} // namespace rimpact
