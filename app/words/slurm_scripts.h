/// SLURM scripts of a command whose work is divided by --shard: an array, what gathers it, what submits both.
#pragma once
#include "app/console/console.h"
#include <CLI/CLI.hpp>
#include <string>

namespace rimpact::app {

/// --slurm N of a verb that has --shard and -o.
CLI::Option *add_slurm(CLI::App &verb, int &shards);

struct SlurmCommand {
  int shards = 0;
  std::string folder;      ///< of the results; the scripts go to its folder slurm
  bool has_threads = true; ///< the verb takes --threads: one a core of the task
};

/// Writes FOLDER/slurm/array.sbatch, gather.sbatch and submit.sh from the command as it was given, and says how they
/// are used. A shard that was killed goes on where it stopped when it is submitted again. Throws IoError.
void write_slurm(const SlurmCommand &what, Console &console);

} // namespace rimpact::app
