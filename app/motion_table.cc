#include "app/motion_table.h"
#include "files/error.h"
#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace rimpact::app {
namespace {

const char *word_of(DirectionKind kind) {
  switch (kind) {
  case DirectionKind::horizontal:
    return "horizontal";
  case DirectionKind::vertical:
    return "vertical";
  case DirectionKind::unknown:
    break;
  }
  return "unknown";
}

MotionRow motion_row(FolderRecord record, std::string pair) {
  MotionRow row{.record = std::move(record), .pair = std::move(pair), .info = std::nullopt};
  row.info = inspect(read_record(row.record.path));
  return row;
}

/// A damaged record among others is a row that says so.
MotionRow row_or_reason(const FolderRecord &record, const std::string &pair) {
  try {
    return motion_row(record, pair);
  } catch (const DataError &error) {
    MotionRow row{.record = record, .pair = pair, .info = std::nullopt};
    row.record.doubts.emplace_back(error.what());
    return row;
  }
}

} // namespace

std::vector<MotionRow> rows_of_file(const std::string &name) {
  if (is_builtin_record(name)) {
    FolderRecord record{.path = name, .file = name, .form = "built in", .station = name};
    return {motion_row(record, "")};
  }
  std::vector<MotionRow> rows;
  for (const auto &record : records_of_file(name)) rows.push_back(motion_row(record, ""));
  return rows;
}

std::vector<MotionRow> rows_of_folder(const RecordFolder &folder) {
  std::vector<MotionRow> rows;
  std::set<std::size_t> told;
  for (const auto &station : folder.stations)
    for (const auto *part : {&station.horizontal, &station.vertical})
      for (std::size_t k = 0; k < part->size(); ++k) {
        FolderRecord record = folder.records[(*part)[k]];
        record.station = station.name;
        const bool paired = part == &station.horizontal && station.is_pair();
        rows.push_back(row_or_reason(record, paired ? folder.records[(*part)[1 - k]].file : ""));
        told.insert((*part)[k]);
      }
  for (std::size_t i = 0; i < folder.records.size(); ++i)
    if (told.count(i) == 0) {
      FolderRecord record = folder.records[i];
      record.doubts.emplace_back(record.left_out ? "left out by records.csv" : "its direction is not known");
      rows.push_back(row_or_reason(record, ""));
    }
  return rows;
}

nlohmann::ordered_json to_json(const MotionRow &row) {
  const auto &record = row.record;
  const auto &info = row.info;
  const auto number = [&](auto RecordInfo::*member) {
    return info ? nlohmann::ordered_json((*info).*member) : nlohmann::ordered_json();
  };
  const auto &azimuth = record.direction.azimuth_deg;
  return {{"file", record.path},
          {"form", record.form},
          {"station", record.station},
          {"direction", record.direction.spelling},
          {"kind", word_of(record.direction.kind)},
          {"azimuth_deg", azimuth ? nlohmann::ordered_json(*azimuth) : nlohmann::ordered_json()},
          {"pair", row.pair.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(row.pair)},
          {"npts", number(&RecordInfo::npts)},
          {"dt_s", number(&RecordInfo::dt)},
          {"length_s",
           info ? nlohmann::ordered_json(info->dt * static_cast<double>(info->npts - 1)) : nlohmann::ordered_json()},
          {"pga_g", number(&RecordInfo::pga_g)},
          {"pgv_m_per_s", number(&RecordInfo::pgv)},
          {"pgd_m", number(&RecordInfo::pgd)},
          {"arias_m_per_s", number(&RecordInfo::arias)},
          {"duration_5_95_s", number(&RecordInfo::duration)},
          {"doubts", record.doubts}};
}

std::string motion_lines(const std::vector<MotionRow> &rows) {
  std::string text;
  for (const auto &[record, pair, info] : rows) {
    text +=
        fmt::format("{}: NPTS {}, dt {} s, PGA {:.4f} g, PGV {:.4f} m/s, PGD {:.4f} m, Arias {:.3f} m/s, D5-95 "
                    "{:.2f} s{}{}\n",
                    record.path, info->npts, info->dt, info->pga_g, info->pgv, info->pgd, info->arias, info->duration,
                    record.direction.spelling.empty() ? "" : ", direction ", record.direction.spelling);
    for (const auto &doubt : record.doubts) text += fmt::format("  {}\n", doubt);
  }
  return text;
}

std::string motion_table(const std::vector<MotionRow> &rows) {
  std::size_t station = 7, file = 4;
  for (const auto &row : rows)
    station = std::max(station, row.record.station.size()), file = std::max(file, row.record.file.size());
  std::string text = fmt::format("{:<{}}  {:<{}}  {:<9} {:>7} {:>7} {:>8} {:>8} {:>8} {:>8}\n", "station", station,
                                 "file", file, "direction", "dt [s]", "NPTS", "t [s]", "PGA [g]", "PGV m/s", "PGD [m]");
  for (const auto &row : rows) {
    const auto &record = row.record;
    text += fmt::format("{:<{}}  {:<{}}  {:<9}", record.station, station, record.file, file,
                        record.direction.spelling.empty() ? "?" : record.direction.spelling);
    if (const auto &i = row.info)
      text += fmt::format(" {:>7g} {:>7} {:>8.2f} {:>8.4f} {:>8.4f} {:>8.4f}", i->dt, i->npts,
                          i->dt * static_cast<double>(i->npts - 1), i->pga_g, i->pgv, i->pgd);
    text += "\n";
    for (const auto &doubt : record.doubts) text += fmt::format("  {}\n", doubt);
  }
  return text;
}

} // namespace rimpact::app
