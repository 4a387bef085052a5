/// Fleets of runs: one scene, a sweep over its keys, one table. Runs go on the machine's threads; a run that
/// fails says so in its row. What is finished is kept: the same call goes on where an earlier one stopped.
#pragma once
#include "responses/summary.h"
#include "scene/scene.h"
#include "studies/fleets/hit_shares.h"
#include "studies/fleets/sweep.h"
#include <atomic>
#include <functional>
#include <map>

namespace rimpact::fleets {

struct FleetProgress {
  std::size_t done, total; ///< runs of this shard
  std::size_t failed;      ///< of them, without a result
  double seconds, seconds_left;
};

/// What makes the runs of a fleet.
struct FleetModel {
  std::string name = {}; ///< of what carries on where the scene ends, a building; a folder holds the runs of one
  /// One run's peaks; throws as the models do.
  std::function<Summary(const scene::Scene &)> run;
  /// What the rows depend on besides the scene: contents by name, as an Identity has them.
  std::map<std::string, std::string> inputs = {};
};
FleetModel reduced_models();

struct FleetOptions {
  std::string folder;
  /// Run j (from 0) belongs to shard j mod n_shards + 1; 1 <= shard <= n_shards.
  int shard = 1, n_shards = 1;
  int n_threads = 0;        ///< 0: as many as the machine has
  double flush_seconds = 5; ///< between writings of the table; longer where one takes longer than a twentieth of that
  bool force = false;       ///< replaces what the folder holds
  const std::atomic<bool> *interrupted = nullptr;
  std::function<void(const FleetProgress &)> progress = {}; ///< called by the calling thread only
  std::function<void(const scene::Scene &)> first = {};     ///< is told the scene of the first run, before any
  std::function<void(const std::string &)> remark = {};     ///< told when rows are made again
};

struct FleetResult {
  std::size_t total = 0, kept = 0, done = 0, stopped = 0, refused = 0, failed = 0;
  std::optional<std::size_t> beyond_rim, beyond_fit; ///< runs, whatever their status; none: of no run is it known
  HitShares hits;
  ImplausibleRuns implausible;
  double seconds = 0;
  std::string table; ///< path without .csv or .h5
  /// Sentences about where the models are not known to hold, and about runs beyond [plausible].
  std::vector<std::string> doubts() const;
};

/// Fills FOLDER/table.csv and table.h5, of a shard table-I-of-N.*; rows that any table of the folder already
/// has are not run again (so a call without a shard gathers the shards' tables). Without shards and with
/// [fractiles] in the sweep also FOLDER/fractiles.csv and .h5. FOLDER/limits.json, without shards: which share of the
/// hits lies where the models are not known to hold, how many runs are beyond [plausible], and the doubts about that.
/// FOLDER/fleet.json says what the fleet is; InputError when the folder holds another one, or when no run of the sweep
/// can be read as a scene. Rows of other inputs (a file edited since) or of another version are not kept: every run is
/// made again. IoError where another process works on the same shard. Throws Error{ExitCode::interrupted} after the
/// table is written.
FleetResult run_fleet(const std::string &scene, const std::vector<std::string> &overrides, const Sweep &sweep,
                      const FleetOptions &options, const FleetModel &model = reduced_models());

} // namespace rimpact::fleets
