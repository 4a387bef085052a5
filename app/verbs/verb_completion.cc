// rimpact completion SHELL: what a shell needs to complete the command's words.
#include "app/console/child_process.h"
#include "app/verbs/catalogue.h"
#include "app/words/completion_scripts.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace rimpact::app {
namespace {

nlohmann::json json_of(const std::vector<VerbWords> &verbs) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto &verb : verbs) {
    nlohmann::json options = nlohmann::json::array();
    for (const auto &o : verb.options)
      options.push_back(
          {{"names", o.names}, {"description", o.description}, {"values", o.values}, {"takes_value", o.takes_value}});
    list.push_back({{"name", verb.name}, {"description", verb.description}, {"options", options}});
  }
  return list;
}

std::vector<VerbWords> tree_of(const nlohmann::json &list) {
  std::vector<VerbWords> verbs;
  for (const auto &each : list) {
    VerbWords verb{each.at("name"), each.at("description"), {}};
    for (const auto &o : each.at("options"))
      verb.options.push_back({o.at("names"), o.at("description"), o.at("values"), o.at("takes_value")});
    verbs.push_back(std::move(verb));
  }
  return verbs;
}

/// The finite-element program's own tree; nothing where it was not built.
std::vector<VerbWords> fe_tree() {
  const std::string program = program_beside("rimpact-fe");
  if (access(program.c_str(), X_OK) != 0) return {};
  const std::string kept = (std::filesystem::temp_directory_path() / fmt::format("rimpact-tree-{}", getpid())).string();
  const int code = poll(start({.command = {program, "completion", "json"}, .output = kept}), true);
  const std::string text = code == 0 ? read_file(kept) : "[]";
  std::filesystem::remove(kept);
  return tree_of(nlohmann::json::parse(text));
}

void add_completion(CLI::App &verb, Console &console) {
  auto shell = std::make_shared<std::string>();
  verb.add_option("SHELL", *shell, "bash | zsh | fish; json: the verbs and options themselves")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish", "json"}));
  console.add_common(verb);
  verb.callback([shell, &app = *verb.get_parent(), &console] {
    auto verbs = command_tree(app);
    const bool is_light = std::any_of(verbs.begin(), verbs.end(), [](const auto &v) { return v.name == "list"; });
    if (is_light) // it knows the names of the finite-element verbs only
      for (auto &other : fe_tree())
        for (auto &own : verbs)
          if (own.name == other.name && own.options.size() < other.options.size()) own = other;
    const auto known = parse<Shell>(*shell); // else json
    console.data(known ? completion_script(*known, verbs) : json_text(json_of(verbs)));
  });
}

} // namespace

const Verb completion_verb{{.name = "completion",
                            .help = "the script by which bash, zsh or fish complete this command",
                            .examples = "rimpact completion bash > ~/.local/share/bash-completion/completions/rimpact"},
                           add_completion};

} // namespace rimpact::app
