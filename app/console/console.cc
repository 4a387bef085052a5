#include "app/console/console.h"

#include "io/files/file.h"
#include "io/files/key_list.h"
#include "io/files/text.h"
#include "responses/choices.h"
#include "scene/case_description.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include "scene/names.h"
#include "scene/script_permission.h"
#include "scene/toml_writer.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace rimpact::app {
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
  const auto take = [&](const std::string &section, const std::string &given) {
    if (!given.empty())
      all.push_back(section +
                    ".calibration=" + toml_quoted(std::filesystem::absolute(given).lexically_normal().string()));
  };
  take(scene::reduced_section, calibration), take(scene::inner_rims_section, inner_calibration);
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

void Console::report_first_run(scene::Scene scene) {
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
  verb.add_option("--inner-calibration", inner_calibration,
                  "folder of a calibration: the law of a triple pendulum's inner rims (reduced.model tfp)")
      ->type_name("DIR");
}

void Console::add_model(CLI::App &verb) {
  verb.add_option("--rung", rung, "rim | rigid-dish | full");
  verb.add_option("--mesh", mesh, "1 | 2 | 3; 0: a draft")->check(CLI::Range(0, 3));
}

void Console::add_force(CLI::App &verb) {
  verb.add_flag("--force", force, "replace what the output folder holds, whatever it is of");
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

} // namespace rimpact::app
