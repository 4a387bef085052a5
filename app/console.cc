#include "app/console.h"

#include "app/help_format.h"
#include "app/verb.h"
#include "app/verb_words.h"
#include "files/file.h"
#include "files/key_list.h"
#include "files/text.h"
#include "responses/choices.h"
#include "scene/case_description.h"
#include "scene/doubts.h"
#include "scene/names.h"
#include "scene/script_permission.h"
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace rimpact::app {
namespace {

std::atomic<bool> interrupt_flag{false}, interrupts_watched{false};

void on_interrupt(int) {
  if (!interrupts_watched || interrupt_flag) _exit(static_cast<int>(ExitCode::interrupted));
  interrupt_flag = true;
}

/// SIGHUP too, unless the shell has it ignored (nohup): a closed terminal must not cost a run its last checkpoint.
/// SIGUSR1 is what mpirun passes on to its ranks, and what batch systems send before a job's time is up.
void catch_interrupts() {
  std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow fails to be written, with a sentence
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGHUP})
    if (std::signal(signal, on_interrupt) == SIG_IGN && signal == SIGHUP) std::signal(signal, SIG_IGN);
}

int fail(const std::string &sentence, ExitCode code) {
  say(fmt::format("{} {}\n", coloured("error:", "31"), scene::printable(sentence)));
  return static_cast<int>(code);
}

/// The sentence for a command line that does not parse, with the nearest known verb or option.
std::string explain(const CLI::App &app, const CLI::ParseError &error, int argc, char **argv) {
  const auto visible = [](const CLI::App *) { return true; };
  std::vector<std::string> verbs, options;
  const CLI::App *verb = nullptr;
  for (const auto *each : app.get_subcommands(visible)) {
    verbs.push_back(each->get_name());
    if (each->parsed()) verb = each;
  }
  if (!verb && argc > 1 && argv[1][0] != '-')
    return fmt::format("verb {} (see rimpact --help)", not_among(argv[1], verbs));
  const std::string help = verb ? fmt::format("rimpact {} --help", verb->get_name()) : "rimpact --help";
  if (verb && dynamic_cast<const CLI::ExtrasError *>(&error)) {
    for (const auto *option : verb->get_options())
      for (const auto &name : option->get_lnames()) options.push_back("--" + name);
    for (const auto &word : verb->remaining())
      if (const auto near = nearest(word, options); near && word[0] == '-')
        return fmt::format("{} is not an option of {}; did you mean {}? (see {})", word, verb->get_name(), *near, help);
  }
  return fmt::format("{} (see {})", error.what(), help);
}

/// One line on how to go on, to stderr: not for --quiet and not for programs, which ask for JSON.
void tell_next(const CLI::App &verb, const Console &console) {
  if (console.quiet || console.json) return;
  const auto given = [&verb](const char *name) {
    const auto *option = verb.get_option_no_throw(name);
    return option && option->count() > 0 ? option->results().front() : std::string();
  };
  const std::string next = next_step(verb.get_name() + (given("--sweep").empty() ? "" : " --sweep"), given("--output"));
  if (!next.empty()) say("next: " + scene::printable(next) + "\n");
}

} // namespace

void Console::message(const std::string &sentence) {
  log_ += sentence + "\n";
  if (!quiet) say(scene::printable(sentence) + "\n");
}

void Console::detail(const std::string &sentence) {
  log_ += sentence + "\n";
  if (verbose) say(scene::printable(sentence) + "\n");
}

void Console::warn(const std::string &sentence) {
  log_ += "warning: " + sentence + "\n";
  warnings_.push_back(sentence);
  say(fmt::format("{} {}\n", coloured("warning:", "33"), scene::printable(sentence)));
}

void Console::data(const std::string &given) const {
  const std::string text = scene::printable(given);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw IoError("cannot write to standard output");
}

std::string Console::command() const {
  std::string text = "rimpact";
  for (int i = 1; i < argc; ++i) text += std::string(" ") + argv[i];
  return text;
}

std::vector<std::string> Console::settings() const {
  std::vector<std::string> all;
  if (!calibration.empty())
    all.push_back("reduced.calibration=" +
                  toml_quoted(std::filesystem::absolute(calibration).lexically_normal().string()));
  all.insert(all.end(), overrides.begin(), overrides.end());
  if (parse<SolvedBy>(rung) == SolvedBy::reduced)
    throw InputError("--rung reduced: the reduced model is no finite-element rung (rim, rigid-dish, full); use rimpact "
                     "reduced SCENE");
  if (!rung.empty()) all.push_back("model.rung=" + toml_quoted(rung));
  if (mesh >= 0) all.push_back("model.mesh=" + std::to_string(mesh));
  return all;
}

scene::Scene Console::load(const std::string &given) {
  scene::Scene scene = scene::load_scene(given, settings());
  warn_of(scene);
  return scene;
}

