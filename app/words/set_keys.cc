#include "app/words/set_keys.h"

#include "io/files/error.h"
#include "io/files/toml_file.h"
#include <fmt/format.h>

namespace rimpact::app {
namespace {

void collect(const toml::table &table, const std::string &prefix, std::vector<std::string> &keys) {
  for (const auto &[name, node] : table) {
    const std::string path = prefix + std::string(name.str());
    if (const auto *inner = node.as_table(); inner && !inner->empty())
      collect(*inner, path + ".", keys);
    else
      keys.push_back(path);
  }
}

} // namespace

std::vector<std::string> keys_set(const std::vector<std::string> &assignments) {
  std::vector<std::string> keys;
  for (const auto &assignment : assignments) {
    TomlFile file("", "");
    file.set(assignment);
    collect(file.root(), "", keys);
  }
  return keys;
}

bool is_in(const std::string &key, const std::string &table) {
  return key == table || key.starts_with(table + ".");
}

void refuse_unread(const std::vector<std::string> &assignments, const std::string &verb, const WhyUnread &why_unread) {
  for (const auto &assignment : assignments)
    for (const auto &key : keys_set({assignment}))
      if (const std::string why = why_unread(key); !why.empty())
        throw InputError(fmt::format("--set {}: rimpact {} does not read {}: {}", assignment, verb, key, why));
}

} // namespace rimpact::app
