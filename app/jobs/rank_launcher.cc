#include "app/jobs/rank_launcher.h"

#include "app/console/child_process.h"
#include "app/words/run_words.h"
#include "io/files/address_space.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <thread>
#include <unistd.h>

namespace rimpact::app {
namespace {

bool is_program(const std::string &name) {
  const char *path = std::getenv("PATH");
  for (const auto folder : split(path ? path : "", ':'))
    if (access((std::string(folder) + "/" + name).c_str(), X_OK) == 0) return true;
  return false;
}

int number_of_ranks(const std::string &text) {
  const int most = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  int n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size() || n < 1 || n > most)
    throw InputError(fmt::format("--ranks {} must be a whole number from 1 to {}, the processors here", text, most));
  return n;
}

/// Where mpirun keeps what its ranks share. Left to itself, Open MPI 4 takes one folder for all runs of a user, and
/// removes it under the feet of a run that begins.
class SessionFolder {
public:
  SessionFolder() {
    if (!mkdtemp(path_.data()))
      throw IoError("no folder can be made in " + temporary() + " (TMPDIR), which several ranks need: give --ranks 1");
  }
  ~SessionFolder() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }
  SessionFolder(const SessionFolder &) = delete;
  std::string variable() const { return "TMPDIR=" + path_; }

private:
  static std::string temporary() {
    std::error_code none;
    const auto path = std::filesystem::temp_directory_path(none);
    return none ? "/tmp" : path.string();
  }
  std::string path_ = temporary() + "/rimpact-XXXXXX";
};

} // namespace

std::optional<int> take_ranks(std::vector<std::string> &words) {
  const auto at = std::find_if(words.begin(), words.end(), [](const std::string &word) {
    return word == "--ranks" || word.starts_with("--ranks=");
  });
  if (at == words.end()) return {};
  if (std::getenv("OMPI_COMM_WORLD_SIZE")) throw InputError("--ranks starts mpirun itself; leave one of the two out");
  const bool apart = *at == "--ranks";
  if (apart && at + 1 == words.end()) throw InputError("--ranks needs a number");
  const int n = number_of_ranks(apart ? *(at + 1) : at->substr(8));
  words.erase(at, at + (apart ? 2 : 1));
  return n;
}

int usual_ranks(const std::vector<std::string> &words) {
  constexpr int usual = 2; // what more gain is not measured
  if (std::getenv("RIMPACT_THREADS") || std::getenv("OMPI_COMM_WORLD_SIZE") || cores_to_use() < usual ||
      address_space_limit() || !is_program("mpirun")) // a limit is for one process to keep, and to speak of
    return 1;
  try {
    CLI::App app;
    auto *verb = app.add_subcommand("run");
    RunWords run;
    Console console;
    add_run_words(*verb, run, console);
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    const scene::Scene scene = scene::load_scene(run.scene, console.settings());
    return scene.model.mesh > 0 && !run.dry_run ? usual : 1;
  } catch (const std::exception &) { // help is asked for, or something is wrong: rimpact-fe tells
    return 1;
  }
}

int run_on_ranks(int n_ranks, const std::string &program, const std::vector<std::string> &words) {
  const SessionFolder folder;
  Launch launch{.command = {"/usr/bin/env", "mpirun", "--use-hwthread-cpus", "-np", std::to_string(n_ranks), program},
                .apart = true,
                .when_killed = SIGKILL};
  launch.command.insert(launch.command.end(), words.begin(), words.end());
  launch.environment = {folder.variable(),
                        "OMPI_MCA_orte_execute_quiet=1"}; // Open MPI 4's own words on a rank that ends; 5 has none
  if (geteuid() == 0)
    launch.environment.insert(launch.environment.end(),
                              {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"});
  // A group in the background that reads from the terminal would be halted.
  if (const int nothing = open("/dev/null", O_RDONLY); nothing >= 0) dup2(nothing, STDIN_FILENO), close(nothing);
  const auto [code, was_told] = wait_passing_on(start(launch), {SIGINT, SIGTERM, SIGHUP, SIGUSR1}, SIGUSR1);
  if (code == 127) throw IoError("mpirun is not here (package openmpi-bin): leave --ranks out");
  return was_told && code == 128 + SIGUSR1 ? static_cast<int>(ExitCode::interrupted)
                                           : code; // before it was listened for
}

} // namespace rimpact::app
