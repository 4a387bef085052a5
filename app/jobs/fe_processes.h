/// Finite-element programs that run beside one another, each with a log of its own.
#pragma once
#include <string>
#include <sys/types.h>
#include <vector>

namespace rimpact::app {

/// Starts rimpact-fe with these words; `log` takes all that it says. `alone`: no other runs beside it, and it may take
/// more threads than one.
pid_t start_fe(const std::vector<std::string> &words, const std::string &log, bool alone);

/// Why a program ended with this code (128 + the signal that ended it), a sentence: its log's last one.
std::string failure_in_words(int code, const std::string &log);
/// The last line of a file that holds something; empty: there is none.
std::string last_line(const std::string &path);

/// Tells them to stop and waits until they have; throws an Error of exit code 130.
[[noreturn]] void stop_fe(const std::vector<pid_t> &processes);

} // namespace rimpact::app
