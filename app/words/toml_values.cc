#include "app/words/toml_values.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rimpact::app {
namespace {

void flatten(const toml::table &table, const std::string &prefix, std::map<std::string, std::string> &values) {
  for (const auto &[key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const auto *inner = node.as_table())
      flatten(*inner, name + ".", values);
    else
      values[name] = as_written(node);
  }
}

} // namespace

std::string as_written(const toml::node &node) {
  if (const auto *text = node.as_string()) return nlohmann::json(text->get()).dump(); // quoted and escaped as TOML does
  if (const auto *flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto *whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto *number = node.as_floating_point()) return fmt::format("{}", number->get());
  const auto *array = node.as_array();
  if (!array) return {};
  std::string text;
  for (const auto &element : *array) text += (text.empty() ? "" : ", ") + as_written(element);
  return "[" + text + "]";
}

std::map<std::string, std::string> flattened(const TomlFile &file) {
  std::map<std::string, std::string> values;
  flatten(file.root(), "", values);
  return values;
}

} // namespace rimpact::app
