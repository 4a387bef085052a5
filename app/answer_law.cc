#include "app/answer_law.h"

#include "app/toml_values.h"
#include "scene/error.h"
#include "scene/files.h"
#include <fmt/format.h>

namespace rimpact::app {
namespace {

using nlohmann::json;

/// Parts of the record, absent or null alike: empty.
std::string sentence_of(const json &record, const char *key) {
  const auto found = record.find(key);
  if (found == record.end()) return {};
  if (found->is_string()) return *found;
  return found->is_object() ? found->value("sentence", "") : "";
}

std::string parameters_text(const json &parameters) {
  std::string text;
  for (const auto &[name, p] : parameters.items()) {
    text += fmt::format("  {:<13} {:>12.5g} {:<6}", name, p.value("value", 0.0), p.value("unit", ""));
    const json interval = p.value("interval_95", json());
    if (interval.is_array() && interval.size() == 2 && interval[0].is_number() && interval[1].is_number())
      text += fmt::format(" 95 %: {:.5g} .. {:.5g}", interval[0].get<double>(), interval[1].get<double>());
    if (!p.value("identifiable", true)) text += "  not identifiable";
    text += "\n";
  }
  return text;
}

} // namespace

scene::Scene with_answer(const scene::Scene &scene, const std::string &folder) {
  const std::string path = folder + "/calibration.toml";
  auto values = flattened(scene::TomlFile(scene::to_toml(scene), scene.name));
  for (const auto &[key, value] : flattened(scene::TomlFile(scene::read_file(path), path)))
    if (key.rfind("reduced.", 0) == 0) values[key] = value;
  std::string text;
  for (const auto &[key, value] : values) text += key + " = " + value + "\n";
  return scene::parse_scene(text, path);
}

scene::Scene with_pair(scene::Scene scene, const json &answer) {
  const json &pair = answer.at("pair");
  scene.reduced.impact_law = pair.at("law");
  scene.reduced.k_i = 1e3 * pair.at("k_i_kN_per_m").get<double>();
  scene.reduced.restitution = pair.at("e");
  return scene;
}

std::string answer_text(const json &answer) {
  if (!answer.is_object()) return {};
  const json law = answer.value("law", json::object());
  std::string text = fmt::format("the answer: law {}\n", law.value("name", "?")) + parameters_text(law.value("parameters", json::object()));
  const auto add = [&text](const std::string &sentence) {
    if (!sentence.empty()) text += "  " + sentence + "\n";
  };
  add(sentence_of(law, "sentence"));
  add(sentence_of(law, "remark"));
  add(sentence_of(answer, "pair"));
  add(sentence_of(answer, "no_pair"));
  add(sentence_of(answer, "strain"));
  add(sentence_of(answer, "mesh_error"));
  for (const auto &doubt : answer.value("doubts", json::array()))
    if (doubt.is_string()) add("doubt: " + doubt.get<std::string>());
  return text;
}

} // namespace rimpact::app
