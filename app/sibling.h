/// The programs beside this one, and Python for the report.
#pragma once
#include <string>
#include <sys/types.h>
#include <vector>

namespace rimpact::app {

/// Path of a program in this executable's folder. RIMPACT_FE_PROGRAM replaces rimpact-fe (the tests'
/// stand-in).
std::string sibling(const std::string &name);
/// Replaces this process by the sibling with the same arguments. Throws InputError when it was not built.
[[noreturn]] void become_fe(int argc, char **argv);
/// Starts a program; its output goes to `log` ("": inherited). `environment`: NAME=VALUE to add.
pid_t start(const std::vector<std::string> &command, const std::string &log,
            const std::vector<std::string> &environment);
/// Exit code of a finished process, -1 while it runs (when not waiting). Death by a signal counts as 1.
int poll(pid_t process, bool wait);
/// Runs `python3 -m MODULE ARGS` of the report package; returns its exit code.
int python(const std::vector<std::string> &arguments);

} // namespace rimpact::app
