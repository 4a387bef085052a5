// rimpact study SCENE: the same scene with cheaper and more expensive settings, speed against error.
#include "app/console/child_process.h"
#include "app/console/interrupts.h"
#include "app/jobs/folder_claim.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/main_target.h"
#include "app/jobs/shard.h"
#include "app/jobs/time_to_go.h"
#include "app/verbs/catalogue.h"
#include "app/words/set_keys.h"
#include "app/words/slurm_scripts.h"
#include "calibration/studies/speed_error.h"
#include "calibration/studies/speed_error_text.h"
#include "calibration/studies/stored_study.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "responses/build_version.h"
#include "responses/response.h"
#include "responses/run_folder.h"
#include "scene/case_description.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::app {
namespace {

/// What a study varies.
enum class StudyAxis { rung, mesh, step };
constexpr auto choices(StudyAxis) {
  using enum StudyAxis;
  return choices_of<StudyAxis>({{rung, "rung"}, {mesh, "mesh"}, {step, "step"}});
}

struct StudyOptions {
  std::string scene, folder, shard, curve;
  std::vector<std::string> axes{word(StudyAxis::rung), word(StudyAxis::mesh)};
  std::vector<std::string> rungs{word(SolvedBy::reduced), word(SolvedBy::rim)};
  std::vector<SolvedBy> solvers() const; ///< what the rungs' words say
  std::vector<int> meshes{1, 2};
  std::vector<double> steps{1.0, 0.5}; // [ms]
  double wanted = 2;                   // [%]
  int slurm = 0;
  bool dry_run = false;
  bool varies(StudyAxis axis) const { return std::find(axes.begin(), axes.end(), word(axis)) != axes.end(); }
};

std::vector<SolvedBy> StudyOptions::solvers() const {
  std::vector<SolvedBy> list;
  for (const auto &rung : rungs) list.push_back(parse<SolvedBy>(rung).value()); // checked by the command line
  return list;
}

bool has_reduced(const StudyOptions &options) {
  const auto solvers = options.solvers();
  return std::find(solvers.begin(), solvers.end(), SolvedBy::reduced) != solvers.end();
}

/// The scene with the rim's own curve for its element.
scene::Scene on_curve(scene::Scene scene, const std::string &file) {
  scene.reduced.impact_law = &laws::impact_law("curve");
  scene.reduced.impact_curve = std::filesystem::absolute(file).lexically_normal().string();
  scene.validate();
  return scene;
}

/// One job a combination; the reduced model knows neither mesh nor step.
std::vector<Job> study_jobs(const StudyOptions &options, const scene::Scene &base) {
  const auto solvers = options.varies(StudyAxis::rung) ? options.solvers() : std::vector{solved_by(base.model.rung)};
  const auto meshes = options.varies(StudyAxis::mesh) ? options.meshes : std::vector<int>{base.model.mesh};
  const auto steps = options.varies(StudyAxis::step) ? options.steps : std::vector<double>{1e3 * base.model.step};
  std::vector<Job> jobs;
  const auto add = [&](const std::string &name, scene::Scene scene, bool reduced) {
    scene.name = base.name;
    jobs.push_back({.name = name,
                    .role = JobRole::study,
                    .scene = scene,
                    .folder = options.folder + "/runs/" + name,
                    .reduced = reduced});
  };
  for (const auto solver : solvers) {
    const auto rung = rung_of(solver);
    if (!rung) {
      add(word(solver), base, true);
      if (!options.curve.empty()) add("curve", on_curve(base, options.curve), true);
      continue;
    }
    for (const int mesh : meshes)
      for (const double step : steps) {
        scene::Scene scene = base;
        scene.model.rung = *rung;
        scene.model.mesh = mesh;
        scene.model.step = 1e-3 * step;
        const std::string with_step = options.varies(StudyAxis::step) ? fmt::format("-{:g}ms", step) : "";
        add(fmt::format("{}-mesh{}{}", word(*rung), mesh, with_step), scene, false);
      }
  }
  return jobs;
}

/// The reduced model is done in a moment; the others are left for the runner.
std::vector<Job> without_reduced(const std::vector<Job> &jobs, Console &console) {
  std::vector<Job> left;
  for (const auto &job : jobs) {
    if (!job.reduced) {
      left.push_back(job);
      continue;
    }
    auto run = reduced::simulate(job.scene);
    write_run_folder(job.folder, job.scene, std::move(run.response), run.summary);
    if (run.summary.status == RunStatus::stopped)
      console.warn(fmt::format("{} stopped and is not in the table: {}", job.name, run.summary.reason));
  }
  return left;
}

std::vector<calibration::StudyRun> runs_of(const std::vector<Job> &jobs, Console &console) {
  std::vector<calibration::StudyRun> runs;
  for (const auto &job : jobs) {
    if (!is_done(job)) continue;
    try {
      runs.push_back(calibration::study_run(job.name, summary_of(job.folder), read_response(job.folder)));
      auto &run = runs.back();
      if (job.reduced) {
        run.element = scene::element_line(job.scene), run.on_curve = job.scene.reduced.impact_law->pushed;
        continue;
      }
      run.rung = solved_by(job.scene.model.rung); // as asked for, whatever wrote the summary
      run.mesh = job.scene.model.mesh;
      run.step = job.scene.model.step;
    } catch (const DataError &error) {
      console.warn(error.what());
    }
  }
  return runs;
}

void write(const calibration::SpeedError &study, const scene::Scene &base, const std::string &folder,
           Console &console) {
  auto json = calibration::to_json(study);
  std::optional<double> approach_speed;
  const auto reference =
      std::find_if(study.rows.begin(), study.rows.end(), [](const auto &row) { return row.reference; });
  if (reference != study.rows.end())
    if (const auto impacts = summary_of(folder + "/runs/" + reference->run.name)["impacts"]; !impacts.empty())
      approach_speed = impacts[0]["approach_speed_m_s"].get<double>();
  json["command"] = console.command();
  json["made_by"] = build_version();
  json["scene"] = calibration::studied_scene(base, approach_speed);
  json["load"] = scene::case_json(base)["load"];
  json["warnings"] = console.warnings();
  write_atomically(json_text(json), folder + "/study.json");
  write_atomically(calibration::to_csv(study), folder + "/study.csv");
  const std::string text = scene::load_sentence(base) + calibration::describe(study);
  write_atomically(text, folder + "/study.txt");
  console.data(console.json ? json_text(json) : text);
  if (python({"report.quick", "study", folder}) != 0) console.warn("the picture in " + folder + " was not made");
}

/// Keys that vary have the values of the study's own options.
void refuse_axes_set(const StudyOptions &options, const Console &console) {
  refuse_unread(console.overrides, "study", [&](const std::string &key) -> std::string {
    if (key == "model.rung" && options.varies(StudyAxis::rung)) return "it is an axis: --rungs";
    if (key == "model.mesh" && options.varies(StudyAxis::mesh)) return "it is an axis: --meshes";
    if (key == "model.step_ms" && options.varies(StudyAxis::step)) return "it is an axis: --steps";
    return "";
  });
}

/// Values of an axis that does not vary would be read by nothing.
void refuse_values_unread(const StudyOptions &options, const CLI::App &verb) {
  for (const auto &[name, axis] : {std::pair{"--rungs", StudyAxis::rung}, std::pair{"--meshes", StudyAxis::mesh},
                                   std::pair{"--steps", StudyAxis::step}})
    if (verb.get_option(name)->count() > 0 && !options.varies(axis))
      throw InputError(fmt::format("{}: {} is not among --axes {}", name, word(axis), fmt::join(options.axes, ",")));
}

/// What would run, and how long it takes, one after the other.
void print_study(const std::vector<Job> &jobs, const std::string &folder, const Console &console) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  std::string text = fmt::format("{:28s} {}\n", "run", "expected");
  double in_all = 0;
  for (const auto &job : jobs) {
    constexpr double reduced = 0.01; // [s]
    const double seconds = job.reduced ? reduced : expected_times({job}).front().expected;
    in_all += seconds;
    rows.push_back({{"name", job.name}, {"expected_seconds", seconds}});
    text += fmt::format("{:28s} {}\n", job.name, about(seconds));
  }
  text += fmt::format("{} runs, {} in all, one after the other; {}\n", jobs.size(), about(in_all), folder);
  console.data(console.json ? json_text(nlohmann::ordered_json{{"runs", rows}, {"expected_seconds", in_all}}) : text);
}

