// rimpact reliability STUDY: fleets of systems under records of every level, fragility, hazard, probability, report.
#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/console/memory.h"
#include "app/console/progress.h"
#include "app/jobs/shard.h"
#include "app/verbs/catalogue.h"
#include "app/words/slurm_scripts.h"
#include "io/files/folder_lock.h"
#include "io/files/json_text.h"
#include "io/records/record_library.h"
#include "studies/risk/plan.h"
#include "studies/risk/results.h"
#include "studies/risk/study_reader.h"
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace rimpact::app {
namespace {

struct ReliabilityOptions {
  std::string study, folder, shard, table;
  std::vector<std::string> records;
  int n_threads = 0, slurm = 0, samples = 0; ///< samples 0: as the study has them
  bool dry_run = false, no_report = false, resume = false;
};

/// The first few of `doubts`, from the n-th on.
void warn_of(const std::vector<std::string> &doubts, std::size_t n, Console &console) {
  constexpr std::size_t shown = 5;
  for (std::size_t i = n; i < doubts.size() && i < n + shown; ++i) console.warn(doubts[i]);
  if (doubts.size() > n + shown)
    console.warn(fmt::format("and {} more of that kind, all in reliability.json", doubts.size() - n - shown));
}

void tell(const risk::Motions &motions, Console &console) {
  std::size_t n_motions = 0, n_listed = motions.missing.size();
  for (const auto &level : motions.levels) n_motions += level.motions.size();
  n_listed += n_motions;
  if (!motions.missing.empty())
    console.warn(fmt::format("{} of {} motions are not at hand (all of them in reliability.json), e.g. {}",
                             motions.missing.size(), n_listed, motions.missing.front()));
  warn_of(motions.doubts, 0, console);
  for (const auto &level : motions.levels)
    console.message(fmt::format("level {:.4g} g, {:.0f} years: {} motions of {}", level.intensity_g,
                                level.return_period_years, level.motions.size(), level.n_listed));
}

risk::CampaignResult run_fleets(const ReliabilityOptions &options, const risk::Study &study,
                                const risk::Systems &systems, const risk::Motions &motions, Console &console) {
  const auto [shard, n_shards] = parse_shard(options.shard);
  ProgressLine line(console.quiet);
  risk::CampaignOptions campaign{.folder = options.folder,
                                 .shard = shard,
                                 .n_shards = n_shards,
                                 .n_threads = options.n_threads,
                                 .force = console.force,
                                 .interrupted = &interrupted()};
  campaign.remark = [&](const std::string &sentence) { console.message(sentence); };
  campaign.progress = [&](const risk::CampaignProgress &p) {
    line.show(fmt::format("system {} of {}: {} of {} runs, {} without a result, {}, about {} to go", p.system,
                          p.n_systems, p.runs.done, p.runs.total, p.runs.failed, duration(p.seconds),
                          duration(p.seconds_left)));
  };
  campaign.first = [&](const scene::Scene &scene) { console.report_first_run(scene); };
  watch_interrupts();
  return risk::run_campaign(study, systems, motions, campaign);
}

/// A limit's probabilities over all systems, and the range of what is open where one number does not say it.
struct Headline {
  double least = 1, largest = 0, range_low = 1, range_high = 0;
  bool settled = true;
};

std::string in_words(const std::string &quantity, double limit, const Headline &line) {
  std::string text = fmt::format("{:>28} > {:<8g} ", quantity, limit);
  if (line.settled) return text + fmt::format("{:9.3e} {:9.3e}\n", line.least, line.largest);
  return text +
         fmt::format("between {:.1e} and {:.1e}: the levels do not decide it\n", line.range_low, line.range_high);
}

/// FEMA P-695: the least and the mean margin of all systems beside what is asked.
std::string collapse_in_words(const nlohmann::ordered_json &p695) {
  double least = std::numeric_limits<double>::infinity();
  bool is_bound = false;
  for (const auto &system : p695["systems"])
    least = std::min(least, system["adjusted_collapse_margin"].get<double>()),
    is_bound |= system["is_lower_bound"].get<bool>();
  return fmt::format(
      "FEMA P-695: least adjusted collapse margin {:.2f} ({:.2f} needed: {}), mean {:.2f} ({:.2f} needed: "
      "{}), total uncertainty {:.3f}{}\n",
      least, p695["acceptable_20"].get<double>(), p695["all_accepted"].get<bool>() ? "accepted" : "not accepted",
      p695["mean_adjusted_collapse_margin"].get<double>(), p695["acceptable_10"].get<double>(),
      p695["accepted_on_average"].get<bool>() ? "accepted" : "not accepted", p695["total_uncertainty"].get<double>(),
      is_bound ? "; where fewer than half of the runs collapse at every level the margin is a lower bound" : "");
}

/// The probabilities of every quantity, one line a limit, over all systems.
std::string describe(const risk::Results &results, const std::string &folder) {
  const auto &table = results.tables.at("reliability");
  const auto at = [&](const std::vector<Cell> &row, const char *name) -> const Cell & {
    return row[static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), name) -
                                        table.columns.begin())];
  };
  const auto number = [&](const std::vector<Cell> &row, const char *name) { return std::get<double>(at(row, name)); };
  std::map<std::pair<std::string, double>, Headline> lines;
  for (const auto &row : table.rows) {
    Headline &line = lines[std::pair(std::get<std::string>(at(row, "quantity")), number(row, "limit"))];
    const double p = number(row, "probability");
    line.least = std::min(line.least, p), line.largest = std::max(line.largest, p);
    line.range_low = std::min(line.range_low, number(row, "probability_range_low"));
    line.range_high = std::max(line.range_high, number(row, "probability_range_high"));
    line.settled &= number(row, "settled") != 0;
  }
  std::string text = fmt::format("probability of exceedance in {:g} years, least and largest of {} systems\n",
                                 results.summary["years"].get<double>(), results.summary["n_systems"].get<int>());
  for (const auto &[key, line] : lines) text += in_words(key.first, key.second, line);
  for (const auto &d : results.summary["differences"])
    text += fmt::format("{} = {}: P({} > {:g}) reduced by {:.1f} % on average ({:.1f} to {:.1f} %, {} systems)\n",
                        d["key"].get<std::string>(), d["value"].dump(), d["quantity"].get<std::string>(),
                        d["limit"].get<double>(), 100 * d["mean_reduction"].get<double>(),
                        100 * d["least_reduction"].get<double>(), 100 * d["largest_reduction"].get<double>(),
                        d["n_systems"].get<int>());
  if (const int n = results.summary["n_runs_without_result"].get<int>(); n > 0)
    text += fmt::format("{} runs have no result. They count for the limits they had passed by then; columns "
                        "probability_if_none and _if_all of reliability.csv: none or all of them beyond the others\n",
                        n);
  if (results.summary.contains("p695")) text += collapse_in_words(results.summary["p695"]);
  return text + fmt::format("{}/reliability.json, tables beside it\n", folder);
}

