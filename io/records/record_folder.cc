#include "io/records/record_folder.h"
#include "io/files/digit.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include "io/files/zip_archive.h"
#include "io/records/record_corrections.h"
#include "io/records/record_file.h"
#include "io/records/stations.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <functional>

namespace rimpact {
namespace {

namespace fs = std::filesystem;

/// The first bytes of a file; empty where it cannot be read.
std::string beginning_of(const fs::path &path) {
  std::string text(4096, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

bool is_record(const fs::directory_entry &entry) {
  std::error_code none;
  return entry.is_regular_file(none) && !is_corrections(entry.path().string()) &&
         is_record_file(beginning_of(entry.path()), upper(entry.path().extension().string()));
}

using Visit = std::function<void(const RecordFile &)>;

void visit_archive(const std::string &path, const Visit &visit) {
  const ZipArchive archive(path);
  for (const auto &name : archive.names()) {
    constexpr std::size_t beginning = 4096;
    const fs::path member(name);
    if (member.filename().string().starts_with("._") || // a Macintosh's shadow of a file
        is_corrections(name) || !is_record_file(archive.read(name, beginning), upper(member.extension().string())))
      continue;
    visit(RecordFile(archive.read(name), path + "/" + name));
  }
}

void visit_records(const std::string &folder, const Visit &visit) {
  if (is_zip_archive(folder)) return visit_archive(folder, visit);
  std::error_code error;
  std::vector<fs::path> paths;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::end(entry); entry.increment(error))
    if (is_record(*entry)) paths.push_back(entry->path());
  if (error) throw InputError(fmt::format("the folder {} cannot be read: {}", folder, error.message()));
  std::sort(paths.begin(), paths.end());
  for (const auto &path : paths) visit(RecordFile(read_file(path.string()), path.string()));
}

std::string rsn_in(const std::string &name) {
  const std::string capitals = upper(name);
  if (!capitals.starts_with("RSN")) return {};
  const auto end = std::find_if_not(capitals.begin() + 3, capitals.end(), is_digit);
  if (end == capitals.end() || *end != '_') return {};
  const std::string digits(capitals.begin() + 3, end);
  const auto first = digits.find_first_not_of('0');
  return first == std::string::npos ? std::string() : digits.substr(first);
}

/// Doubts where header and name tell different directions.
void doubt_contradiction(const Direction &header, const Direction &name, FolderRecord &record) {
  const bool other_kind = header.kind != name.kind;
  const bool other_angle = header.azimuth_deg && name.azimuth_deg && *header.azimuth_deg != *name.azimuth_deg &&
                           std::abs(*header.azimuth_deg - *name.azimuth_deg) != 360;
  if (other_kind || other_angle)
    record.doubts.push_back(
        fmt::format("its header says direction {}, its name {}: the header's counts", header.spelling, name.spelling));
}

/// A component, and the station that its header names; only a header that also says a direction is one of a known kind.
struct Identified {
  FolderRecord record;
  std::string header_station;
};

Identified identify(const RecordFile &file, std::size_t channel) {
  const fs::path path(file.path());
  const std::string stem = path.stem().string();
  const bool alone = file.n_channels() == 1;
  const RecordHead head = file.head(channel);
  const NamedDirection named = alone ? direction_in_name(stem) : NamedDirection{stem, {}};
  const std::string name = file.name(channel);
  const std::string together = head.instrument.empty() ? stem : stem + " " + head.instrument;
  Identified result{{.path = name, .file = fs::path(name).filename().string(), .form = file.format().name},
                    alone ? std::string() : together};
  FolderRecord &record = result.record;
  record.rsn = rsn_in(stem);
  record.direction = direction_written(head.direction);
  record.station = alone ? named.station : together;
  if (record.direction.kind == DirectionKind::unknown) {
    record.direction = named.direction;
    return result;
  }
  if (alone) result.header_station = head.station;
  if (named.direction.kind != DirectionKind::unknown)
    doubt_contradiction(record.direction, named.direction, record);
  else if (alone && !head.station.empty())
    record.station = head.station;
  return result;
}

} // namespace

std::string RecordFolder::question() const {
  std::vector<std::string> unknown;
  for (const auto &record : records)
    if (record.direction.kind == DirectionKind::unknown && !record.left_out) unknown.push_back(record.file);
  if (unknown.empty()) return {};
  constexpr std::size_t told = 5;
  const std::size_t more = unknown.size() > told ? unknown.size() - told : 0;
  unknown.resize(unknown.size() - more);
  return fmt::format("the direction of {}{} is told neither by header nor by name: not used. `rimpact motion {} --ask` "
                     "writes {}, which takes it",
                     fmt::join(unknown, ", "), more ? fmt::format(" and {} more", more) : "", path,
                     corrections_path(path));
}

void RecordFolder::require_any() const {
  if (records.empty()) throw InputError(fmt::format("the folder {} holds no record (AT2 or another form)", path));
}

std::vector<FolderRecord> records_of_file(const std::string &name) {
  const RecordName given = record_name(name);
  const auto file = RecordFile::read(given);
  std::vector<FolderRecord> records;
  const std::size_t first = given.channel ? file.chosen(given.channel) : 0,
                    last = given.channel ? first + 1 : file.n_channels();
  for (std::size_t i = first; i < last; ++i) records.push_back(identify(file, i).record);
  return records;
}

bool holds_records(const std::string &name) {
  std::error_code none;
  return fs::is_directory(name, none) || is_zip_archive(name);
}

RecordFolder read_record_folder(const std::string &folder) {
  RecordFolder result{.path = folder, .records = {}, .stations = {}};
  std::vector<std::string> headers; // of each record, the station that its header names
  visit_records(folder, [&](const RecordFile &file) {
    for (std::size_t channel = 0; channel < file.n_channels(); ++channel) {
      auto [record, station] = identify(file, channel);
      result.records.push_back(std::move(record));
      headers.push_back(std::move(station));
    }
  });
  correct_by_file(folder, result.records, headers);
  result.stations = stations_of(result.records, headers);
  return result;
}

} // namespace rimpact
