/// Runs the fleets of a study, one folder of results a system.
#pragma once
#include "studies/fleets/fleet.h"
#include "studies/risk/systems.h"

namespace rimpact::risk {

struct CampaignProgress {
  std::size_t system = 0, n_systems = 0; ///< at hand (from 1), of this call
  fleets::FleetProgress runs;            ///< of the system at hand
  double seconds = 0, seconds_left = 0;  ///< of all systems of this call
};

/// How long a run takes, by those made in this call: rows that are kept are read in no time.
class Pace {
public:
  /// A system that is done.
  void add(const fleets::FleetResult &system);
  /// Seconds a run; before one is made, by the system at hand.
  double seconds_a_run(const fleets::FleetProgress &at_hand) const;

private:
  double seconds_ = 0;
  std::size_t made_ = 0;
};

struct CampaignOptions {
  std::string folder;
  int shard = 1, n_shards = 1; ///< see part_of_shard
  int n_threads = 0;
  bool force = false;
  const std::atomic<bool> *interrupted = nullptr;
  std::function<void(const CampaignProgress &)> progress = {};
  std::function<void(const scene::Scene &)> first = {};
  std::function<void(const std::string &)> remark = {};
};

/// A part of the work: one system, or the shard `part` of `n_parts` of its runs where there are more shards than
/// systems.
struct Part {
  std::size_t system;
  int part, n_parts;
};
/// Parts are dealt to the shards in turn; every part belongs to one shard.
std::vector<Part> parts_of_shard(std::size_t n_systems, int shard, int n_shards);

struct CampaignResult {
  std::size_t systems = 0, runs = 0, kept = 0, without_result = 0;
  double seconds = 0;
};

/// FOLDER/systems/0001/table.csv and so on, each a fleet's folder (studies/fleets/fleet.h): rows that are there are
/// kept. Throws as run_fleet: a system that another process works on is refused by its lock.
CampaignResult run_campaign(const Study &study, const Systems &systems, const Motions &motions,
                            const CampaignOptions &options);

/// Folder of a system's fleet.
std::string folder_of_system(const std::string &folder, std::size_t system);

} // namespace rimpact::risk
