#include "risk/record_shelf.h"
#include "files/error.h"
#include "files/text.h"
#include "records/record_library.h"
#include "records/spectral_acceleration.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <regex>

namespace rimpact::risk {
namespace {

namespace fs = std::filesystem;

bool is_record(const fs::path &path) {
  static const std::regex vertical(".*([-_](UP|DWN|VER|V|Z)|VRT)", std::regex::icase);
  return upper(path.extension().string()) == ".AT2" && !std::regex_match(path.stem().string(), vertical);
}

std::string number_of(const std::string &name) {
  static const std::regex rsn("RSN0*([0-9]+)_.*", std::regex::icase);
  std::smatch part;
  return std::regex_match(name, part, rsn) ? part[1].str() : "";
}

} // namespace

RecordShelf::RecordShelf(const std::vector<std::string> &folders, double period_s) : period_(period_s) {
  for (const auto &folder : folders) {
    std::error_code error;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::end(entry); entry.increment(error))
      if (is_record(entry->path()))
        files_.emplace(entry->path().filename().string(), fs::absolute(entry->path()).lexically_normal().string());
    if (error) throw InputError(fmt::format("the folder of records {} cannot be read: {}", folder, error.message()));
  }
  for (const auto &[name, path] : files_)
    if (const auto rsn = number_of(name); !rsn.empty()) by_number_[rsn].push_back(path);
}

std::vector<std::string> RecordShelf::components(const std::string &rsn) const {
  const auto found = by_number_.find(rsn);
  return found == by_number_.end() ? std::vector<std::string>() : found->second;
}

std::vector<std::string> RecordShelf::all() const {
  std::vector<std::string> paths;
  for (const auto &[name, path] : files_) paths.push_back(path);
  return paths;
}

double RecordShelf::sa_g(const std::string &file) {
  const auto known = sa_.find(file);
  if (known != sa_.end()) return known->second;
  return sa_[file] = spectral_acceleration(*shared_record(file), period_) / standard_gravity;
}

} // namespace rimpact::risk
