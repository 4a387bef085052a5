/// A verb of the command line: a function that adds its subcommand. One line each in catalogue.cc or
/// main_fe.cc.
#pragma once
#include "app/console.h"
#include <CLI/CLI.hpp>

namespace rimpact::app {

/// The callback set on the subcommand does the work; errors leave as rimpact::Error.
using AddVerb = void (*)(CLI::App &app, Console &console);
struct Verb {
  const char *name;
  AddVerb add;
};

void add_calibrate(CLI::App &app, Console &console);
void add_check(CLI::App &app, Console &console);
void add_compare(CLI::App &app, Console &console);
void add_curve(CLI::App &app, Console &console);
void add_building(CLI::App &app, Console &console);
void add_design(CLI::App &app, Console &console);
void add_design_page(CLI::App &app, Console &console);
void add_export(CLI::App &app, Console &console);
void add_geometry(CLI::App &app, Console &console);
void add_help(CLI::App &app, Console &console);
void add_list(CLI::App &app, Console &console);
void add_main(CLI::App &app, Console &console);
void add_mesh(CLI::App &app, Console &console);
void add_motion(CLI::App &app, Console &console);
void add_new(CLI::App &app, Console &console);
void add_reduced(CLI::App &app, Console &console);
void add_reliability(CLI::App &app, Console &console);
void add_references(CLI::App &app, Console &console);
void add_report(CLI::App &app, Console &console);
void add_run(CLI::App &app, Console &console);
void add_study(CLI::App &app, Console &console);
void add_thesis(CLI::App &app, Console &console);
void add_version(CLI::App &app, Console &console);

/// Parses, runs the verb, turns every failure into one sentence and its exit code.
int run_command(int argc, char **argv, const std::vector<Verb> &verbs);

} // namespace rimpact::app
