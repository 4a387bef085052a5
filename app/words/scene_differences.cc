#include "app/words/scene_differences.h"

#include "app/words/toml_values.h"
#include "io/files/text.h"
#include "io/files/value_differences.h"
#include <algorithm>

namespace rimpact::app {
namespace {

bool is_a_name(const std::string &key) {
  return key == "name" || key == "bearing.name" || key.find("assum") != std::string::npos ||
         key == "bearing.material.steel.strain_limit";
}

bool of_the_model(const std::string &key) {
  return key.rfind("model.", 0) == 0 || key.rfind("reduced.", 0) == 0 || key == "excitation.duration_s";
}

/// Numbers by value: 1 and 1.0 are the same.
bool same(const std::string &a, const std::string &b) {
  const auto x = to_number(a), y = to_number(b);
  return x && y && *x == *y;
}

} // namespace

std::vector<Difference> differences(const std::string &scene_a, const std::string &scene_b) {
  std::vector<Difference> result;
  for (const auto &[key, a, b] :
       value_differences(flattened(TomlFile(scene_a, "A")), flattened(TomlFile(scene_b, "B"))))
    if (!is_a_name(key) && !same(a, b)) result.push_back({key, a, b, of_the_model(key)});
  std::stable_partition(result.begin(), result.end(), [](const Difference &each) { return !each.comparable; });
  return result;
}

nlohmann::json to_json(const std::vector<Difference> &differences) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto &[key, a, b, comparable] : differences)
    list.push_back({{"key", key}, {"a", a}, {"b", b}, {"comparable", comparable}});
  return list;
}

} // namespace rimpact::app
