/// The part of a fleet or study that one call runs.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace rimpact::app {

/// "2/8" -> {2, 8}; empty: {1, 1}. Throws InputError naming the word.
std::pair<int, int> parse_shard(const std::string &text);

/// Every `n_parts`-th one from the `part`-th (from 1) on.
template <class T> std::vector<T> shard_of(const std::vector<T> &all, int part, int n_parts) {
  std::vector<T> own;
  for (std::size_t k = part - 1; k < all.size(); k += n_parts) own.push_back(all[k]);
  return own;
}

} // namespace rimpact::app
