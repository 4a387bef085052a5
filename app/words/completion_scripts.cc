#include "app/words/completion_scripts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace rimpact::app {
namespace {

/// Within single quotes of a shell.
std::string quoted(const std::string &text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

/// A description for zsh: its specification gives meaning to brackets and colons.
std::string plain(const std::string &text) {
  std::string result;
  for (const char c : text) result += c == '[' || c == ']' || c == ':' || c == '\n' ? ' ' : c;
  return result;
}

std::vector<std::string> option_names(const VerbWords &verb) {
  std::vector<std::string> names;
  for (const auto &option : verb.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// Words of a place argument that has a list.
std::vector<std::string> place_values(const VerbWords &verb) {
  std::vector<std::string> values;
  for (const auto &option : verb.options)
    if (option.names.empty()) values.insert(values.end(), option.values.begin(), option.values.end());
  return values;
}

std::string bash(const std::vector<VerbWords> &verbs) {
  fmt::memory_buffer out;
  auto sink = std::back_inserter(out);
  std::vector<std::string> names;
  for (const auto &verb : verbs) names.push_back(verb.name);
  fmt::format_to(
      sink,
      "# bash completion of rimpact; made by `rimpact completion bash`\n"
      "_rimpact() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} verb=${{COMP_WORDS[1]}} words=\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W '{} --help --version' -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case $verb in\n",
      fmt::join(names, " "));
  for (const auto &verb : verbs) {
    fmt::format_to(sink, "  {})\n    case $before in\n", verb.name);
    for (const auto &option : verb.options)
      if (!option.names.empty() && !option.values.empty())
        fmt::format_to(sink, "    {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n",
                       fmt::join(option.names, "|"), fmt::join(option.values, " "));
    const auto values = place_values(verb);
    fmt::format_to(sink, "    esac\n    words='{}{}{}' ;;\n", fmt::join(option_names(verb), " "),
                   values.empty() ? "" : " ", fmt::join(values, " "));
  }
  fmt::format_to(sink, "  esac\n"
                       "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
                       "}}\n"
                       "complete -o default -F _rimpact rimpact\n");
  return fmt::to_string(out);
}

std::string zsh(const std::vector<VerbWords> &verbs) {
  fmt::memory_buffer out;
  auto sink = std::back_inserter(out);
  fmt::format_to(sink, "#compdef rimpact\n# made by `rimpact completion zsh`\n_rimpact() {{\n  local -a verbs=(\n");
  for (const auto &verb : verbs) fmt::format_to(sink, "    {}\n", quoted(verb.name + ":" + plain(verb.description)));
  fmt::format_to(sink, "  )\n  if (( CURRENT == 2 )); then\n    _describe verb verbs\n    return\n  fi\n  local "
                       "verb=$words[2]\n  shift words\n"
                       "  (( CURRENT-- ))\n  case $verb in\n");
  for (const auto &verb : verbs) {
    fmt::format_to(sink, "  {}) _arguments", verb.name);
    for (const auto &option : verb.options)
      for (const auto &name : option.names) {
        const std::string argument = !option.takes_value ? ""
                                     : option.values.empty()
                                         ? ":value:_files"
                                         : fmt::format(":value:({})", fmt::join(option.values, " "));
        fmt::format_to(sink, " {}", quoted(fmt::format("*{}[{}]{}", name, plain(option.description), argument)));
      }
    const auto values = place_values(verb);
    fmt::format_to(sink, " {} ;;\n",
                   values.empty() ? "'*:file:_files'" : quoted(fmt::format("*:what:({})", fmt::join(values, " "))));
  }
  fmt::format_to(sink, "  esac\n}}\n_rimpact \"$@\"\n");
  return fmt::to_string(out);
}

std::string fish(const std::vector<VerbWords> &verbs) {
  fmt::memory_buffer out;
  auto sink = std::back_inserter(out);
  fmt::format_to(sink, "# fish completion of rimpact; made by `rimpact completion fish`\n");
  for (const auto &verb : verbs) {
    fmt::format_to(sink, "complete -c rimpact -n __fish_use_subcommand -f -a {} -d {}\n", verb.name,
                   quoted(verb.description));
    const std::string when = fmt::format("complete -c rimpact -n '__fish_seen_subcommand_from {}'", verb.name);
    for (const auto &option : verb.options) {
      if (option.names.empty()) {
        if (!option.values.empty())
          fmt::format_to(sink, "{} -f -a {}\n", when, quoted(fmt::format("{}", fmt::join(option.values, " "))));
        continue;
      }
      fmt::format_to(sink, "{}", when);
      for (const auto &name : option.names)
        fmt::format_to(sink, " {} {}", name.starts_with("--") ? "-l" : "-s",
                       name.substr(name.starts_with("--") ? 2 : 1));
      if (option.takes_value) fmt::format_to(sink, " -r");
      if (!option.values.empty())
        fmt::format_to(sink, " -f -a {}", quoted(fmt::format("{}", fmt::join(option.values, " "))));
      fmt::format_to(sink, " -d {}\n", quoted(option.description));
    }
  }
  return fmt::to_string(out);
}

} // namespace

std::string completion_script(Shell shell, const std::vector<VerbWords> &verbs) {
  switch (shell) {
  case Shell::bash:
    return bash(verbs);
  case Shell::zsh:
    return zsh(verbs);
  case Shell::fish:
    return fish(verbs);
  }
  return {};
}

} // namespace rimpact::app
