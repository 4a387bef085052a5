// rimpact run SCENE: a scene by finite elements.
#include "app/folder_claim.h"
#include "app/impact_words.h"
#include "app/memory.h"
#include "app/progress.h"
#include "app/progress_in_words.h"
#include "app/run_words.h"
#include "app/sibling.h"
#include "app/verb.h"
#include "calibration/studies/stored_study.h"
#include "fe_contact/drive/run.h"
#include "files/file.h"
#include "files/json_text.h"
#include "planning/machine_times.h"
#include "responses/identity.h"
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace rimpact::app {
namespace {

/// The result of a run that had ended before.
void tell_kept(const std::string &folder, const std::string &name, Console &console) {
  const auto summary = read_summary(folder);
  if (console.json) return console.data(json_text(summary));
  const auto number = [&](const char *key) {
    return summary.contains(key) && summary[key].is_number() ? summary[key].get<double>() : 0.0;
  };
  console.data(
      fmt::format("{}: peak displacement {:.1f} mm, peak impact force {:.1f} kN, {:.0f} impact(s), {:.0f} steps; {}\n",
                  name, 1e3 * number("peak_displacement_m"), 1e-3 * number("peak_impact_force_N"), number("n_impacts"),
                  number("n_steps"), folder));
}

void print_plan(const scene::Scene &scene, const planning::Plan &plan, const Console &console) {
  if (!console.json) return console.data(planning::describe(plan));
  nlohmann::json table = planning::to_json(plan);
  table["identity"] = to_json(identity_of(scene));
  console.data(json_text(table));
}

void run(const RunWords &options, Console &console) {
  const scene::Scene scene = console.load(options.scene);
  if (const std::string warning = fe::blas_warning(); !warning.empty()) console.warn(warning);
  fe::check_supported(scene);
  const planning::Plan plan = planning::make_plan(scene);
  if (options.dry_run) return print_plan(scene, plan, console);
  console.message(planning::describe(plan));
  if (const auto doubt = doubt_of_memory(plan.expected_memory_bytes); !doubt.empty()) console.warn(doubt);
  for (const auto &[name, version] : fe::component_versions()) console.detail(fmt::format("{} {}", name, version));

  fe::RunOptions run_options;
  run_options.folder = options.folder.empty() ? default_folder(scene.name) : options.folder;
  run_options.resume = options.resume;
  run_options.fields = !options.no_fields;
  run_options.fields_every = 1e-3 * options.fields_every_ms;
  run_options.writes = fe::is_first_rank();
  std::optional<ClaimedFolder> claim; // the first rank's, for all
  if (run_options.writes)
    claim.emplace(claim_for_run({.given = options.scene,
                                 .folder = run_options.folder,
                                 .finite_elements = true,
                                 .resume = options.resume,
                                 .force = console.force},
                                scene, console));
  if (fe::on_any_rank(claim && claim->finished)) {
    console.message(run_options.folder + ": this run has ended well already; nothing is left to resume");
    if (run_options.writes) tell_kept(run_options.folder, scene.name, console);
    return;
  }
  run_options.interrupted = &interrupted();
  ProgressLine line(console.quiet);
  run_options.remark = [&](const std::string &sentence) {
    line.finish();
    console.message(sentence);
  };
  run_options.annotate = [&](Summary &summary) {
    const auto beside = std::filesystem::absolute(run_options.folder).lexically_normal().parent_path();
    try {
      summary.extra["error_estimate"] = calibration::error_estimate(scene, summary, calibration::stored_studies(beside),
                                                                    {run_options.folder, summary.wall_time});
    } catch (const std::exception &error) { // a damaged study beside the folder must not cost the run
      summary.extra["error_estimate"] = {{"none", std::string("a stored study cannot be read: ") + error.what()}};
    }
  };
  watch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  ProgressInWords in_words(scene.excitation);
  run_options.progress = [&](const fe::Progress &p) {
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    line.show(in_words.of(p) + "  (" + duration(spent) + ")" + (console.verbose ? numbers_of(p) : ""));
  };
  std::exception_ptr failure;
  bool refused = false; // what an earlier run left stays as it is
  Summary summary;
  try {
    summary = fe::run(scene, plan, run_options);
  } catch (const SolverStopped &) {
    failure = std::current_exception();
  } catch (const Error &) {
    failure = std::current_exception(), refused = true;
  }
  line.finish();
  if (!run_options.writes) { // the first rank tells
    if (failure) std::rethrow_exception(failure);
    return;
  }
  if (!failure) {
    planning::remember_times(plan, summary);
    for (const auto &warning : summary.extra["warnings"]) console.warn(warning.get<std::string>());
    for (const auto &impact : summary.impacts)
      console.message(fmt::format("impact at {}, {:.1f} deg: {}, {:.0f} kN, {:.2f} mm",
                                  when(impact, scene.excitation.is_dynamic()), impact.direction_deg,
                                  how_fast(impact, scene.excitation.is_dynamic(), 3), 1e-3 * impact.peak_force,
                                  1e3 * impact.peak_penetration));
    std::string split;
    for (const auto &[name, seconds] : summary.time_split) split += fmt::format(" {} {:.1f} s,", name, seconds);
    console.message("time:" + split.substr(0, split.size() - 1));
    const auto &estimate = summary.extra["error_estimate"];
    console.message("discretisation: " + estimate.value("sentence", estimate.value("none", "")));
  }
  if (!refused && std::filesystem::exists(run_options.folder + "/summary.json"))
    write_atomically(console.log(), run_options.folder + "/log.txt");
  if (failure) std::rethrow_exception(failure);
  const std::string peak = plan.rim_takes_part
                               ? fmt::format("peak impact force {:.1f} kN, {} impact(s)",
                                             1e-3 * summary.peak_impact_force.value_or(0), summary.impacts.size())
                               : fmt::format("peak displacement {:.1f} mm, peak lateral force {:.1f} kN, no impact",
                                             1e3 * summary.peak_displacement, 1e-3 * summary.peak_lateral_force);
  console.data(console.json ? json_text(to_json(summary))
                            : fmt::format("{}: {}, {} steps, {}; {}\n", scene.name, peak, summary.n_steps,
                                          duration(summary.wall_time), run_options.folder));
}

} // namespace

void add_run(CLI::App &app, Console &console) {
  auto *verb = app.add_subcommand("run", "run a scene by finite elements");
  auto words = std::make_shared<RunWords>();
  add_run_words(*verb, *words, console);
  verb->add_option_function<int>(
      "--ranks", [](int) { throw InputError("--ranks is for rimpact, which starts rimpact-fe on them"); },
      "so many processes share the run; 1: one alone; without it the dear rungs take two on mesh 1 and finer");
  verb->callback([words, &console] { run(*words, console); });
}

} // namespace rimpact::app
