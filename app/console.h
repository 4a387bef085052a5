/// What verbs share: data to stdout, messages to stderr and to log.txt, options every verb has.
#pragma once
#include "scene/error.h"
#include <atomic>
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace rimpact::app {

class Console {
public:
  bool quiet = false, verbose = false, json = false;
  std::vector<std::string> overrides; ///< --set

  void message(const std::string &sentence); ///< stderr, unless --quiet; kept for log.txt
  void detail(const std::string &sentence);  ///< only with --verbose; kept for log.txt
  void warn(const std::string &sentence);    ///< stderr even with --quiet; kept
  void data(const std::string &text) const;  ///< stdout
  const std::string &log() const { return log_; }

  void add_common(CLI::App &verb);    ///< --quiet, --verbose
  void add_json(CLI::App &verb);      ///< --json
  void add_overrides(CLI::App &verb); ///< --set KEY=VALUE

private:
  std::string log_;
};

/// Set by Ctrl-C and SIGTERM; a second Ctrl-C ends the process at once.
const std::atomic<bool> &interrupted();
void catch_interrupts();
/// Colours and rewritten lines: a terminal, and NO_COLOR not set.
bool fancy_terminal();
/// Name of a run's default folder: results/<scene>.
std::string default_folder(const std::string &scene_name);

} // namespace rimpact::app
