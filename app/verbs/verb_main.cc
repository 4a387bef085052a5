// rimpact main: from a bearing to its impact law, with a report.
#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/jobs/early_answer.h"
#include "app/jobs/folder_claim.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/main_results.h"
#include "app/verbs/calibrate_options.h"
#include "app/verbs/catalogue.h"
#include "app/verbs/document_options.h"
#include "io/files/json_text.h"
#include "io/files/text.h"
#include "responses/identity.h"
#include "scene/doubts.h"
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

struct MainOptions {
  std::string target = "shfps-225", folder = "results/main", laws = "signed,no-tension,elastoplastic", pulse_speeds,
              until;
  MainChoices choices;
  std::size_t at_once = 0;
  bool dry_run = false, no_report = false;
  DocumentWords document;
};

SpeedRange speed_range(const std::string &text) {
  const auto ends = split(text, ':');
  SpeedRange range{0, 0};
  if (ends.size() == 2) range = {to_number(ends[0]).value_or(0), to_number(ends[1]).value_or(0)};
  if (!(range.low > 0 && range.low < range.high && range.high <= 100))
    throw InputError(
        fmt::format("--pulse-speeds {} must be LOW:HIGH in m/s with 0 < LOW < HIGH <= 100, e.g. 0.05:0.6", text));
  return range;
}

/// A share, of per cent with or without their sign.
double share_of_percent(std::string text) {
  const std::string typed = text;
  if (text.ends_with('%')) text.pop_back();
  const auto value = to_number(text);
  if (!value || !(*value > 0 && *value <= 100))
    throw InputError(fmt::format("--until {} must be a number of per cent above 0, up to 100, e.g. 5%", typed));
  return *value / 100;
}

/// What would run, and how long it takes.
void print_plan(const MainTarget &target, const MainJobs &jobs, std::size_t at_once, const Console &console) {
  const auto times = expected_times(jobs.jobs);
  const double in_all = time_to_go(times, at_once);
  nlohmann::json rows = nlohmann::json::array();
  std::string text = target.head() + fmt::format("{:28s} {:8s} {}\n", "run", "role", "expected");
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto &job = jobs.jobs[k];
    rows.push_back({{"name", job.name},
                    {"role", word(job.role)},
                    {"expected_seconds", times[k].expected},
                    {"identity", to_json(identity_of(job.scene))}});
    text += fmt::format("{:28s} {:8s} {}\n", job.name, word(job.role), about(times[k].expected));
  }
  text += fmt::format("{} runs, {} at a time: {} in all\n", times.size(), at_once, about(in_all));
  const nlohmann::json table{
      {"bearing", target.bearing_json()}, {"load", target.load_json()}, {"runs", rows},
      {"left_out", jobs.left_out},        {"at_once", at_once},         {"expected_seconds", in_all}};
  console.data(console.json ? json_text(table) : text);
}

/// The runs that are wanted: those left out are taken out of `jobs`, the others are put as they stand in tables.
void make_runs(JobRunner &runner, std::vector<Job> &jobs, EarlyAnswer &early, MainContext &context) {
  watch_interrupts();
  runner.run([&](std::vector<Job> &all) { early(all); });
  std::erase_if(jobs, [](const Job &job) { return job.left_out; });
  if (!early.left_out().empty()) context.warnings.push_back(early.left_out());
  sort_for_tables(jobs);
  context.until = early.to_json();
}

/// Throws InputError where the error asked for cannot be had.
std::optional<double> asked_error(const MainOptions &options, const std::vector<std::string> &laws) {
  if (options.until.empty()) return {};
  const double until = share_of_percent(options.until);
  if (laws.empty())
    throw InputError("--until asks for windows left out of the fit, and --laws none ranks no law by them");
  return until;
}