void show_plan(const risk::Study &study, const risk::Systems &systems, const risk::Motions &motions, Console &console) {
  const auto plan = risk::plan_study(study, systems, motions);
  if (const auto doubt = doubt_of_memory(plan.memory_bytes); !doubt.empty()) console.warn(doubt);
  console.data(console.json ? json_text(risk::to_json(plan)) : risk::describe(plan));
}

/// Of the runs gathered: results, report, what to say.
void evaluate(const ReliabilityOptions &options, const risk::Study &study, const risk::Systems &systems,
              const risk::Motions &motions, const risk::CampaignResult &done, Console &console) {
  const FolderLock lock(options.folder, "results");
  ProgressLine line(console.quiet);
  auto results = risk::evaluate_study(study, systems, motions, options.folder, [&](std::size_t n) {
    line.show(fmt::format("{} of {} systems evaluated", n, systems.size()));
  });
  line.finish();
  warn_of(results.summary["doubts"].get<std::vector<std::string>>(), motions.doubts.size(), console);
  results.summary["wall_time_s"] = done.seconds;
  results.summary["n_runs"] = done.runs, results.summary["kept"] = done.kept;
  risk::write_results(results, options.folder);
  if (!options.no_report && python({"report.reliability", options.folder}) != 0)
    console.warn("the report in " + options.folder + " was not made");
  console.data(console.json ? json_text(results.summary) : describe(results, options.folder));
}

