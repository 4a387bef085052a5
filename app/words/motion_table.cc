#include "app/words/motion_table.h"
#include "io/files/error.h"
#include "io/records/near_fault_pulse.h"
#include "io/records/record_doubts.h"
#include "io/records/record_library.h"
#include "io/records/scaled_copies.h"
#include "io/records/spectral_acceleration.h"
#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace rimpact::app {
namespace {

MotionRow motion_row(const FolderRecord &record, double period) {
  MotionRow row{.record = record};
  const auto signal = shared_record(record.path);
  row.info = inspect(*signal);
  if (!is_builtin_record(record.path))
    for (auto &doubt : record_doubts(*signal, standard_gravity)) row.record.doubts.push_back(std::move(doubt));
  if (period > 0) row.sa = spectral_acceleration(*signal, period);
  return row;
}

/// A damaged record among others is a row that says so.
MotionRow row_or_reason(const FolderRecord &record, double period) {
  try {
    return motion_row(record, period);
  } catch (const DataError &error) {
    MotionRow row{.record = record};
    row.record.doubts.emplace_back(error.what());
    return row;
  }
}

/// What two components at right angles have in common.
void join_pair(MotionRow &first, MotionRow &second, double period) {
  first.pair = second.record.file, second.pair = first.record.file;
  if (!first.info || !second.info) return;
  const auto one = shared_record(first.record.path), two = shared_record(second.record.path);
  first.pulse = second.pulse = velocity_pulse(*one, *two);
  if (one->dt != two->dt) {
    const auto sentence =
        fmt::format("the components of {} have steps of {:g} and {:g} s", first.record.station, one->dt, two->dt);
    first.record.doubts.push_back(sentence), second.record.doubts.push_back(sentence);
  }
  if (period > 0) first.rotated = second.rotated = rotated_acceleration(*one, *two, period);
}

void doubt_copies(std::vector<MotionRow> &rows) {
  std::vector<std::shared_ptr<const SampledSignal>> signals;
  for (const auto &row : rows) signals.push_back(row.info ? shared_record(row.record.path) : nullptr);
  const auto copies = scaled_copies(signals);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (copies[i])
      rows[i].record.doubts.push_back(fmt::format("it is {:.4g} times {}: one record, given twice", copies[i]->factor,
                                                  rows[copies[i]->of].record.file));
}

} // namespace

std::vector<MotionRow> rows_of_file(const std::string &name, double period) {
  if (is_builtin_record(name))
    return {motion_row({.path = name, .file = name, .form = "built in", .station = name}, period)};
  std::vector<MotionRow> rows;
  for (const auto &record : records_of_file(name)) rows.push_back(motion_row(record, period));
  return rows;
}

std::vector<MotionRow> rows_of_folder(const RecordFolder &folder, double period) {
  std::vector<MotionRow> rows;
  std::set<std::size_t> told;
  for (const auto &station : folder.stations) {
    const std::size_t first = rows.size();
    for (const auto *part : {&station.horizontal, &station.vertical})
      for (const std::size_t i : *part) {
        FolderRecord record = folder.records[i];
        record.station = station.name;
        rows.push_back(row_or_reason(record, period));
        told.insert(i);
      }
    if (station.is_pair()) join_pair(rows[first], rows[first + 1], period);
  }
  for (std::size_t i = 0; i < folder.records.size(); ++i)
    if (told.count(i) == 0) {
      FolderRecord record = folder.records[i];
      record.doubts.emplace_back(record.left_out ? "left out by records.csv" : "its direction is not known");
      rows.push_back(row_or_reason(record, period));
    }
  doubt_copies(rows);
  return rows;
}

nlohmann::ordered_json to_json(const MotionRow &row) {
  const auto &record = row.record;
  const auto &info = row.info;
  const auto number = [&](auto RecordInfo::*member) {
    return info ? nlohmann::ordered_json((*info).*member) : nlohmann::ordered_json();
  };
  const auto &azimuth = record.direction.azimuth_deg;
  const auto in_g = [](const std::optional<double> &a) {
    return a ? nlohmann::ordered_json(*a / standard_gravity) : nlohmann::ordered_json();
  };
  const auto &rotated = row.rotated;
  return {{"file", record.path},
          {"form", record.form},
          {"station", record.station},
          {"direction", record.direction.spelling},
          {"kind", word(record.direction.kind)},
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
          {"pulse_period_s",
           row.pulse && row.pulse->period ? nlohmann::ordered_json(*row.pulse->period) : nlohmann::ordered_json()},
          {"pulse_indicator", row.pulse ? nlohmann::ordered_json(row.pulse->indicator) : nlohmann::ordered_json()},
          {"sa_g", in_g(row.sa)},
          {"rotd50_g", in_g(rotated ? std::optional(rotated->rotd50) : std::nullopt)},
          {"rotd100_g", in_g(rotated ? std::optional(rotated->rotd100) : std::nullopt)},
          {"doubts", record.doubts}};
}

std::string motion_lines(const std::vector<MotionRow> &rows) {
  std::string text;
  for (const auto &row : rows) {
    const auto &record = row.record;
    const auto &info = row.info;
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
  std::string text =
      fmt::format("{:<{}}  {:<{}}  {:<9} {:>7} {:>7} {:>8} {:>8} {:>8} {:>8} {:>7}", "station", station, "file", file,
                  "direction", "dt [s]", "NPTS", "t [s]", "PGA [g]", "PGV m/s", "PGD [m]", "T_p [s]");
  const bool has_sa = std::any_of(rows.begin(), rows.end(), [](const auto &row) { return row.sa.has_value(); });
  text += has_sa ? fmt::format(" {:>8} {:>10} {:>11}\n", "S_a [g]", "RotD50 [g]", "RotD100 [g]") : "\n";
  for (const auto &row : rows) {
    const auto &record = row.record;
    text += fmt::format("{:<{}}  {:<{}}  {:<9}", record.station, station, record.file, file,
                        record.direction.spelling.empty() ? "?" : record.direction.spelling);
    if (const auto &i = row.info)
      text += fmt::format(" {:>7g} {:>7} {:>8.2f} {:>8.4f} {:>8.4f} {:>8.4f}", i->dt, i->npts,
                          i->dt * static_cast<double>(i->npts - 1), i->pga_g, i->pgv, i->pgd);
    std::string rest =
        row.pulse && row.pulse->period ? fmt::format(" {:>7.2f}", *row.pulse->period) : std::string(8, ' ');
    if (row.sa) rest += fmt::format(" {:>8.4f}", *row.sa / standard_gravity);
    if (row.rotated)
      rest += fmt::format(" {:>10.4f} {:>11.4f}", row.rotated->rotd50 / standard_gravity,
                          row.rotated->rotd100 / standard_gravity);
    rest.resize(rest.find_last_not_of(' ') + 1);
    text += rest + "\n";
    for (const auto &doubt : record.doubts) text += fmt::format("  {}\n", doubt);
  }
  return text;
}

} // namespace rimpact::app