void run_main(MainOptions options, Console &console) {
  const auto begin = std::chrono::steady_clock::now();
  const auto spent = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  if (!options.pulse_speeds.empty()) options.choices.pulse_speeds = speed_range(options.pulse_speeds);
  MainContext context{
      .folder = options.folder, .laws = laws_named(options.laws), .document = document_json(options.document)};
  EarlyAnswer early(options.folder, context.laws, asked_error(options, context.laws), console);
  const MainTarget target = main_target(options.target, console.settings());
  auto [jobs, left_out] = main_jobs(target, options.choices, options.folder);
  context.warnings = target.warnings;
  for (const auto &doubt : scene::doubts(target.scene)) context.warnings.push_back(doubt);
  for (const auto &sentence : left_out) context.warnings.push_back(sentence);
  for (const auto &warning : context.warnings) console.warn(warning);
  for (const auto &remark : target.remarks) console.message(remark);
  const std::size_t at_once = options.at_once > 0 ? options.at_once : cores_to_use();
  if (options.dry_run) return print_plan(target, {jobs, left_out}, at_once, console);
  JobRunner runner(jobs, console, at_once);
  const auto lock = claim_for_jobs(options.folder, Collection::main_job, jobs, console.force);
  make_runs_folder(options.folder);
  context.versions = fe_versions(options.folder, console);
  console.message(target.head() +
                  fmt::format("{} runs, {} at a time: {}", jobs.size(), at_once, about(runner.expected_seconds())));

  make_runs(runner, jobs, early, context);
  context.seconds = spent();
  MainResults results = make_results(target, jobs, context, console);
  if (options.no_report) std::filesystem::remove(options.folder + "/report.html"); // of other results
  const bool made = !options.no_report && python({"report", options.folder}) == 0;
  const std::string report = options.folder + "/report.html";
  results.main["report"] = made ? nlohmann::json(report) : nlohmann::json();
  console.data(console.json ? json_text(results.main) : results.text);
  if (interrupted()) throw Error(ExitCode::interrupted, "interrupted; the same command goes on where it stopped");
  if (!made && !options.no_report) throw IoError("the report was not written; try rimpact report " + options.folder);
  if (made && !console.json) console.data(fmt::format("report: {}  ({} in all)\n", report, duration(spent())));
  require_done(jobs);
  if (results.failure) std::rethrow_exception(results.failure);
}

void add_main(CLI::App &verb, Console &console) {
  auto options = std::make_shared<MainOptions>();
  verb.add_option(
          "SCENE", options->target,
          "a scene or bearing: built-in, a TOML file, or a case folder of `new`; its load and settings are taken")
      ->capture_default_str();
  verb.add_option("-o,--output", options->folder, "results folder")->capture_default_str();
  verb.add_option("--speeds", options->choices.speeds, "of the windows [m/s]")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->allow_extra_args(false)
      ->capture_default_str();
  verb.add_flag("--windows-only", options->choices.windows_only, "no pulses");
  verb.add_flag("--bidirectional", options->choices.bidirectional,
                "also a motion in two directions (pulse-bidirectional), predicted");
  verb.add_flag_function(
      "--twins,!--no-twins", [options](std::int64_t count) { options->choices.twins = count > 0; },
      "windows with the other steel too, without its strain rate and with it (default: for a bearing of yours)");
  verb.add_option("--pulse-speeds", options->pulse_speeds,
                  "LOW:HIGH [m/s], speeds at the rim for which the pulses' scales are chosen (0.05:0.6 for a bearing "
                  "or load of yours)");
  verb.add_option("--until", options->until,
                  "per cent, e.g. 5%: begin no further window or pulse once peak force and rebound of windows left "
                  "out of the fit are met so well");
  verb.add_option("--jobs", options->at_once, "runs at a time (default: the cores this process may use)")
      ->check(CLI::Range(1, 256));
  verb.add_flag("--dry-run", options->dry_run, "list the runs and the time they take, and stop");
  verb.add_option("--laws", options->laws, "impact laws to rank in the report: all, none or names")
      ->capture_default_str();
  verb.add_flag("--no-report", options->no_report, "leaves report.html out; an earlier one is removed");
  add_document_options(verb, options->document);
  console.add_common(verb);
  console.add_json(verb);
  console.add_overrides(verb);
  console.add_model(verb);
  console.add_force(verb);
  verb.callback([options, &console] { run_main(*options, console); });
}

} // namespace

const Verb main_verb{{.name = "main",
                      .help = "the main job: rim impacts by FE, calibration, comparison, report",
                      .examples = "rimpact main\n"
                                  "rimpact main my-case -o my-case/main --title \"Rim impact\"\n"
                                  "rimpact main my-case/bearing.toml --set load.vertical_kN=2000 --dry-run",
                      .next = "rimpact export {}/calibration --opensees --csv",
                      .usual = "results/main"},
                     add_main};

} // namespace rimpact::app
