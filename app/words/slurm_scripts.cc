#include "app/words/slurm_scripts.h"
#include "io/files/file.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::app {
namespace {

/// A word as a shell reads it.
std::string shell_quoted(const std::string &word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// The command without --slurm and with its folder.
std::string slurm_words(const SlurmCommand &what, const Console &console) {
  std::vector<std::string> words;
  bool has_folder = false;
  for (int i = 1; i < console.argc; ++i) {
    const std::string word = console.argv[i];
    if (word == "--slurm" || word == "--shard") {
      ++i; // and its value
      continue;
    }
    if (word.starts_with("--slurm=") || word.starts_with("--shard=")) continue;
    has_folder |= word == "-o" || word == "--output" || word.starts_with("--output=") ||
                  (word.starts_with("-o") && !word.starts_with("--"));
    words.push_back(shell_quoted(word));
  }
  if (!has_folder) words.push_back("-o " + shell_quoted(what.folder));
  return fmt::format("{}", fmt::join(words, " "));
}

bool is_given(const Console &console, const std::string &option) {
  return std::any_of(console.argv, console.argv + console.argc, [&](const char *word) {
    const std::string text = word;
    return text == option || text.starts_with(option + "=");
  });
}

std::string slurm_head(const std::string &name, const std::string &more) {
  return fmt::format("#!/usr/bin/env bash\n# Made by rimpact --slurm; cores, memory and time are yours to set.\n"
                     "#SBATCH --job-name={}\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=2\n#SBATCH --mem=4G\n"
                     "#SBATCH --time=04:00:00\n{}set -eu\ncd {}\n",
                     name, more, shell_quoted(std::filesystem::current_path().string()));
}

} // namespace

CLI::Option *add_slurm(CLI::App &verb, int &shards) {
  return verb
      .add_option("--slurm", shards, "runs nothing: writes scripts for an array of N shards and what gathers them")
      ->check(CLI::Range(2, 10'000));
}

void write_slurm(const SlurmCommand &what, Console &console) {
  const std::string folder = what.folder + "/slurm", words = slurm_words(what, console);
  const bool threads = what.has_threads && !is_given(console, "--threads") && !is_given(console, "--jobs");
  const std::string command =
      fmt::format("\"${{RIMPACT:-rimpact}}\" {}{}", words, threads ? " --threads \"${SLURM_CPUS_PER_TASK:-1}\"" : "");
  make_folder(folder);
  write_atomically(
      slurm_head("rimpact-shard", fmt::format("#SBATCH --array=1-{}\n#SBATCH --signal=B:TERM@60\n", what.shards)) +
          fmt::format(
              "# In the background, so that bash hands on the signal before the time is up; rimpact then writes "
              "its rows and ends.\n{} --shard \"${{SLURM_ARRAY_TASK_ID:?submit it by sbatch}}/{}\" --quiet &\n"
              "trap 'kill -TERM $!; wait $!' TERM\nwait $!\n",
              command, what.shards),
      folder + "/array.sbatch");
  write_atomically(slurm_head("rimpact-gather", "") + command + " --quiet\n", folder + "/gather.sbatch");
  write_atomically("#!/usr/bin/env bash\nset -eu\nhere=$(cd \"$(dirname \"$0\")\" && pwd)\n"
                   "job=$(sbatch --parsable \"$here/array.sbatch\")\n"
                   "sbatch --dependency=afterany:\"$job\" \"$here/gather.sbatch\"\n",
                   folder + "/submit.sh");
  console.data(fmt::format("{0}/submit.sh: `bash {0}/submit.sh` submits {1} shards and what gathers them; a shard "
                           "again: sbatch --array=I {0}/array.sbatch; gathering by hand: bash {0}/gather.sbatch\n",
                           folder, what.shards));
}

} // namespace rimpact::app
