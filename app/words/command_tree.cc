#include "app/words/command_tree.h"

#include "io/files/text.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::app {
namespace {

/// The words of a check that lists them: CLI11 describes it as {a,b,c}.
std::vector<std::string> values_of(const CLI::Option &option) {
  const std::string type = option.get_type_name();
  const auto open = type.find('{'), close = type.find('}');
  std::vector<std::string> values;
  if (open == std::string::npos || close == std::string::npos || close < open) return values;
  for (const auto word : split(std::string_view(type).substr(open + 1, close - open - 1), ','))
    values.emplace_back(trim(word));
  return values;
}

} // namespace

std::vector<VerbWords> command_tree(const CLI::App &app) {
  std::vector<VerbWords> verbs;
  for (const auto *verb : app.get_subcommands([](const CLI::App *each) { return !each->get_group().empty(); })) {
    VerbWords words{verb->get_name(), verb->get_description(), {}};
    for (const auto *option : verb->get_options()) {
      OptionWords entry{{}, option->get_description(), values_of(*option), option->get_items_expected_max() > 0};
      for (const auto &name : option->get_snames()) entry.names.push_back("-" + name);
      for (const auto &name : option->get_lnames()) entry.names.push_back("--" + name);
      words.options.push_back(std::move(entry));
    }
    verbs.push_back(std::move(words));
  }
  return verbs;
}

} // namespace rimpact::app