/// Throws InputError for axes and values that are none.
void check_axes(const StudyOptions &options, const CLI::App &verb) {
  for (const auto &axis : options.axes)
    if (!parse<StudyAxis>(axis)) throw InputError("--axes " + axis + ": must be of rung, mesh, step");
  for (const double step : options.steps)
    if (!std::isfinite(step)) throw InputError(fmt::format("--steps {}: must be a length in ms", step));
  const auto twice = [](auto values) {
    std::sort(values.begin(), values.end());
    return std::adjacent_find(values.begin(), values.end()) != values.end();
  };
  if (twice(options.axes) || twice(options.rungs) || twice(options.meshes) || twice(options.steps))
    throw InputError("--axes, --rungs, --meshes and --steps: each value once, a run would be compared with itself");
  refuse_values_unread(options, verb);
}

void run_study(StudyOptions options, const CLI::App &verb, Console &console) {
  check_axes(options, verb);
  const auto [part, n_parts] = parse_shard(options.shard);
  const scene::Scene base = console.load(options.scene);
  require_bearing_under_rigid_mass(base, "study");
  refuse_axes_set(options, console);
  if (base.model.own_mesh.any() && options.varies(StudyAxis::mesh) && options.meshes.size() > 1)
    throw InputError("--axes mesh: the scene has a mesh of its own (" + base.model.own_mesh.file +
                     "), which is the same on every level; leave mesh out");
  if (options.folder.empty()) options.folder = default_folder("study-" + base.name);
  if (!options.curve.empty() && !(options.varies(StudyAxis::rung) && has_reduced(options)))
    throw InputError("--curve: it is flown by the reduced model, which is not among --rungs");
  if (options.slurm > 0)
    return write_slurm({.shards = options.slurm, .folder = options.folder, .has_threads = false}, console);
  const std::vector<Job> jobs = study_jobs(options, base);
  if (options.dry_run) return print_study(shard_of(jobs, part, n_parts), options.folder, console);
  const auto lock = claim_for_jobs(options.folder, Collection::study, jobs, console.force, part_name(part, n_parts));
  make_runs_folder(options.folder);
  std::vector<Job> own = without_reduced(shard_of(jobs, part, n_parts), console);
  if (!own.empty()) {
    JobRunner runner(own, console);
    watch_interrupts();
    runner.run();
  }
  const auto runs = runs_of(jobs, console);
  if (runs.size() < 2 && n_parts > 1) {
    console.message(fmt::format("{} of {} runs are done; the other shards make the table", runs.size(), jobs.size()));
    return;
  }
  const auto study = calibration::speed_against_error(runs, base.lateral_capacity(), options.wanted / 100);
  write(study, base, options.folder, console);
  require_done(own);
  if (study.recommended.empty())
    throw GateError(fmt::format("no setting of this study has an error of {:g} % or less", options.wanted));
}

