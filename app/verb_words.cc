#include "app/verb_words.h"

#include <array>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

/// `next`: a command to go on with, {} the folder that was made, which is `usual` where none is named.
struct Words {
  const char *verb, *examples, *next, *usual = "";
};
constexpr std::array words{
    Words{"main",
          "rimpact main\n"
          "rimpact main my-case -o my-case/main --title \"Rim impact\"\n"
          "rimpact main my-case/bearing.toml --set load.vertical_kN=2000 --dry-run",
          "rimpact export {}/calibration --opensees --csv", "results/main"},
    Words{"new", "rimpact new my-case\nrimpact new my-case --scene impact-window", ""},
    Words{"check", "rimpact check my-case/scene.toml\nrimpact check ricker-0.78g-1.0s --rung rigid-dish --json",
          "rimpact reduced SCENE (milliseconds), then rimpact run SCENE"},
    Words{"motion", "rimpact motion record.AT2\nrimpact motion x.AT2 y.AT2 --json\nrimpact motion my-records",
          "rimpact reduced SCENE --set excitation.kind=record --set excitation.x=FILE"},
    Words{"design", "rimpact design --sm1-g 0.87 --mu 0.07 --gamma 0.75 --Ts-s 0.5 --weight-kN 853",
          "rimpact new DIR, then a history: rimpact reduced DIR/scene.toml"},
    Words{"reduced",
          "rimpact reduced ricker-0.78g-1.0s --set excitation.scale=1.05 -o my-run --png\n"
          "rimpact reduced my-case/scene.toml --calibration my-case/main/calibration\n"
          "rimpact reduced my-case/scene.toml --sweep excitation.scale=0.8:1.2:9 -o my-sweep",
          "rimpact report {}"},
    Words{"reduced --sweep", "", "rimpact.load_fleet(FOLDER) in Python reads its table.csv"},
    Words{"building", "rimpact building pulse-bidirectional -o my-building", "rimpact report {}"},
    Words{"run",
          "rimpact run impact-window --mesh 0 -o my-run\n"
          "rimpact run my-case/scene.toml --rung rigid-dish --dry-run\n"
          "rimpact run my-case/scene.toml -o my-run --resume",
          "rimpact report {}"},
    Words{"mesh", "rimpact mesh shfps-225 -o bearing.msh --png\nrimpact mesh my-case/bearing.toml --mesh 2 -o fine.msh",
          "gmsh FILE shows it; rimpact run SCENE makes its own"},
    Words{"curve", "rimpact curve my-case/bearing.toml -o my-curve --mass-kg 203900",
          "rimpact reduced SCENE --set reduced.impact_law=curve --set reduced.impact_curve={}/curve.h5"},
    Words{"calibrate",
          "rimpact calibrate runs/window-*/ -o my-calibration\n"
          "rimpact calibrate test-07.toml --law elastoplastic --sigma force=0.02",
          "rimpact reduced SCENE --calibration {}", "results/calibration"},
    Words{"compare",
          "rimpact compare my-run my-reduced\nrimpact compare my-run test-07.toml --json\n"
          "rimpact compare reference my-run --max peak=5,rebound=10,time_ms=2 --junit compare.xml",
          "rimpact report DIR draws one of them"},
    Words{"geometry",
          "rimpact geometry my-case --vary rim.thickness_mm=20:80 --at speed=0.8 --target peak_kN=4000\n"
          "rimpact geometry my-case/bearing.toml --samples 40 --range speed=0.1:0.6 -o my-study",
          "rimpact report {}"},
    Words{"design-page", "rimpact design-page results/geometry", "open the page that is named above in a browser"},
    Words{"study", "rimpact study impact-window --axes rung,mesh -o my-study\nrimpact study impact-window --shard 1/4",
          "rimpact report {}"},
    Words{"report", "rimpact report my-run\nrimpact report results/main --pdf",
          "open the page that is named above in a browser"},
    Words{"export", "rimpact export results/main/calibration --opensees --csv -o for-opensees",
          "check the first analysis against the self-check's table"},
    Words{"list", "rimpact list\nrimpact list keys\nrimpact list laws --json", "rimpact new DIR"},
    Words{"reliability", "rimpact reliability my-study", "rimpact report {}"},
    Words{"references", "rimpact references --list\nrimpact references window-0.20 pulse-0.78g-1.05 -o again",
          "rimpact calibrate {}/window-*", "results/references"},
    Words{"thesis", "rimpact thesis list\nrimpact thesis headlines\nrimpact thesis fig-2-7", ""},
    Words{"help", "rimpact help\nrimpact help calibrate", ""},
    Words{"version", "rimpact version\nrimpact version --json", ""},
    Words{"completion", "rimpact completion bash > ~/.local/share/bash-completion/completions/rimpact", ""}};

constexpr const char *codes =
    "Exit codes: 0 done; 1 a bug; 2 command line or TOML; 3 a data file; 4 the solver stopped; 5 a gate not met; 6 "
    "reading or writing failed; 130 interrupted";

std::string &remembered() {
  static std::string folder;
  return folder;
}

const Words *words_of(const std::string &verb) {
  for (const auto &each : words)
    if (verb == each.verb) return &each;
  return nullptr;
}

} // namespace

void add_words(CLI::App &app) {
  for (auto *verb : app.get_subcommands([](const CLI::App *) { return true; })) {
    std::string footer;
    if (const auto *own = words_of(verb->get_name())) {
      footer = "Examples:\n  ";
      for (const char *c = own->examples; *c; ++c) footer += *c == '\n' ? "\n  " : std::string(1, *c);
      footer += "\n\n";
    }
    verb->footer(footer + codes);
  }
  app.footer(
      fmt::format("rimpact help VERB, or rimpact VERB --help: a verb's options, examples and exit codes\n{}", codes));
}

void remember_folder(const std::string &folder) {
  remembered() = folder;
}

std::string next_step(const std::string &verb, const std::string &named) {
  const auto *own = words_of(verb);
  if (!own) return {};
  std::string text = own->next;
  const auto place = text.find("{}");
  if (place == std::string::npos) return text;
  const std::string folder = !remembered().empty() ? remembered() : !named.empty() ? named : own->usual;
  return folder.empty() ? "" : text.replace(place, 2, folder);
}

} // namespace rimpact::app
