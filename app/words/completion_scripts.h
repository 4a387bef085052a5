/// Completion of the shells, from the command's own tree.
#pragma once
#include "app/words/command_tree.h"
#include "io/files/choice.h"

namespace rimpact::app {

enum class Shell { bash, zsh, fish };
constexpr auto choices(Shell) {
  return choices_of<Shell>({{Shell::bash, "bash"}, {Shell::zsh, "zsh"}, {Shell::fish, "fish"}});
}
/// The script a shell reads.
std::string completion_script(Shell shell, const std::vector<VerbWords> &verbs);

} // namespace rimpact::app
