// rimpact run SCENE: a scene by finite elements.
#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/console/memory.h"
#include "app/console/progress.h"
#include "app/jobs/folder_claim.h"
#include "app/verbs/catalogue.h"
#include "app/verbs/fe_verb_texts.h"
#include "app/words/impact_words.h"
#include "app/words/progress_in_words.h"
#include "app/words/run_words.h"
#include "calibration/studies/stored_study.h"
#include "fe_contact/drive/run.h"
#include "fe_contact/drive/versions.h"
#include "fe_contact/planning/machine_times.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
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

fe::RunOptions order_of(const RunWords &words, const scene::Scene &scene) {
  fe::RunOptions order;
  order.folder = words.folder.empty() ? default_folder(scene.name) : words.folder;
  order.resume = words.resume;
  order.fields = !words.no_fields;
  order.fields_every = 1e-3 * words.fields_every_ms;
  order.writes = fe::is_first_rank();
  order.interrupted = &interrupted();
  order.annotate = [&scene, folder = order.folder](Summary &summary) {
    const auto beside = std::filesystem::absolute(folder).lexically_normal().parent_path();
    try {
      summary.extra["error_estimate"] =
          calibration::error_estimate(scene, summary, calibration::stored_studies(beside), {folder, summary.wall_time});
    } catch (const std::exception &error) { // a damaged study beside the folder must not cost the run
      summary.extra["error_estimate"] = {{"none", std::string("a stored study cannot be read: ") + error.what()}};
    }
  };
  return order;
}

/// How a run ended.
struct Ending {
  Summary summary;
  std::exception_ptr failure = nullptr;
  bool refused = false; ///< what an earlier run left stays as it is
};

Ending solve(const scene::Scene &scene, const planning::Plan &plan, fe::RunOptions order, Console &console) {
  ProgressLine line(console.quiet);
  order.remark = [&](const std::string &sentence) {
    line.finish();
    console.message(sentence);
  };
  const auto start = std::chrono::steady_clock::now();
  ProgressInWords in_words(scene.excitation);
  order.progress = [&](const fe::Progress &p) {
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    line.show(in_words.of(p) + "  (" + duration(spent) + ")" + (console.verbose ? numbers_of(p) : ""));
  };
  Ending ending;
  try {
    ending.summary = fe::run(scene, plan, order);
  } catch (const SolverStopped &) {
    ending.failure = std::current_exception();
  } catch (const Error &) {
    ending.failure = std::current_exception(), ending.refused = true;
  }
  line.finish();
  return ending;
}

void tell(const Summary &summary, const scene::Scene &scene, Console &console) {
  for (const auto &warning : summary.extra["warnings"]) console.warn(warning.get<std::string>());
  const bool in_time = scene.excitation.is_dynamic();
  for (const auto &impact : summary.impacts)
    console.message(fmt::format("impact at {}, {:.1f} deg: {}, {:.0f} kN, {:.2f} mm", when(impact, in_time),
                                impact.direction_deg, how_fast(impact, in_time, 3), 1e-3 * impact.peak_force,
                                1e3 * impact.peak_penetration));
  std::string split;
  for (const auto &[name, seconds] : summary.time_split) split += fmt::format(" {} {:.1f} s,", name, seconds);
  console.message("time:" + split.substr(0, split.size() - 1));
  const auto &estimate = summary.extra["error_estimate"];
  console.message("discretisation: " + estimate.value("sentence", estimate.value("none", "")));
}

std::string in_one_line(const Summary &summary, const scene::Scene &scene, const planning::Plan &plan,
                        const std::string &folder) {
  const std::string peak = plan.rim_takes_part
                               ? fmt::format("peak impact force {:.1f} kN, {} impact(s)",
                                             1e-3 * summary.peak_impact_force.value_or(0), summary.impacts.size())
                               : fmt::format("peak displacement {:.1f} mm, peak lateral force {:.1f} kN, no impact",
                                             1e3 * summary.peak_displacement, 1e-3 * summary.peak_lateral_force);
  return fmt::format("{}: {}, {} steps, {}; {}\n", scene.name, peak, summary.n_steps, duration(summary.wall_time),
                     folder);
}

void run(const RunWords &words, Console &console) {
  const scene::Scene scene = console.load(words.scene);
  if (const std::string warning = fe::blas_warning(); !warning.empty()) console.warn(warning);
  fe::check_supported(scene);
  const planning::Plan plan = planning::make_plan(scene);
  if (words.dry_run) return print_plan(scene, plan, console);
  console.message(planning::describe(plan));
  if (const auto doubt = doubt_of_memory(plan.expected_memory_bytes); !doubt.empty()) console.warn(doubt);
  for (const auto &[name, version] : fe::component_versions()) console.detail(fmt::format("{} {}", name, version));

  const fe::RunOptions order = order_of(words, scene);
  std::optional<ClaimedFolder> claim; // the first rank's, for all
  if (order.writes)
    claim.emplace(claim_for_run({.given = words.scene,
                                 .folder = order.folder,
                                 .finite_elements = true,
                                 .resume = words.resume,
                                 .force = console.force},
                                scene, console));
  if (fe::on_any_rank(claim && claim->finished)) {
    console.message(order.folder + ": this run has ended well already; nothing is left to resume");
    if (order.writes) tell_kept(order.folder, scene.name, console);
    return;
  }
  watch_interrupts();
  const Ending ending = solve(scene, plan, order, console);
  if (order.writes && !ending.failure) {
    planning::remember_times(plan, ending.summary);
    tell(ending.summary, scene, console);
  }
  if (order.writes && !ending.refused && std::filesystem::exists(order.folder + "/summary.json"))
    write_atomically(console.log(), order.folder + "/log.txt");
  if (ending.failure) std::rethrow_exception(ending.failure);
  if (order.writes) // the first rank tells
    console.data(console.json ? json_text(to_json(ending.summary))
                              : in_one_line(ending.summary, scene, plan, order.folder));
}

void add_run(CLI::App &verb, Console &console) {
  auto words = std::make_shared<RunWords>();
  add_run_words(verb, *words, console);
  verb.add_option_function<int>(
      "--ranks", [](int) { throw InputError("--ranks is for rimpact, which starts rimpact-fe on them"); },
      "so many processes share the run; 1: one alone; without it a run takes two on mesh 1 and finer");
  verb.callback([words, &console] { run(*words, console); });
}

} // namespace

const Verb run_verb{text_of_run, add_run};

} // namespace rimpact::app
