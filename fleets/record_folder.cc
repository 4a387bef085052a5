#include "fleets/record_folder.h"
#include "files/error.h"
#include "records/record.h"
#include "records/spectral_acceleration.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <regex>

namespace rimpact::fleets {
namespace {

namespace fs = std::filesystem;

bool is_at2(const fs::path &path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::toupper(c); });
  return ending == ".AT2";
}

std::vector<fs::path> at2_files(const std::string &folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::end(entry); entry.increment(error))
    if (is_at2(entry->path())) files.push_back(entry->path());
  if (error) throw InputError(fmt::format("the folder {} cannot be read: {}", folder, error.message()));
  if (files.empty()) throw InputError(fmt::format("the folder {} holds no AT2 file", folder));
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

std::vector<GroundMotion> ground_motions(const std::string &folder) {
  static const std::regex azimuth("(.+?)[-_]?([0-9]{3})"), vertical("(.+)[-_](UP|DWN|VER|V)", std::regex::icase);
  std::map<std::string, GroundMotion> motions;
  for (const auto &file : at2_files(folder)) {
    const std::string stem = file.stem().string();
    std::smatch part;
    const bool is_vertical = std::regex_match(stem, part, vertical);
    const bool has_station = is_vertical || std::regex_match(stem, part, azimuth);
    GroundMotion &motion = motions[has_station ? part[1].str() : stem];
    if (is_vertical)
      motion.vertical = file.string();
    else
      motion.horizontal.push_back(file.string());
  }
  std::vector<GroundMotion> result;
  for (auto &[name, motion] : motions) {
    motion.name = name;
    result.push_back(std::move(motion));
  }
  return result;
}

Intensity intensity(const std::vector<std::string> &horizontal, double sa_period) {
  Intensity largest{0, 0, 0};
  for (const auto &path : horizontal) {
    const auto record = read_record(path);
    const auto info = inspect(record);
    const double sa = sa_period > 0 ? spectral_acceleration(record, sa_period) / standard_gravity : 0.0;
    largest = {std::max(largest.pga_g, info.pga_g), std::max(largest.pgv, info.pgv), std::max(largest.sa_g, sa)};
  }
  return largest;
}

} // namespace rimpact::fleets
