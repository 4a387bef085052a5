#include "app/console/child_process.h"

#include "io/files/address_space.h"
#include "io/files/data_folder.h"
#include "io/files/error.h"
#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rimpact::app {
namespace {

std::vector<char *> pointers(std::vector<std::string> &words) {
  std::vector<char *> result;
  result.reserve(words.size() + 1);
  for (auto &word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

/// In the child: `descriptor` goes to a file. A child that cannot write its log would fail without a word.
void redirect(const std::string &path, int descriptor) {
  if (path.empty()) return;
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(static_cast<int>(ExitCode::io));
}

/// [MB]; below it MPI, OpenBLAS and HDF5 stop without a sentence, or wait for threads they could not start.
constexpr double least_address_space = 900;

void need_address_space() {
  constexpr double MB = 1 << 20;
  const auto limit = address_space_limit();
  if (!limit || *limit >= least_address_space * MB) return;
  throw SolverStopped(
      fmt::format("the limit of this process's address space (ulimit -v) is {:.0f} MB; finite elements need {:.0f} MB",
                  *limit / MB, least_address_space));
}

} // namespace

std::string program_beside(const std::string &name) {
  if (const char *other = std::getenv("RIMPACT_FE_PROGRAM"); other && name == "rimpact-fe") return other;
  return (std::filesystem::path(program_folder()) / name).string();
}

bool has_fe_program() {
  return access(program_beside("rimpact-fe").c_str(), X_OK) == 0;
}

std::string fe_program() {
  std::string program = program_beside("rimpact-fe");
  if (!has_fe_program())
    throw InputError("this rimpact has no finite-element side (" + program +
                     " is missing), as none has from pip; ./run in the source tree builds one with it, and the Debian "
                     "package brings it");
  return program;
}

void exec_fe(const std::vector<std::string> &given) {
  need_address_space();
  std::vector<std::string> words{fe_program()};
  words.insert(words.end(), given.begin(), given.end());
  execv(words[0].c_str(), pointers(words).data());
  throw IoError("cannot start " + words[0]);
}

std::size_t cores_to_use() {
  cpu_set_t set;
  CPU_ZERO(&set);
  const int count = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
  return std::clamp(count, 1, 8);
}

pid_t start(const Launch &launch) {
  std::vector<std::string> words = launch.command, added = launch.environment;
  const auto arguments = pointers(words);
  const pid_t parent = getpid(), process = fork();
  if (process < 0) throw IoError("cannot start " + words[0]);
  if (process > 0) return process;
  if (launch.apart) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, launch.when_killed);
    if (getppid() != parent) _exit(static_cast<int>(ExitCode::interrupted)); // it died before the line above
  }
  for (auto &entry : added) putenv(entry.data());
  redirect(launch.output, STDOUT_FILENO);
  if (launch.errors.empty() || launch.errors != launch.output)
    redirect(launch.errors, STDERR_FILENO);
  else
    dup2(STDOUT_FILENO, STDERR_FILENO);
  execv(arguments[0], arguments.data());
  _exit(127);
}

int poll(pid_t process, bool wait) {
  int status = 0;
  pid_t done = 0;
  do done = waitpid(process, &status, wait ? 0 : WNOHANG);
  while (done < 0 && errno == EINTR);
  if (done == 0) return -1;
  if (done < 0) return static_cast<int>(ExitCode::bug);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

namespace {

volatile std::sig_atomic_t told = 0; ///< signals that were heard

constexpr const char *run_module = R"(import sys
try:
    import runpy
    sys.path.insert(0, sys.argv[1])
    del sys.argv[1]
    runpy.run_module(sys.argv.pop(1), run_name="__main__", alter_sys=True)
except KeyboardInterrupt:
    sys.exit(130)
)";

} // namespace

Ended wait_passing_on(pid_t process, std::initializer_list<int> heard, int as) {
  struct sigaction hear {};
  hear.sa_handler = [](int) { told = told + 1; };
  hear.sa_flags = SA_RESTART;
  sigemptyset(&hear.sa_mask);
  told = 0;
  std::vector<struct sigaction> before(heard.size());
  for (std::size_t i = 0; i < heard.size(); ++i) sigaction(heard.begin()[i], &hear, &before[i]);
  constexpr unsigned pause = 10000; // [us]
  int code = -1;
  for (int passed_on = 0; (code = poll(process, false)) < 0; usleep(pause))
    for (; passed_on < told; ++passed_on) kill(process, as);
  for (std::size_t i = 0; i < heard.size(); ++i) sigaction(heard.begin()[i], &before[i], nullptr);
  return {code, told > 0};
}

int python(const std::vector<std::string> &arguments, bool show_output) {
  const std::string data = data_folder();
  if (!std::filesystem::is_directory(std::filesystem::path(data) / "report"))
    throw IoError(data + ": the report's Python is not there; install the programs with their data (cmake --install)");
  // Isolated (-I): neither the working folder nor the environment brings modules of its own. With pip's Python the
  // user's own folder of packages counts (-EP), for pip may have put rimpact there.
  const char *pip = std::getenv("RIMPACT_PYTHON");
  Launch launch{.command = {pip ? pip : "/usr/bin/python3", pip ? "-EP" : "-I", "-c", run_module, data},
                .output = show_output ? "" : "/dev/null",
                .apart = true};
  launch.command.insert(launch.command.end(), arguments.begin(), arguments.end());
  const int code = wait_passing_on(start(launch), {SIGINT}, SIGINT).code;
  if (code == static_cast<int>(ExitCode::interrupted)) throw Interrupted();
  return code;
}

} // namespace rimpact::app