void run_reliability(ReliabilityOptions options, Console &console) {
  risk::Study study = risk::read_study(options.study);
  if (!options.table.empty()) {
    if (study.motions.table.empty())
      throw InputError(options.study + ": --table replaces motions.table, and this study has none");
    study.motions.table = options.table;
  }
  if (options.samples > 0) {
    if (study.parts.sampled.empty())
      throw InputError(options.study + ": --samples replaces latin_hypercube.samples, and this study has none");
    study.parts.samples = options.samples;
  }
  if (options.folder.empty()) options.folder = default_folder(study.name);
  if (options.slurm > 0) return write_slurm({.shards = options.slurm, .folder = options.folder}, console);
  const bool is_shard = parse_shard(options.shard).second > 1;
  const auto systems = risk::systems_of(study);
  if (const std::string shelf = records_shelf();
      !shelf.empty() && options.records.empty() && study.motions.folders.empty()) {
    options.records.push_back(shelf);
    console.message(fmt::format("records of {} (RIMPACT_RECORDS)", shelf));
  }
  const auto motions = risk::motions_of(study, options.records);
  tell(motions, console);
  if (options.dry_run) return show_plan(study, systems, motions, console);
  const auto done = run_fleets(options, study, systems, motions, console);
  const std::string ran = fmt::format("{} runs of {} systems ({} kept from before) in {}, {} without a result\n",
                                      done.runs, done.systems, done.kept, duration(done.seconds), done.without_result);
  if (is_shard) {
    console.message("this shard is done; the same command without --shard gathers all and evaluates them");
    return console.data(ran);
  }
  console.message(ran);
  evaluate(options, study, systems, motions, done, console);
}

void add_reliability(CLI::App &verb, Console &console) {
  auto options = std::make_shared<ReliabilityOptions>();
  verb.add_option("STUDY", options->study, "a study file (docs/guide/reliability.md)")->required();
  verb.add_option("-o,--output", options->folder, "results folder (default results/STUDY); finished runs are kept");
  verb.add_option("--records", options->records,
                  "a folder of records, besides the study's own (repeatable); where neither names one, that of "
                  "RIMPACT_RECORDS")
      ->allow_extra_args(false);
  verb.add_option("--table", options->table, "the table of motions, in place of the study's motions.table");
  verb.add_option("--samples", options->samples, "of the Latin hypercube, in place of the study's: 1 for a first look")
      ->check(CLI::Range(1, 100000));
  verb.add_option("--shard", options->shard, "I/N: every N-th system from the I-th on, with the same -o");
  add_slurm(verb, options->slurm);
  verb.add_option("--threads,--jobs", options->n_threads, "default: as many as the machine has")
      ->check(CLI::Range(1, 1024));
  verb.add_flag("--dry-run", options->dry_run, "the plan: runs, hours, memory, files, shards");
  verb.add_flag("--no-report", options->no_report, "leaves report.html out");
  verb.add_flag("--resume", options->resume, "what a study always does: finished runs are kept");
  console.add_common(verb);
  console.add_json(verb);
  console.add_force(verb);
  verb.callback([options, &console] { run_reliability(*options, console); });
}

} // namespace

const Verb reliability_verb{{.name = "reliability",
                             .help = "fragility, hazard and probability in 50 years of many systems",
                             .examples = "rimpact reliability my-study",
                             .next = "rimpact report {}"},
                            add_reliability};

} // namespace rimpact::app
