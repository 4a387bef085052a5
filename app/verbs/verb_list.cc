// rimpact list: what there is to choose from, and what keys, signals, columns, files and exit codes mean.
#include "app/verbs/catalogue.h"
#include "app/words/file_keys.h"
#include "app/words/result_catalogue.h"
#include "io/files/json_text.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/catalogue.h"
#include "scene/bearing_catalogue.h"
#include "scene/isolator_catalogue.h"
#include "scene/scene.h"
#include "scene/steel_grades.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace rimpact::app {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

Entries bearings() {
  Entries result;
  for (const auto &name : scene::builtin_bearing_names()) {
    const auto b = scene::builtin_bearing(name);
    const double curvature = scene::make_surface(b.surface)->curvatures(0).meridional;
    result.emplace_back(name, fmt::format("{}{} surface, R0 {:.3g} m, L_c {:.0f} mm",
                                          b.has_interface()    ? "two dishes face to face, a slider of two halves, "
                                          : b.double_concave() ? "two dishes face to face, "
                                                               : "",
                                          word(b.surface.kind), 1 / curvature, 1e3 * b.lateral_capacity()));
  }
  for (const auto &name : scene::builtin_isolator_names()) {
    const auto b = scene::builtin_isolator(name);
    result.emplace_back(name, fmt::format("isolator.name of a triple pendulum, R_eff {:.3g} m, L_c {:.0f} mm; {}",
                                          b.effective_radius(), 1e3 * scene::triple_capacity(b),
                                          scene::isolator_source(name)));
  }
  return result;
}
/// First sentence of the comment a scene's text begins with ("Fig. 2-7" does not end it).
std::string first_sentence(const std::string &text) {
  std::string sentence, line;
  for (std::istringstream lines(text); std::getline(lines, line) && line.rfind("# ", 0) == 0;) {
    if (!sentence.empty()) sentence += ' ';
    sentence.append(line, 2);
  }
  for (std::size_t end = 0; (end = sentence.find(". ", end)) != std::string::npos; ++end)
    if (!std::isdigit(static_cast<unsigned char>(sentence[end + 2]))) return sentence.substr(0, end + 1);
  return sentence;
}
Entries scenes() {
  Entries result;
  for (const auto &name : scene::builtin_scene_names())
    result.emplace_back(name, first_sentence(scene::builtin_scene_text(name)));
  return result;
}
Entries models() {
  Entries result;
  for (const auto &model : reduced::reduced_models()) result.emplace_back(word(model.kind), model.description);
  return result;
}
Entries laws() {
  Entries result;
  for (const auto *law : laws::impact_laws()) result.emplace_back(law->name, law->description);
  return result;
}
/// "355 up to 16 mm, 345 up to 40 mm", or the one value.
std::string in_words(const scene::GradeNumber &number) {
  if (number.by_thickness.empty()) return fmt::format("{:g}", number.value);
  std::string text;
  for (const auto &[thickness, value] : number.by_thickness)
    text += fmt::format("{}{:g} up to {:g} mm", text.empty() ? "" : ", ", value, 1e3 * thickness);
  return text;
}

/// A grade in a line, with the numbers that nobody has checked.
std::string summary(const scene::SteelGrade &grade) {
  std::vector<std::string> unchecked;
  for (const auto &[key, number] : grade.numbers)
    if (!number.checked) unchecked.push_back(key);
  return fmt::format("{}: in MPa, yield {}, ultimate {}; {}", grade.title, in_words(*grade.find("yield_MPa")),
                     in_words(*grade.find("ultimate_MPa")),
                     unchecked.empty() ? "all checked" : fmt::format("unchecked: {}", fmt::join(unchecked, ", ")));
}

/// Every number of the grades.
Entries steels() {
  Entries result;
  for (const auto &grade : scene::steel_grades())
    for (const auto &[key, number] : grade.numbers)
      result.emplace_back(grade.name + " " + key,
                          fmt::format("{}; {}; scatter: {}; {}", in_words(number), number.source, number.scatter,
                                      number.checked ? "checked" : "unchecked"));
  return result;
}

