#include "studies/risk/reductions.h"
#include <algorithm>

namespace rimpact::risk {

using nlohmann::ordered_json;

void Reductions::add(const std::string &key, const Cell &value, const std::string &quantity, const LimitResult &own,
                     const LimitResult &reference, const Banded &band) {
  Sum &sum = sums_[{key, value, quantity, own.limit}];
  sum.n_unknown += own.n_unknown + reference.n_unknown;
  sum.at_least = std::min(sum.at_least, reduction(own.if_all, reference.if_none));
  sum.at_most = std::max(sum.at_most, reduction(own.if_none, reference.if_all));
  ++sum.n, sum.total += band.value, sum.low = std::min(sum.low, band.value), sum.high = std::max(sum.high, band.value);
  sum.n_sure += band.low > 0 || band.high < 0;
}

ordered_json Reductions::json() const {
  auto list = ordered_json::array();
  for (const auto &[key, sum] : sums_) {
    const auto &[name, value, quantity, limit] = key;
    ordered_json entry{{"key", name}};
    if (const auto *text = std::get_if<std::string>(&value))
      entry["value"] = *text;
    else if (const auto *number = std::get_if<double>(&value))
      entry["value"] = *number;
    entry.update(ordered_json{{"quantity", quantity},
                              {"limit", limit},
                              {"n_systems", sum.n},
                              {"mean_reduction", sum.total / sum.n},
                              {"least_reduction", sum.low},
                              {"largest_reduction", sum.high},
                              {"n_systems_whose_band_excludes_0", sum.n_sure},
                              {"n_unknown", sum.n_unknown},
                              {"reduction_at_least", sum.at_least},
                              {"reduction_at_most", sum.at_most}});
    list.push_back(std::move(entry));
  }
  return list;
}

} // namespace rimpact::risk
