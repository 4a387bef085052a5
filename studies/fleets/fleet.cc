#include "studies/fleets/fleet.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/folder_lock.h"
#include "io/files/json_text.h"
#include "io/files/table_csv.h"
#include "io/files/table_hdf5.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "responses/limits.h"
#include "scene/toml_writer.h"
#include "studies/fleets/fleet_folder.h"
#include "studies/fleets/fleet_table.h"
#include "studies/fleets/fractiles.h"
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <fmt/format.h>
#include <mutex>
#include <thread>

namespace rimpact::fleets {
namespace {

using Clock = std::chrono::steady_clock;

/// A long table takes seconds to write: the runs get so many times what its last writing took.
constexpr double rests_of_a_flush = 20;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct FleetScene {
  std::string where;
  std::vector<std::string> overrides;
  const Sweep &sweep;
  const FleetModel &model;
  scene::Scene load(std::size_t run) const {
    std::vector<std::string> all = overrides;
    for (auto &assignment : sweep.assignments(run)) all.push_back(std::move(assignment));
    return scene::load_scene(where, all);
  }
};

/// One run, whatever becomes of it.
Row run_one(const FleetScene &fleet, std::size_t run) {
  scene::Scene scene;
  try {
    scene = fleet.load(run);
  } catch (const Error &error) {
    return row_without_result(RowStatus::refused, error.what());
  }
  try {
    Summary summary = fleet.model.run(scene);
    judge(scene, summary);
    return row_of(summary);
  } catch (const InputError &error) {
    return row_without_result(RowStatus::refused, error.what());
  } catch (const SolverStopped &error) {
    return row_without_result(RowStatus::stopped, error.what());
  } catch (const std::exception &error) {
    return row_without_result(RowStatus::failed, error.what());
  }
}

/// The first run that can be read as a scene; the sweep is refused when none can.
scene::Scene first_scene(const FleetScene &fleet) {
  std::exception_ptr first;
  for (std::size_t run = 0; run < fleet.sweep.runs.size(); ++run) {
    try {
      return fleet.load(run);
    } catch (const Error &) {
      if (!first) first = std::current_exception();
    }
  }
  std::rethrow_exception(first);
}

/// Threads that work through a list of runs and hand their rows to the owner.
class Workers {
public:
  Workers(const FleetScene &fleet, const std::vector<std::size_t> &todo, int n_threads) : fleet_(fleet), todo_(todo) {
    for (int i = 0; i < n_threads; ++i) threads_.emplace_back([this] { work(); });
  }
  ~Workers() { stop(); }
  /// Runs begun are finished, no others begin.
  void stop() {
    stopped_ = true;
    threads_.clear(); // joins
  }
  /// Rows finished since the last call; waits up to a tenth of a second for one.
  std::vector<std::pair<std::size_t, Row>> take() {
    std::unique_lock guard(lock_);
    ready_.wait_for(guard, std::chrono::milliseconds(100), [&] { return !rows_.empty(); });
    return std::exchange(rows_, {});
  }

private:
  void work() {
    for (std::size_t i; !stopped_ && (i = next_++) < todo_.size();) {
      Row row = run_one(fleet_, todo_[i]);
      const std::lock_guard guard(lock_);
      rows_.emplace_back(todo_[i], std::move(row));
      ready_.notify_one();
    }
  }
  const FleetScene &fleet_;
  const std::vector<std::size_t> &todo_;
  std::atomic<bool> stopped_{false};
  std::atomic<std::size_t> next_{0};
  std::mutex lock_;
  std::condition_variable ready_;
  std::vector<std::pair<std::size_t, Row>> rows_;
  std::vector<std::jthread> threads_;
};

void count(FleetResult &result, const Row &row) {
  for (const auto &[name, sum] : {std::pair{"beyond_rim", &result.beyond_rim}, {"beyond_fit", &result.beyond_fit}})
    if (const auto flag = number_in(row, name)) *sum = sum->value_or(0) + (*flag != 0);
  const CellReader cells = [&](const char *column) { return number_in(row, column); };
  result.hits.add(cells), result.implausible.add(cells);
  const auto *status = std::get_if<std::string>(&row.at("status"));
  const auto known = status ? parse<RowStatus>(*status) : std::nullopt;
  ++(known == RowStatus::done      ? result.done
     : known == RowStatus::stopped ? result.stopped
     : known == RowStatus::refused ? result.refused
                                   : result.failed);
}

void write_limits(const FleetResult &result, const std::string &folder) {
  auto limits = result.hits.json();
  limits["plausible"] = result.implausible.json();
  limits["doubts"] = result.doubts();
  write_atomically(json_text(limits), folder + "/limits.json");
}

} // namespace

std::vector<std::string> FleetResult::doubts() const {
  auto all = hits.doubts(!implausible.bound_the_frame());
  for (auto &doubt : implausible.doubts()) all.push_back(std::move(doubt));
  return all;
}

FleetModel reduced_models() {
  return {.run = [](const scene::Scene &scene) { return reduced::simulate_summary(scene); }};
}

FleetResult run_fleet(const std::string &where, const std::vector<std::string> &overrides, const Sweep &sweep,
                      const FleetOptions &options, const FleetModel &model) {
  const FleetScene fleet{where, overrides, sweep, model};
  const scene::Scene first = first_scene(fleet);
  if (options.first) options.first(first);
  const std::string part = options.n_shards > 1 ? fmt::format("{}-of-{}", options.shard, options.n_shards) : "";
  const FolderLock lock(options.folder, part);
  const FleetIdentity identity = fleet_identity(where, overrides, sweep, first, model);
  open_folder(identity, sweep, options);
  FleetTable table(sweep, {{"version", RIMPACT_VERSION}, {"scene_of_first_run", scene::to_toml(first)}});
  table.read_folder(options.folder);

  std::vector<std::size_t> mine, todo;
  for (std::size_t run = options.shard - 1; run < sweep.runs.size(); run += options.n_shards) {
    mine.push_back(run);
    if (!table.has(run)) todo.push_back(run);
  }
  FleetResult result;
  result.implausible = ImplausibleRuns(sweep.plausible);
  result.total = mine.size(), result.kept = mine.size() - todo.size();
  result.table = options.folder + "/table";
  if (!part.empty()) result.table += "-" + part;

  const auto start = Clock::now();
  auto last_flush = start;
  double flush_took = 0; // [s]
  std::size_t n_new = 0, n_failed = 0;
  const auto was_interrupted = [&] { return options.interrupted && *options.interrupted; };
  {
    const int machine = std::max(1u, std::thread::hardware_concurrency());
    Workers workers(fleet, todo, options.n_threads > 0 ? options.n_threads : machine);
    const auto take = [&] {
      for (auto &[run, row] : workers.take()) {
        if (row.size() <= 2) ++n_failed; // status and reason only
        table.set(run, std::move(row)), ++n_new;
      }
    };
    while (n_new < todo.size() && !was_interrupted()) {
      take();
      const double spent = seconds_since(start);
      if (options.progress)
        options.progress(
            {result.kept + n_new, result.total, n_failed, spent, n_new ? spent * (todo.size() - n_new) / n_new : 0});
      if (seconds_since(last_flush) > std::max(options.flush_seconds, rests_of_a_flush * flush_took)) {
        const auto begun = Clock::now();
        require_still_ours(identity, options.folder);
        table.keep(result.table, mine);
        last_flush = Clock::now(), flush_took = seconds_since(begun);
      }
    }
    workers.stop();
    take();
  }
  require_still_ours(identity, options.folder);
  table.write(result.table, mine);
  result.seconds = seconds_since(start);
  if (n_new < todo.size())
    throw Error(ExitCode::interrupted,
                fmt::format("interrupted after {} of {} runs; the same command goes on from there", result.kept + n_new,
                            result.total));
  for (const auto run : mine) count(result, table.row(run));
  if (options.n_shards == 1) write_limits(result, options.folder);
  if (options.n_shards == 1 && !sweep.fractiles_along.empty()) {
    const Table curves = fractiles(table.table(mine), sweep.fractiles_along, sweep.fractiles_by);
    write_hdf5(curves, options.folder + "/fractiles.h5");
    write_csv(curves, options.folder + "/fractiles.csv");
  }
  return result;
}

} // namespace rimpact::fleets