void add_study(CLI::App &verb, Console &console) {
  auto options = std::make_shared<StudyOptions>();
  verb.add_option("SCENE", options->scene, "a TOML file or a built-in scene")->required();
  verb.add_option("-o,--output", options->folder, "results folder (default results/study-SCENE)");
  verb.add_option("--axes", options->axes, "what varies, of rung,mesh,step; the rest is the scene's")
      ->delimiter(',')
      ->capture_default_str();
  verb.add_option("--rungs", options->rungs, "values of the axis rung")
      ->delimiter(',')
      ->check(CLI::IsMember(words<SolvedBy>()))
      ->capture_default_str();
  verb.add_option("--curve", options->curve,
                  "curve.h5 of `rimpact curve`: the reduced model flies on it too, as run `curve`")
      ->check(CLI::ExistingFile);
  verb.add_option("--meshes", options->meshes, "values of the axis mesh")
      ->delimiter(',')
      ->check(CLI::Range(0, 3))
      ->capture_default_str();
  verb.add_option("--steps", options->steps, "values of the axis step [ms]")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb.add_option("--error", options->wanted, "wanted error [%], for the recommendation")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb.add_option("--shard", options->shard, "I/N: every N-th run from the I-th on, with the same -o");
  add_slurm(verb, options->slurm);
  verb.add_flag("--dry-run", options->dry_run, "list the runs and the time they take, and stop");
  console.add_common(verb);
  console.add_json(verb);
  console.add_overrides(verb);
  console.add_force(verb);
  verb.callback([options, &verb, &console] { run_study(*options, verb, console); });
}

} // namespace

const Verb study_verb{
    {.name = "study",
     .help = "speed against error of a scene: rungs, meshes, steps",
     .examples = "rimpact study impact-window --axes rung,mesh -o my-study\nrimpact study impact-window --shard 1/4",
     .next = "rimpact report {}"},
    add_study};

} // namespace rimpact::app
