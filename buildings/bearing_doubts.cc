#include "buildings/bearing_doubts.h"
#include "reduced_models/bearings/foot_limit.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace rimpact::buildings {
namespace {

/// The first of the bearings that is built as this one.
std::size_t first_alike(const std::vector<scene::Scene> &bearings, std::size_t b) {
  std::size_t first = 0;
  while (bearings[first].bearing_name() != bearings[b].bearing_name() ||
         bearings[first].isolator != bearings[b].isolator)
    ++first;
  return first;
}

} // namespace

std::vector<std::string> doubts_of_elements(const std::vector<scene::Scene> &bearings,
                                            const std::vector<double> &reactions) {
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> extremes; // of each kind, lightest and heaviest loaded
  for (std::size_t b = 0; b < bearings.size(); ++b) {
    auto &[light, heavy] = extremes.insert({first_alike(bearings, b), {b, b}}).first->second;
    if (reactions[b] < reactions[light]) light = b;
    if (reactions[b] > reactions[heavy]) heavy = b;
  }
  std::vector<std::string> sentences;
  std::set<std::string> said;
  for (const auto &[kind, pair] : extremes)
    for (const std::size_t b : {pair.first, pair.second}) {
      if (!(reactions[b] > 0)) continue;
      scene::Scene own = bearings[b];
      own.load.vertical = reactions[b], own.load.mass = reactions[b] / own.load.gravity;
      std::vector<std::string> doubts = scene::doubts_of_element(own);
      if (std::string foot = reduced::doubt_of_foot(own); !foot.empty()) doubts.push_back(std::move(foot));
      for (const auto &doubt : doubts)
        if (said.insert(doubt).second)
          sentences.push_back(fmt::format("bearing {} ({:.6g} kg): {}", b + 1, own.load.mass, doubt));
    }
  return sentences;
}

} // namespace rimpact::buildings
