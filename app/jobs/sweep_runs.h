/// SCENE --sweep FILE of `reduced` and `building`: a fleet of runs.
#pragma once
#include "app/console/console.h"
#include "app/words/set_keys.h"
#include "studies/fleets/fleet.h"
#include <CLI/CLI.hpp>
#include <string>

namespace rimpact::app {

struct SweepOptions {
  std::vector<std::string> sweep; ///< one file, or KEY=a:b:n each; empty: none
  std::string shard;              ///< "i/n", empty: all
  int n_threads = 0;
  int slurm = 0;        ///< shards of the scripts to write; 0: runs
  bool dry_run = false; ///< tells what would run
};
/// --sweep, --shard, --threads, --slurm and --dry-run of a verb; the first of them.
CLI::Option *add_sweep_options(CLI::App &verb, SweepOptions &options);

struct SweepPlace {
  std::string scene, folder; ///< folder empty: default_folder(name) with what the sweep is called
  std::string name;
  bool picture = false;
  WhyUnread why_unread = {}; ///< of the sweep's keys; empty: what runs them reads all
};
void sweep_runs(const SweepOptions &options, const SweepPlace &place, const fleets::FleetModel &model,
                Console &console);

} // namespace rimpact::app