void Console::warn_of(scene::Scene &scene) {
  if (load_is_shared) std::erase(scene.remarks, scene.load_remark);
  if (springs_are_read) std::erase(scene.remarks, scene.springs_remark);
  if (isolator_is_read) std::erase(scene.remarks, scene.isolator_remark);
  for (const auto &remark : scene.remarks) warn(remark);
  for (const auto &doubt : scene::doubts(scene, !load_is_shared)) warn(doubt);
}

void Console::tell_first_run(scene::Scene scene) {
  message("first run:\n" + scene::describe_case(scene, !load_is_shared));
  warn_of(scene);
  for (const auto &doubt : scene::doubts_of_element(scene)) warn(doubt);
}

void Console::add_common(CLI::App &verb) {
  verb.add_flag("--quiet", quiet, "only errors, warnings and data");
  verb.add_flag("--verbose", verbose, "more of what is happening");
}
void Console::add_json(CLI::App &verb) {
  verb.add_flag("--json", json, "print JSON instead of a table");
}
void Console::add_overrides(CLI::App &verb) {
  verb.add_option("--set", overrides, "override a key of the scene, e.g. excitation.scale=1.05 (repeatable)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb.add_flag_callback(
      "--allow-script", [] { setenv(scene::script_permission, "1", 1); },
      "let gmsh run a .geo mesh: it is a program; only from hands you trust");
  verb.add_option("--calibration", calibration, "folder of a calibration: the rim's law and numbers are taken from it")
      ->type_name("DIR");
}

void Console::add_model(CLI::App &verb) {
  verb.add_option("--rung", rung, "rim | rigid-dish | full");
  verb.add_option("--mesh", mesh, "1 | 2 | 3; 0: a draft")->check(CLI::Range(0, 3));
}

void Console::add_force(CLI::App &verb) {
  verb.add_flag("--force", force, "replace what the output folder holds, whatever it is of");
}

const std::atomic<bool> &interrupted() {
  return interrupt_flag;
}

void watch_interrupts() {
  interrupts_watched = true;
}

void say(const std::string &text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void open_standard_streams() {
  for (int descriptor = 0; descriptor <= STDERR_FILENO; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) < 0) return;
}

bool is_terminal() {
  return isatty(STDERR_FILENO);
}

std::string coloured(const char *text, const char *code) {
  const char *no_color = std::getenv("NO_COLOR");
  return is_terminal() && !(no_color && *no_color) ? fmt::format("\033[{}m{}\033[0m", code, text) : text;
}

std::string default_folder(const std::string &scene_name) {
  return "results/" + scene::folder_name(scene_name);
}

void keep_scene_file(const std::string &given, const scene::Scene &scene, const std::string &folder) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path written = fs::path(folder) / "scene.toml",
                 own = fs::is_directory(given, none) ? fs::path(given) / "scene.toml" : fs::path(given);
  if (!fs::equivalent(written, own, none)) return;
  if (read_file(own.string()) != scene::to_toml(scene)) // a run's own folder may be run again
    throw InputError("-o " + folder + " would replace the scene file " + own.string() +
                     " itself; choose another folder");
}

int run_command(int argc, char **argv, const std::vector<Verb> &verbs) {
  CLI::App app{"rimpact: finite-element reference curves of friction-pendulum bearings that hit their rim,\n"
               "calibrated impact parameters, and how far each model is from the reference."};
  app.name("rimpact");
  app.formatter(std::make_shared<HelpFormat>());
  app.require_subcommand(1);
  app.set_version_flag("--version", "rimpact " RIMPACT_VERSION,
                       "this program's version; `version` names its libraries too");
  Console console;
  console.argc = argc, console.argv = argv;
  for (const auto &verb : verbs) verb.add(app, console);
  add_words(app);
  open_standard_streams();
  catch_interrupts();
  try {
    app.parse(argc, argv);
    tell_next(*app.get_subcommands().front(), console);
    return 0;
  } catch (const CLI::Success &wanted) { // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError &error) {
    return fail(explain(app, error, argc, argv), ExitCode::input);
  } catch (const Error &error) {
    return fail(error.what(), error.code());
  } catch (const nlohmann::json::exception &error) {
    return fail(std::string("a kept result is damaged, a value in it is missing or of another type: ") + error.what(),
                ExitCode::data);
  } catch (const std::filesystem::filesystem_error &error) { // a folder that may not be made, say
    return fail(fmt::format("{}: {}", error.path1().string(), error.code().message()), ExitCode::io);
  } catch (const std::bad_alloc &) {
    return fail("out of memory; by finite elements a coarser mesh (a lower model.mesh) needs less, by the reduced "
                "model fewer instants (a larger reduced.output_step_ms)",
                ExitCode::stopped);
  } catch (const std::exception &error) {
    return fail(std::string("a bug in rimpact, please report it: ") + error.what(), ExitCode::bug);
  }
}

} // namespace rimpact::app
