#include "app/jobs/fe_processes.h"

#include "app/console/child_process.h"
#include "io/files/error.h"
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace rimpact::app {

pid_t start_fe(const std::vector<std::string> &words, const std::string &log, bool alone) {
  Launch launch{.command = {fe_program()}, .output = log, .errors = log, .apart = true};
  launch.command.insert(launch.command.end(), words.begin(), words.end());
  if (!alone) launch.environment = {"RIMPACT_THREADS=1"};
  return start(launch);
}

std::string failure_in_words(int code, const std::string &log) {
  if (code == 128 + SIGKILL) return "killed, perhaps for want of memory";
  if (code > 128 && code != static_cast<int>(ExitCode::interrupted))
    return fmt::format("ended by signal {} ({})", code - 128, strsignal(code - 128));
  const std::string last = last_line(log);
  if (last.empty()) return fmt::format("ended with exit code {}; its log is empty", code);
  return last.rfind("error: ", 0) == 0 ? last.substr(7) : last;
}

std::string last_line(const std::string &path) {
  std::string line, last;
  for (std::ifstream file(path); std::getline(file, line);)
    if (!line.empty()) last = line;
  return last;
}

void stop_fe(const std::vector<pid_t> &processes) {
  for (const pid_t process : processes) kill(process, SIGTERM);
  for (const pid_t process : processes) poll(process, true);
  throw Error(ExitCode::interrupted, "interrupted; the same command goes on where it stopped");
}

} // namespace rimpact::app
