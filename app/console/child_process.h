/// The programs beside this one, and Python for the report.
#pragma once
#include <csignal>
#include <initializer_list>
#include <string>
#include <sys/types.h>
#include <vector>

namespace rimpact::app {

/// Path of a program in this executable's folder. RIMPACT_FE_PROGRAM replaces rimpact-fe (the tests'
/// stand-in).
std::string program_beside(const std::string &name);
bool has_fe_program();
/// The finite-element program. Throws InputError when it was not built.
std::string fe_program();
/// Replaces this process by the finite-element program with these words. Throws as fe_program().
[[noreturn]] void exec_fe(const std::vector<std::string> &words);
/// Processors that this process may use, at most eight.
std::size_t cores_to_use();

/// A program to start.
struct Launch {
  std::vector<std::string> command;
  std::string output = {}, errors = {};      ///< files (may be the same one); "": inherited
  std::vector<std::string> environment = {}; ///< NAME=VALUE to add
  /// In a process group of its own, so that a Ctrl-C on the terminal reaches this program only, which then
  /// tells the other once (SIGTERM).
  bool apart = false;
  int when_killed = SIGTERM; ///< what one apart is sent when this program is killed
};
pid_t start(const Launch &launch);
/// Exit code of a process, -1 while it runs (when not waiting), 128 + the signal that ended it.
int poll(pid_t process, bool wait);
/// Waits for a process. A signal of `heard` that comes meanwhile is its own: it gets `as` for each.
struct Ended {
  int code;      ///< as poll() has it
  bool was_told; ///< whether a signal was heard
};
Ended wait_passing_on(pid_t process, std::initializer_list<int> heard, int as);
/// Runs MODULE ARGS of the report package by an isolated Python (RIMPACT_PYTHON, which pip's command sets, else the
/// system's), its errors shown, and its output where that is asked for; returns its exit code. An interrupt is passed
/// on to it. Throws Interrupted where it ended by one.
int python(const std::vector<std::string> &arguments, bool show_output = false);

} // namespace rimpact::app
