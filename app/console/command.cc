#include "app/console/command.h"

#include "app/console/help_format.h"
#include "app/console/interrupts.h"
#include "io/files/text.h"
#include "scene/names.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rimpact::app {
namespace {

constexpr const char *codes =
    "Exit codes: 0 done; 1 a bug; 2 command line or TOML; 3 a data file; 4 the solver stopped; 5 a gate not met; 6 "
    "reading or writing failed; 130 interrupted";

/// Its options, and as footer its examples and the exit codes.
void add_verb(CLI::App &app, const Verb &verb, Console &console) {
  CLI::App &added = *app.add_subcommand(verb.text.name, verb.text.help);
  std::string footer;
  for (const auto &line : split(verb.text.examples, '\n'))
    if (!line.empty()) footer += (footer.empty() ? "Examples:\n  " : "\n  ") + std::string(line);
  added.footer(footer + (footer.empty() ? "" : "\n\n") + codes);
  if (verb.add) verb.add(added, console);
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
    return fmt::format("verb {} (see rimpact --help)", unknown_word(argv[1], verbs));
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
void tell_next(const CLI::App &verb, std::span<const Verb *const> verbs, const Console &console) {
  if (console.quiet || console.json) return;
  const auto given = [&verb](const char *name) {
    const auto *option = verb.get_option_no_throw(name);
    return option && option->count() > 0 ? option->results().front() : std::string();
  };
  const auto is_it = [&verb](const Verb *each) { return verb.get_name() == each->text.name; };
  const VerbText &text = (*std::ranges::find_if(verbs, is_it))->text;
  std::string next = given("--sweep").empty() ? text.next : text.next_of_sweep;
  if (const auto place = next.find("{}"); place != std::string::npos) {
    const std::string named = given("--output"), folder = !console.made_folder.empty() ? console.made_folder
                                                          : !named.empty()             ? named
                                                                                       : text.usual;
    if (folder.empty()) return;
    next.replace(place, 2, folder);
  }
  if (!next.empty()) say("next: " + scene::printable(next) + "\n");
}

} // namespace

int run_command(int argc, char **argv, std::span<const Verb *const> verbs) {
  CLI::App app{"rimpact: finite-element reference curves of friction-pendulum bearings that hit their rim,\n"
               "calibrated impact parameters, and how far each model is from the reference."};
  app.name("rimpact");
  app.formatter(std::make_shared<HelpFormat>());
  app.require_subcommand(1);
  app.set_version_flag("--version", "rimpact " RIMPACT_VERSION,
                       "this program's version; `version` names its libraries too");
  Console console;
  console.argc = argc, console.argv = argv;
  for (const Verb *verb : verbs) add_verb(app, *verb, console);
  app.footer(
      fmt::format("rimpact help VERB, or rimpact VERB --help: a verb's options, examples and exit codes\n{}", codes));
  open_standard_streams();
  catch_interrupts();
  try {
    app.parse(argc, argv);
    tell_next(*app.get_subcommands().front(), verbs, console);
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
