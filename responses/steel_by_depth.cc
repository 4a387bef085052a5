#include "responses/steel_by_depth.h"
#include "io/files/error.h"
#include "scene/stored_calibration.h"
#include <algorithm>
#include <map>
#include <mutex>

namespace rimpact {
namespace {

std::shared_ptr<const SteelByDepth> read(const std::string &folder) try {
  const auto answer = scene::read_calibration(folder).answer;
  if (!answer || !answer->strain) return nullptr;
  std::vector<std::pair<double, double>> found;
  for (const auto &row : answer->strain->rows)
    if (row.strain && row.depth && *row.depth > 0) found.emplace_back(*row.depth, *row.strain);
  return found.empty() ? nullptr : std::make_shared<const SteelByDepth>(std::move(found));
} catch (const Error &) { // whoever takes the law from the folder says what is wrong with it
  return nullptr;
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
