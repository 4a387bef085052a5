#include "studies/risk/comparisons.h"
#include <algorithm>
#include <set>

namespace rimpact::risk {
namespace {

/// The difference's key and every key that follows from it.
std::set<std::string> keys_together(const Study &study, const std::string &key) {
  std::set<std::string> together{key};
  for (const auto *cases : {&study.parts.cases, &study.parts.devices}) {
    if (cases->empty()) continue;
    const auto &axes = cases->front();
    if (std::any_of(axes.begin(), axes.end(), [&](const auto &axis) { return axis.key == key; }))
      for (const auto &axis : axes) together.insert(axis.key);
  }
  for (const auto &linked : study.parts.linked) {
    const auto follows = [&](const std::string &factor) { return together.count(factor) > 0; };
    if (std::any_of(linked.factors.begin(), linked.factors.end(), follows) || follows(linked.divisor))
      together.insert(linked.key);
  }
  return together;
}

} // namespace

std::vector<Comparison> comparisons(const Study &study, const Systems &systems) {
  std::vector<Comparison> result;
  for (std::size_t d = 0; d < study.differences.size(); ++d) {
    const auto together = keys_together(study, study.differences[d].key);
    const auto at = static_cast<std::size_t>(
        std::find(systems.keys.begin(), systems.keys.end(), study.differences[d].key) - systems.keys.begin());
    const auto is_reference = [&](std::size_t s) {
      return systems.all[s].values[at] == study.differences[d].reference;
    };
    const auto alike = [&](std::size_t a, std::size_t b) {
      for (std::size_t i = 0; i < systems.keys.size(); ++i)
        if (together.count(systems.keys[i]) == 0 && systems.all[a].values[i] != systems.all[b].values[i]) return false;
      return true;
    };
    for (std::size_t s = 0; s < systems.size(); ++s)
      for (std::size_t reference = 0; reference < systems.size() && !is_reference(s); ++reference)
        if (is_reference(reference) && alike(s, reference)) result.push_back({d, s, reference});
  }
  return result;
}

} // namespace rimpact::risk
