/// What verbs share: data to stdout, messages to stderr and to log.txt, options every verb has.
#pragma once
#include "io/files/error.h"
#include "scene/scene.h"
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace rimpact::app {

class Console {
public:
  bool quiet = false, verbose = false, json = false, force = false;
  std::vector<std::string> overrides;                      ///< --set
  std::string calibration;                                 ///< --calibration: a folder; empty: the scene's own element
  std::string inner_calibration;                           ///< --inner-calibration: of a triple pendulum's inner rims
  std::string rung;                                        ///< --rung; empty: the scene's
  int mesh = -1;                                           ///< --mesh; negative: the scene's
  bool springs_are_read = false, isolator_is_read = false; ///< of [isolator] beside a dish, by a building
  bool load_is_shared = false; ///< a building's bearings carry shares of it: the scene's own load is not read
  int argc = 0;                ///< the command as it was given
  char **argv = nullptr;
  std::string made_folder; ///< of the results this process writes: where the next step finds them; empty: none

  void message(const std::string &sentence); ///< stderr, unless --quiet; kept for log.txt
  void detail(const std::string &sentence);  ///< only with --verbose; kept for log.txt
  void warn(const std::string &sentence);    ///< stderr even with --quiet; kept
  void data(const std::string &given) const; ///< stdout, printable
  const std::string &log() const { return log_; }
  const std::vector<std::string> &warnings() const { return warnings_; } ///< every sentence of warn()
  /// Every key the command line gives, in the order in which they win: --calibration, --inner-calibration, --set,
  /// --rung, --mesh.
  std::vector<std::string> settings() const;
  /// As it was given, without the program's folder.
  std::string command() const;
  /// The scene with its settings; warns of what it allows but doubts.
  scene::Scene load(const std::string &given);
  /// What the first of many runs is, and what to doubt of it.
  void report_first_run(scene::Scene scene);

  void add_common(CLI::App &verb);    ///< --quiet, --verbose
  void add_json(CLI::App &verb);      ///< --json
  void add_overrides(CLI::App &verb); ///< --set KEY=VALUE, --calibration DIR, --inner-calibration DIR, --allow-script
  void add_model(CLI::App &verb);     ///< --rung, --mesh
  void add_force(CLI::App &verb);     ///< --force

private:
  /// Its remarks and doubts; those of a load that is not read are left out, and the remark is taken away.
  void warn_of(scene::Scene &scene);
  std::string log_;
  std::vector<std::string> warnings_;
};

/// To stderr. That it cannot be written (a closed terminal) must not end a run.
void say(const std::string &text);
/// Closed ones become /dev/null: else the next file opened would get their number, and messages would be written into
/// it.
void open_standard_streams();
/// The progress line may be rewritten: stderr is a terminal.
bool is_terminal();
/// `text` in an ANSI colour, where stderr is a terminal and NO_COLOR is not set.
std::string coloured(const char *text, const char *code);
/// Name of a run's default folder: results/<scene>.
std::string default_folder(const std::string &scene_name);
/// Throws InputError where writing a run into `folder` would replace the user's own scene file.
void keep_scene_file(const std::string &given, const scene::Scene &scene, const std::string &folder);

} // namespace rimpact::app
