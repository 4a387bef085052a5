#include "responses/steel_by_depth.h"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

namespace rimpact {
namespace {

using nlohmann::json;

std::shared_ptr<const SteelByDepth> read(const std::string &folder) {
  std::ifstream file(std::filesystem::path(folder) / "calibration.json");
  const json text = json::parse(file, nullptr, false);
  const json *rows = &text;
  for (const char *key : {"answer", "strain", "rows"}) {
    if (!rows->is_object() || !rows->contains(key)) return nullptr;
    rows = &(*rows)[key];
  }
  std::vector<std::pair<double, double>> found;
  for (const json &row : *rows) {
    if (!row.is_object()) return nullptr;
    const json depth = row.value("penetration_mm", json()), strain = row.value("strain", json());
    if (depth.is_number() && strain.is_number() && depth.get<double>() > 0)
      found.emplace_back(depth.get<double>() / 1e3, strain.get<double>());
  }
  return found.empty() ? nullptr : std::make_shared<const SteelByDepth>(std::move(found));
}

} // namespace

SteelByDepth::SteelByDepth(std::vector<std::pair<double, double>> rows) : rows_(std::move(rows)) {
  std::sort(rows_.begin(), rows_.end());
  for (std::size_t i = 1; i < rows_.size(); ++i) rows_[i].second = std::max(rows_[i].second, rows_[i - 1].second);
}

std::shared_ptr<const SteelByDepth> SteelByDepth::of(const std::string &folder) {
  static std::mutex guard;
  static std::map<std::string, std::shared_ptr<const SteelByDepth>> known;
  const std::lock_guard lock(guard);
  const auto [entry, is_new] = known.try_emplace(folder);
  if (is_new) entry->second = read(folder);
  return entry->second;
}

std::optional<bool> SteelByDepth::is_beyond(double depth, double limit) const {
  std::pair<double, double> before{0, 0};
  for (const auto &row : rows_) {
    if (row.second > limit) {
      const double share = std::max(0.0, (limit - before.second) / (row.second - before.second));
      return depth > before.first + share * (row.first - before.first);
    }
    before = row;
  }
  if (depth > before.first) return std::nullopt;
  return false;
}

} // namespace rimpact
