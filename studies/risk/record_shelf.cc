#include "studies/risk/record_shelf.h"
#include "io/records/record_file.h"
#include "io/records/record_folder.h"
#include "io/records/record_library.h"
#include "io/records/scaled_copies.h"
#include "io/records/spectral_acceleration.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::risk {
RecordShelf::RecordShelf(const std::vector<std::string> &folders, double period_s) : period_(period_s) {
  namespace fs = std::filesystem;
  for (const auto &name : folders) {
    const RecordFolder folder = read_record_folder(name);
    if (const std::string question = folder.question(); !question.empty()) questions_.push_back(question);
    const auto path_of = [&](std::size_t i) {
      return fs::absolute(folder.records[i].path).lexically_normal().string();
    };
    for (const auto &station : folder.stations) {
      for (const std::size_t i : station.horizontal) stations_[path_of(i)] = station.name;
      if (!station.is_pair()) continue;
      pairs_[path_of(station.horizontal[0])] = path_of(station.horizontal[1]);
      pairs_[path_of(station.horizontal[1])] = path_of(station.horizontal[0]);
    }
    for (const auto &record : folder.records) {
      if (record.left_out || record.direction.kind != DirectionKind::horizontal) continue;
      const std::string path = fs::absolute(record.path).lexically_normal().string();
      if (files_.emplace(record.file, path).second && !record.rsn.empty()) by_number_[record.rsn].push_back(path);
    }
  }
}

std::vector<std::string> RecordShelf::components(const std::string &rsn) const {
  const auto found = by_number_.find(rsn);
  return found == by_number_.end() ? std::vector<std::string>() : found->second;
}

std::vector<std::string> RecordShelf::all() {
  std::vector<std::string> paths, own;
  std::vector<std::shared_ptr<const SampledSignal>> signals;
  for (const auto &[name, path] : files_) paths.push_back(path), signals.push_back(shared_record(path));
  copies_.clear();
  const auto copies = scaled_copies(signals);
  for (std::size_t i = 0; i < paths.size(); ++i)
    if (const auto &copy = copies[i])
      copies_.push_back(fmt::format("{} is {:.4g} times {}: it counts once", record_label(paths[i]), copy->factor,
                                    record_label(paths[copy->of])));
    else
      own.push_back(paths[i]);
  return own;
}

std::string RecordShelf::station(const std::string &file) const {
  const auto found = stations_.find(file);
  return found == stations_.end() ? record_label(file) : found->second;
}

std::optional<RotatedAcceleration> RecordShelf::rotated_g(const std::string &file) {
  const auto other = pairs_.find(file);
  if (other == pairs_.end()) return std::nullopt;
  if (const auto known = rotated_.find(file); known != rotated_.end()) return known->second;
  const auto [rotd50, rotd100] = rotated_acceleration(*shared_record(file), *shared_record(other->second), period_);
  const RotatedAcceleration in_g{rotd50 / standard_gravity, rotd100 / standard_gravity};
  rotated_[other->second] = in_g;
  return rotated_[file] = in_g;
}

double RecordShelf::sa_g(const std::string &file) {
  const auto known = sa_.find(file);
  if (known != sa_.end()) return known->second;
  return sa_[file] = spectral_acceleration(*shared_record(file), period_) / standard_gravity;
}

} // namespace rimpact::risk
