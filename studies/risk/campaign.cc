#include "studies/risk/campaign.h"
#include <chrono>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

void Pace::add(const fleets::FleetResult &system) {
  if (system.kept == system.total) return;
  seconds_ += system.seconds, made_ += system.total - system.kept;
}

double Pace::seconds_a_run(const fleets::FleetProgress &at_hand) const {
  if (made_ > 0) return seconds_ / static_cast<double>(made_);
  const std::size_t left = at_hand.total - at_hand.done;
  return left > 0 ? at_hand.seconds_left / static_cast<double>(left) : 0;
}

std::string folder_of_system(const std::string &folder, std::size_t system) {
  return fmt::format("{}/systems/{:04}", folder, system + 1);
}

std::vector<Part> parts_of_shard(std::size_t n_systems, int shard, int n_shards) {
  const auto n = static_cast<std::size_t>(n_shards);
  const std::size_t n_parts = (n + n_systems - 1) / n_systems; // of each system
  std::vector<Part> parts;
  for (std::size_t unit = 0; unit < n_systems * n_parts; ++unit)
    if (unit % n == static_cast<std::size_t>(shard - 1))
      parts.push_back({unit / n_parts, static_cast<int>(unit % n_parts) + 1, static_cast<int>(n_parts)});
  return parts;
}

CampaignResult run_campaign(const Study &study, const Systems &systems, const Motions &motions,
                            const CampaignOptions &options) {
  const auto parts = parts_of_shard(systems.size(), options.shard, options.n_shards);
  CampaignResult result;
  const double start = now();
  Pace pace;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part &part = parts[i];
    const fleets::Sweep sweep = runs_of(study, systems, part.system, motions);
    fleets::FleetOptions fleet{.folder = folder_of_system(options.folder, part.system),
                               .shard = part.part,
                               .n_shards = part.n_parts,
                               .n_threads = options.n_threads,
                               .force = options.force,
                               .interrupted = options.interrupted};
    if (i == 0) fleet.first = options.first;
    fleet.remark = options.remark;
    if (options.progress)
      fleet.progress = [&](const fleets::FleetProgress &runs) {
        const double others = pace.seconds_a_run(runs) * static_cast<double>(runs.total * (parts.size() - i - 1));
        options.progress({i + 1, parts.size(), runs, now() - start, runs.seconds_left + others});
      };
    std::filesystem::create_directories(fleet.folder);
    const auto done = fleets::run_fleet(study.scene, systems.all[part.system].overrides, sweep, fleet);
    pace.add(done);
    ++result.systems, result.runs += done.total, result.kept += done.kept;
    result.without_result += done.refused + done.failed;
  }
  result.seconds = now() - start;
  return result;
}

} // namespace rimpact::risk
