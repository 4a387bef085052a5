#include "io/files/value_differences.h"

namespace rimpact {

std::vector<ValueDifference> value_differences(const std::map<std::string, std::string> &a,
                                               const std::map<std::string, std::string> &b) {
  auto all = a;
  all.insert(b.begin(), b.end());
  const auto value_in = [](const auto &values, const std::string &key) {
    const auto found = values.find(key);
    return found == values.end() ? "-" : found->second;
  };
  std::vector<ValueDifference> result;
  for (const auto &[key, value] : all)
    if (value_in(a, key) != value_in(b, key)) result.push_back({key, value_in(a, key), value_in(b, key)});
  return result;
}

} // namespace rimpact
