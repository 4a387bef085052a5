#include "app/sibling.h"

#include "scene/error.h"
#include <climits>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

namespace rimpact::app {
namespace {

std::vector<char *> pointers(std::vector<std::string> &words) {
  std::vector<char *> result;
  for (auto &word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

} // namespace

std::string sibling(const std::string &name) {
  if (const char *other = std::getenv("RIMPACT_FE_PROGRAM"); other && name == "rimpact-fe") return other;
  char path[PATH_MAX] = {};
  if (readlink("/proc/self/exe", path, sizeof path - 1) < 0)
    throw IoError("cannot find this program's folder (is /proc mounted?)");
  return (std::filesystem::path(path).parent_path() / name).string();
}

void become_fe(int argc, char **argv) {
  std::string program = sibling("rimpact-fe");
  std::vector<std::string> words{program};
  words.insert(words.end(), argv + 1, argv + argc);
  execv(program.c_str(), pointers(words).data());
  throw InputError("this build has no finite-element side (" + program +
                   " is missing); build with RIMPACT_FE=ON");
}

pid_t start(const std::vector<std::string> &command, const std::string &log,
            const std::vector<std::string> &environment) {
  std::vector<std::string> words = command, added = environment;
  const auto arguments = pointers(words);
  const pid_t process = fork();
  if (process < 0) throw IoError("cannot start " + command.front());
  if (process > 0) return process;
  for (auto &entry : added) putenv(entry.data());
  if (!log.empty()) {
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file >= 0) {
      dup2(file, STDOUT_FILENO);
      dup2(file, STDERR_FILENO);
    }
  }
  execv(arguments[0], arguments.data());
  _exit(127);
}

int poll(pid_t process, bool wait) {
  int status = 0;
  const pid_t done = waitpid(process, &status, wait ? 0 : WNOHANG);
  if (done == 0) return -1;
  if (done < 0) return 1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

int python(const std::vector<std::string> &arguments) {
  std::vector<std::string> command{"/usr/bin/python3", "-m"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const char *path = std::getenv("PYTHONPATH");
  return poll(start(command, "",
                    {std::string("PYTHONPATH=" RIMPACT_SOURCE_DIR) + (path ? std::string(":") + path : "")}),
              true);
}

} // namespace rimpact::app