Entries materials() {
  Entries result;
  const scene::Bearing b;
  for (const auto &[name, m] : {std::pair{"steel", b.steel}, {"ertalyte", b.ertalyte}})
    result.emplace_back(name, fmt::format("E {:.0f} MPa, nu {:.2f}, {}, {:.0f} kg/m3", 1e-6 * m.E, m.nu,
                                          m.yield ? fmt::format("yield {:.0f} MPa, tangent {:.0f} MPa", 1e-6 * *m.yield,
                                                                1e-6 * m.tangent_modulus.value_or(0))
                                                  : std::string("elastic"),
                                          m.density));
  for (const auto &grade : scene::steel_grades()) result.emplace_back(grade.name, summary(grade));
  return result;
}

Entries rungs() {
  return {{"reduced", "nothing deforms; a mass on the dish and a law of the rim, milliseconds (rimpact reduced)"},
          {"rim", "rim, the plate below it and the slider deform where they meet, half a minute (rimpact run)"},
          {"rigid-dish", "pad and foot too, or a slider between two dishes, on the exact rigid dish, minutes"},
          {"full", "everything, the plate with its dish too, up to twice as long"}};
}

nlohmann::ordered_json json_of(const std::vector<KeyDescription> &keys) {
  nlohmann::ordered_json list = nlohmann::json::array();
  for (const auto &key : keys)
    list.push_back({{"key", key.path},
                    {"kind", key.kind},
                    {"unit", key.unit},
                    {"default", key.preset},
                    {"range", key.range},
                    {"meaning", key.meaning},
                    {"assumption", key.assumption},
                    {"when", key.condition}});
  return list;
}

void print_keys(const Console &console) {
  if (console.json) {
    nlohmann::ordered_json all{{"keys", json_of(scene_keys())}};
    for (const auto &group : file_keys()) {
      all[group.name] = json_of(group.keys);
      all["files"].push_back({{"keys", group.name}, {"title", group.title}, {"note", group.note}});
    }
    return console.data(json_text(all));
  }
  const auto print = [&](const std::string &title, const std::vector<KeyDescription> &keys) {
    console.data(title + "\n");
    for (const auto &key : keys)
      console.data(fmt::format("  {:38s} {:10s} {}{}\n", key.path, key.preset.substr(0, 40), key.meaning,
                               key.condition.empty() ? "" : " (" + key.condition + ")"));
  };
  print("scenes (in a bearing file without \"bearing.\")", scene_keys());
  for (const auto &group : file_keys()) print("\n" + group.title, group.keys);
}

struct Kind {
  std::string name;
  Entries (*entries)();
  bool is_short; ///< listed where no kind is named
};
const std::vector<Kind> &kinds() {
  static const std::vector<Kind> all{
      {"bearings", bearings, true}, {"scenes", scenes, true},         {"models", models, true},
      {"laws", laws, true},         {"materials", materials, true},   {"rungs", rungs, true},
      {"steels", steels, false},    {"signals", signals, false},      {"columns", columns, false},
      {"files", files, false},      {"exit-codes", exit_codes, false}};
  return all;
}

void add_list(CLI::App &verb, Console &console) {
  auto what = std::make_shared<std::string>();
  std::vector<std::string> names{"keys"};
  for (const auto &kind : kinds()) names.push_back(kind.name);
  verb.add_option("WHAT", *what, "one of them; without, the first six")->check(CLI::IsMember(names));
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([what, &console] {
    if (*what == "keys") return print_keys(console);
    nlohmann::ordered_json all;
    for (const auto &kind : kinds()) {
      if (what->empty() ? !kind.is_short : *what != kind.name) continue;
      if (!console.json) console.data(kind.name + "\n");
      for (const auto &[name, text] : kind.entries()) {
        all[kind.name][name] = text;
        if (!console.json) console.data(fmt::format("  {:24s} {}\n", name, text));
      }
    }
    if (console.json) console.data(json_text(all));
  });
}

} // namespace

const Verb list_verb{
    {.name = "list",
     .help = "bearings, scenes, models, laws, materials, rungs; keys, steels, signals, columns, files, exit-codes",
     .examples = "rimpact list\nrimpact list keys\nrimpact list laws --json",
     .next = "rimpact new DIR"},
    add_list};

} // namespace rimpact::app
