#include "app/jobs/sweep_runs.h"

#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/console/progress.h"
#include "app/jobs/shard.h"
#include "app/words/slurm_scripts.h"
#include "io/files/json_text.h"
#include "io/files/text.h"
#include "studies/fleets/grid_arguments.h"
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <set>

namespace rimpact::app {
namespace {

bool is_grid_argument(const std::string &text) {
  return text.find('=') != std::string::npos && !std::filesystem::exists(text);
}

fleets::Sweep sweep_of(const std::vector<std::string> &arguments) {
  if (std::all_of(arguments.begin(), arguments.end(), is_grid_argument)) return fleets::grid_of_arguments(arguments);
  if (arguments.size() == 1) return fleets::read_sweep(arguments.front());
  throw InputError("--sweep is given more than once; then each must be KEY=a:b:n (a file holds them all)");
}

std::string default_fleet_folder(const std::string &name, const std::string &sweep) {
  return default_folder(name) +
         (is_grid_argument(sweep) ? "-sweep" : "-" + std::filesystem::path(sweep).stem().string());
}

void warn_of_limits(const fleets::FleetResult &result, Console &console) {
  for (const auto &doubt : result.doubts()) console.warn(doubt);
  if (result.beyond_rim.value_or(0) > 0)
    console.warn(fmt::format(
        "{} of {} runs went deeper into the rim than it is thick: such a rim has failed (column beyond_rim)",
        *result.beyond_rim, result.total));
  const bool is_doubt = result.hits.fit().is_above(fleets::HitShares::bound);
  if (result.beyond_fit.value_or(0) > 0 && !is_doubt)
    console.warn(fmt::format("{} of {} runs met the rim at speeds its element was not fitted to (column beyond_fit)",
                             *result.beyond_fit, result.total));
}

/// What a sweep would do: the first, the middle and the last run are made and timed, and kept nowhere.
void tell_sweep(const fleets::Sweep &sweep, const SweepPlace &place, const fleets::FleetModel &model, int n_threads,
                const std::string &folder, Console &console) {
  const std::size_t n = sweep.runs.size();
  double seconds = 0;
  std::string trouble;
  const std::set<std::size_t> tried{0, n / 2, n - 1};
  for (const std::size_t i : tried) {
    auto settings = console.settings();
    for (const auto &assignment : sweep.assignments(i)) settings.push_back(assignment);
    const auto begin = std::chrono::steady_clock::now();
    try {
      model.run(scene::load_scene(place.scene, settings));
    } catch (const Error &error) {
      trouble = fmt::format("run {}: {}", i + 1, error.what());
    }
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  const double one = seconds / static_cast<double>(tried.size());
  const auto at_once = static_cast<double>(n_threads > 0 ? static_cast<std::size_t>(n_threads) : cores_to_use());
  constexpr double own_bytes = 230, key_bytes = 10; // of a row of table.csv, as 100,000 runs were written
  const double bytes = (own_bytes + key_bytes * static_cast<double>(sweep.keys.size())) * static_cast<double>(n);
  if (!trouble.empty()) console.warn(trouble);
  if (console.json)
    return console.data(json_text(nlohmann::ordered_json{{"n_runs", n},
                                                         {"keys", sweep.keys},
                                                         {"seconds_a_run", one},
                                                         {"at_once", at_once},
                                                         {"expected_seconds", one * static_cast<double>(n) / at_once},
                                                         {"table_bytes", bytes},
                                                         {"folder", folder}}));
  console.data(fmt::format("{} runs over {}: {:.3g} s each, {:g} at a time, {} in all; table.csv about {:.3g} MB; {}\n",
                           n, fmt::join(sweep.keys, ", "), one, at_once,
                           duration(one * static_cast<double>(n) / at_once), bytes / 1e6, folder));
}

} // namespace

CLI::Option *add_sweep_options(CLI::App &verb, SweepOptions &options) {
  auto *sweep = verb.add_option("--sweep", options.sweep,
                                "many runs, one table: a sweep file, or KEY=a:b:n (repeatable; n values from a to b)")
                    ->allow_extra_args(false);
  verb.add_option("--shard", options.shard, "I/N: every N-th run of the sweep from the I-th on")->needs(sweep);
  verb.add_option("--threads,--jobs", options.n_threads, "of the sweep (default: as many as the machine has)")
      ->needs(sweep)
      ->check(CLI::Range(1, 1024));
  add_slurm(verb, options.slurm)->needs(sweep);
  verb.add_flag("--dry-run", options.dry_run, "of the sweep: runs, keys, time and size, after three runs")
      ->needs(sweep);
  return sweep;
}

void sweep_runs(const SweepOptions &options, const SweepPlace &place, const fleets::FleetModel &model,
                Console &console) {
  const auto [shard, n_shards] = parse_shard(options.shard);
  const fleets::Sweep sweep = sweep_of(options.sweep);
  for (const auto &key : sweep.keys)
    if (const std::string why = place.why_unread ? place.why_unread(key) : ""; !why.empty())
      throw InputError(fmt::format("--sweep {}: {} is not read: {}", options.sweep.front(), key, why));
  for (const auto &sentence : sweep.left_out) console.message(sentence);
  ProgressLine line(console.quiet);
  const std::string folder =
      place.folder.empty() ? default_fleet_folder(place.name, options.sweep.front()) : place.folder;
  if (options.slurm > 0) return write_slurm({.shards = options.slurm, .folder = folder}, console);
  if (options.dry_run) return tell_sweep(sweep, place, model, options.n_threads, folder, console);
  fleets::FleetOptions fleet{.folder = folder,
                             .shard = shard,
                             .n_shards = n_shards,
                             .n_threads = options.n_threads,
                             .force = console.force,
                             .interrupted = &interrupted()};
  fleet.remark = [&](const std::string &sentence) { console.message(sentence); };
  fleet.progress = [&](const fleets::FleetProgress &p) {
    line.show(fmt::format("{} of {} runs, {} without a result, {}, about {} to go", p.done, p.total, p.failed,
                          duration(p.seconds), duration(p.seconds_left)));
  };
  fleet.first = [&](const scene::Scene &scene) { console.report_first_run(scene); };
  watch_interrupts();
  const auto result = fleets::run_fleet(place.scene, console.settings(), sweep, fleet, model);
  line.finish();
  warn_of_limits(result, console);
  if (result.done < result.total)
    console.warn(fmt::format("{} of {} runs did not end well: {} stopped, {} refused, {} failed; the columns status "
                             "and reason say why",
                             result.total - result.done, result.total, result.stopped, result.refused, result.failed));
  if (place.picture && n_shards == 1 && python({"report.quick", "fleet", fleet.folder}) != 0)
    throw IoError("the picture in " + fleet.folder + " was not made");
  if (console.json) {
    const nlohmann::ordered_json json = {{"table", result.table + ".csv"},
                                         {"n_runs", result.total},
                                         {"kept", result.kept},
                                         {"done", result.done},
                                         {"stopped", result.stopped},
                                         {"refused", result.refused},
                                         {"failed", result.failed},
                                         {"beyond_rim", or_null<nlohmann::ordered_json>(result.beyond_rim)},
                                         {"beyond_fit", or_null<nlohmann::ordered_json>(result.beyond_fit)},
                                         {"hits", result.hits.json()},
                                         {"doubts", result.hits.doubts()},
                                         {"wall_time_s", result.seconds}};
    return console.data(json_text(json));
  }
  console.data(fmt::format("{} runs ({} of them kept from before) in {}: {} done, {} stopped, {} refused, {} failed; "
                           "{}.csv and .h5\n",
                           result.total, result.kept, duration(result.seconds), result.done, result.stopped,
                           result.refused, result.failed, result.table));
}

} // namespace rimpact::app
