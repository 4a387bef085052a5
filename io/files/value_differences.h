/// Which values of two lists by key differ.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace rimpact {

struct ValueDifference {
  std::string key, a, b; ///< "-": that list has no such key
};

/// By their texts, in the order of the keys.
std::vector<ValueDifference> value_differences(const std::map<std::string, std::string> &a,
                                               const std::map<std::string, std::string> &b);

} // namespace rimpact
