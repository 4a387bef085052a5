#include "studies/risk/plan.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "scene/scene.h"
#include "studies/fleets/fleet_table.h"
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <sys/resource.h>

namespace rimpact::risk {
namespace {

/// Bytes of a cell as write_csv writes it and as write_hdf5 does, which packs texts to next to nothing and numbers to
/// what they vary.
double bytes_of(const Cell &cell) {
  constexpr double digits = 19, packed_number = 6, quotes_and_comma = 3;
  const auto *text = std::get_if<std::string>(&cell);
  return text ? static_cast<double>(text->size()) + quotes_and_comma : digits + packed_number;
}

double bytes_of(const fleets::Row &row, const std::vector<fleets::Value> &parameters) {
  double bytes = 0;
  for (const auto &[name, cell] : row) bytes += bytes_of(cell);
  for (const auto &value : parameters) bytes += bytes_of(value.cell);
  return bytes;
}

/// Of a table besides its rows: the columns of table.h5 [bytes].
constexpr double bytes_of_a_table = 28e3;

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

struct Probe {
  double seconds = 0, bytes = 0;
};

Probe probe(const Study &study, const Systems &systems, std::size_t system, const fleets::Sweep &sweep,
            std::size_t run) {
  auto overrides = systems.all[system].overrides;
  for (auto &assignment : sweep.assignments(run)) overrides.push_back(std::move(assignment));
  const std::clock_t start = std::clock(); // of the processor: another program beside it does not count
  const auto row = fleets::row_of(reduced::simulate_summary(scene::load_scene(study.scene, overrides)));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return {seconds, bytes_of(row, sweep.runs[run])};
}

} // namespace

StudyPlan plan_study(const Study &study, const Systems &systems, const Motions &motions, int probes) {
  StudyPlan plan{.n_systems = systems.size(), .samples = static_cast<std::size_t>(std::max(1, study.parts.samples))};
  for (const auto &level : motions.levels)
    plan.n_motions += level.motions.size(), plan.n_listed += static_cast<std::size_t>(level.n_listed);
  const std::size_t each = plan.n_motions * plan.samples;
  plan.runs = plan.n_systems * each;
  Probe sum;
  double text_bytes = 0; // of one system's runs, as they are held in memory
  for (int i = 0; i < probes; ++i) {
    const double place = (i + 0.5) / probes; // systems in order, runs by the golden section: every level comes
    const auto system = static_cast<std::size_t>(place * static_cast<double>(plan.n_systems));
    const auto run = static_cast<std::size_t>(std::fmod(0.618034 * (i + 1), 1.0) * static_cast<double>(each));
    const auto sweep = runs_of(study, systems, system, motions);
    const Probe one = probe(study, systems, system, sweep, run);
    sum.seconds += one.seconds, sum.bytes += one.bytes, ++plan.n_probed;
    text_bytes = static_cast<double>(each * sweep.keys.size()) * 2 * sizeof(fleets::Value);
  }
  const auto runs = static_cast<double>(plan.runs), n = static_cast<double>(plan.n_probed);
  plan.seconds_a_run = sum.seconds / n;
  plan.core_hours = runs * plan.seconds_a_run / 3600;
  plan.table_bytes = runs * sum.bytes / n + static_cast<double>(plan.n_systems) * bytes_of_a_table;
  plan.memory_bytes = peak_memory() + text_bytes + 4 * static_cast<double>(each) * sum.bytes / n;
  plan.shards_of_an_hour = static_cast<std::size_t>(std::max(1.0, std::ceil(plan.core_hours / 2)));
  return plan;
}

std::string describe(const StudyPlan &p) {
  return fmt::format("{} systems x {} motions (of {} listed) x {} samples = {} runs\n"
                     "{:.3f} s a run and core ({} runs tried): {:.2f} core hours\n"
                     "memory about {:.0f} MB a process, tables about {:.0f} MB\n"
                     "shards of an hour on two cores: {}\n",
                     p.n_systems, p.n_motions, p.n_listed, p.samples, p.runs, p.seconds_a_run, p.n_probed, p.core_hours,
                     p.memory_bytes / 1e6, p.table_bytes / 1e6, p.shards_of_an_hour);
}

nlohmann::ordered_json to_json(const StudyPlan &p) {
  return {{"n_systems", p.n_systems},
          {"n_motions", p.n_motions},
          {"n_listed", p.n_listed},
          {"samples", p.samples},
          {"n_runs", p.runs},
          {"n_probed", p.n_probed},
          {"seconds_a_run", p.seconds_a_run},
          {"core_hours", p.core_hours},
          {"memory_bytes", p.memory_bytes},
          {"table_bytes", p.table_bytes},
          {"shards_of_an_hour", p.shards_of_an_hour}};
}

} // namespace rimpact::risk
