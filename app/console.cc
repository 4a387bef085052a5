#include "app/console.h"

#include "app/verb.h"
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <unistd.h>

namespace rimpact::app {
namespace {

std::atomic<bool> interrupt_flag{false};

void on_interrupt(int) {
  if (interrupt_flag) _exit(static_cast<int>(ExitCode::interrupted));
  interrupt_flag = true;
}

} // namespace

void Console::message(const std::string &sentence) {
  log_ += sentence + "\n";
  if (!quiet) fmt::print(stderr, "{}\n", sentence);
}

void Console::detail(const std::string &sentence) {
  log_ += sentence + "\n";
  if (verbose) fmt::print(stderr, "{}\n", sentence);
}

void Console::warn(const std::string &sentence) {
  log_ += "warning: " + sentence + "\n";
  fmt::print(stderr, "{}warning:{} {}\n", fancy_terminal() ? "\033[33m" : "",
             fancy_terminal() ? "\033[0m" : "", sentence);
}

void Console::data(const std::string &text) const {
  fmt::print("{}", text);
  if (std::fflush(stdout) != 0) throw IoError("cannot write to standard output");
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
}

const std::atomic<bool> &interrupted() {
  return interrupt_flag;
}

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

bool fancy_terminal() {
  return isatty(STDERR_FILENO) && !std::getenv("NO_COLOR");
}

std::string default_folder(const std::string &scene_name) {
  return "results/" + scene_name;
}

int run_command(int argc, char **argv, const std::vector<Verb> &verbs) {
  CLI::App app{"rimpact: finite-element reference curves of friction-pendulum bearings that hit their rim,\n"
               "calibrated impact parameters, and how far each model is from the reference."};
  app.name("rimpact");
  app.require_subcommand(1);
  Console console;
  for (const auto &verb : verbs) verb.add(app, console);
  const auto fail = [](const std::string &sentence, int code) {
    fmt::print(stderr, "{}error:{} {}\n", fancy_terminal() ? "\033[31m" : "",
               fancy_terminal() ? "\033[0m" : "", sentence);
    return code;
  };
  try {
    catch_interrupts();
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::CallForHelp &help) {
    return app.exit(help);
  } catch (const CLI::ParseError &error) {
    return fail(std::string(error.what()) + " (see rimpact --help)", static_cast<int>(ExitCode::input));
  } catch (const Error &error) {
    return fail(error.what(), static_cast<int>(error.code()));
  } catch (const std::bad_alloc &) {
    return fail("out of memory; a coarser mesh (--mesh 1) needs less", static_cast<int>(ExitCode::stopped));
  } catch (const std::exception &error) {
    return fail(std::string("a bug in rimpact, please report it: ") + error.what(),
                static_cast<int>(ExitCode::bug));
  }
}

} // namespace rimpact::app
