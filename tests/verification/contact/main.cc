// verify_contact CASE [--baseline FILE] [--write FILE]: runs one case, prints its table, compares with the stored
// baseline. Exit 1: a gate is missed or a value left the baseline by more than 1 %.
#include "table.h"

#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <petscsys.h>

using namespace rimpact::verification;

namespace {
const std::vector<Case> cases{
    {"rigid-bar", "1: a rigid bar rebounds with its own speed", rigid_bar},
    {"elastic-bars", "1, 2: elastic bars against a rigid wall", elastic_bars},
    {"signorini-bar", "2: Signorini's bar, exact", signorini_bar},
    {"taylor-bar", "3: Taylor's copper bar", taylor_bar},
    {"taylor-bar-rate", "3: Taylor's bar of copper that knows its rate", taylor_bar_rate},
    {"hertz-cylinder", "4: Hertz, cylinder", hertz_cylinder},
    {"hertz-sphere", "4: Hertz, sphere", hertz_sphere},
    {"mindlin-cylinder", "5: Cattaneo-Mindlin, cylinder", mindlin_cylinder},
    {"mindlin-sphere", "5: Cattaneo-Mindlin, sphere", mindlin_sphere},
    {"contact-patch", "6: patch test on an exact plane", contact_patch},
    {"incline", "7: a block on an incline", incline},
    {"ironing", "8: shallow ironing by an exact cylinder", ironing},
    {"thick-cylinder", "9: thick cylinder, first yield and collapse", thick_cylinder},
    {"cook-membrane", "9: Cook's membrane", cook_membrane},
    {"hertz-two-bodies", "4: Hertz, a cylinder and a half-space, both deformable", hertz_two_bodies},
    {"mindlin-two-bodies", "5: Cattaneo-Mindlin, a cylinder and a half-space, both deformable", mindlin_two_bodies},
    {"patch-two-bodies", "6: patch test, two bodies of non-matching cells", patch_two_bodies},
    {"ironing-two-bodies", "8: shallow ironing by a deformable die", ironing_two_bodies},
    {"hard-states", "states contact codes stumble over", hard_states},
};
} // namespace

int main(int argc, char **argv) {
  PetscInitialize(nullptr, nullptr, nullptr, nullptr);
  std::string name, baseline, written;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--baseline" && i + 1 < argc)
      baseline = argv[++i];
    else if (argument == "--write" && i + 1 < argc)
      written = argv[++i];
    else
      name = argument;
  }
  for (const auto &entry : cases) {
    if (entry.name != name) continue;
    const Table table = entry.run();
    const std::string text = "# " + entry.title + "\n" + table.text();
    fmt::print("{}", text);
    if (!written.empty()) std::ofstream(written) << text;
    std::vector<std::string> failures = table.failures();
    if (!baseline.empty()) {
      std::ifstream file(baseline);
      const std::string stored{std::istreambuf_iterator<char>(file), {}};
      for (const auto &line : table.differences(stored, 0.01)) failures.push_back(line);
    }
    for (const auto &line : failures) fmt::print("FAILED {}\n", line);
    return failures.empty() ? 0 : 1;
  }
  for (const auto &entry : cases) fmt::print("{:<20} {}\n", entry.name, entry.title);
  return name.empty() ? 0 : 2;
}
