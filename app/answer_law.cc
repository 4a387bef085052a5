#include "app/answer_law.h"

#include "app/toml_values.h"
#include "scene/error.h"
#include "scene/files.h"
#include <fmt/format.h>

namespace rimpact::app {
namespace {

using nlohmann::json;

/// Parts of the record; what is absent or null is empty.
json part_of(const json &record, const char *key) {
  const auto found = record.is_object() ? record.find(key) : record.end();
  return record.is_object() && found != record.end() ? *found : json();
}
std::string text_of(const json &record, const char *key) {
  const json part = part_of(record, key);
  return part.is_string() ? part.get<std::string>() : "";
}
/// The part itself where it is a sentence, else its key `sentence`.
std::string sentence_of(const json &record, const char *key) {
  const json part = part_of(record, key);
  return part.is_string() ? part.get<std::string>() : text_of(part, "sentence");
}

std::string parameters_text(const json &parameters) {
  std::string text;
  for (const auto &[name, p] : parameters.items()) {
    const json value = part_of(p, "value"), interval = part_of(p, "interval_95");
    if (!value.is_number()) continue;
    text += fmt::format("  {:<18} {:>12.5g} {:<6}", name, value.get<double>(), text_of(p, "unit"));
    if (interval.is_array() && interval.size() == 2 && interval[0].is_number() && interval[1].is_number())
      text += fmt::format(" 95 %: {:.5g} .. {:.5g}", interval[0].get<double>(), interval[1].get<double>());
    if (part_of(p, "identifiable") == json(false)) text += "  not identifiable";
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
  const json law = part_of(answer, "law");
  std::string text = fmt::format("the answer: law {}\n", text_of(law, "name")) + parameters_text(part_of(law, "parameters"));
  const auto add = [&text](const std::string &sentence) {
    if (!sentence.empty()) text += "  " + sentence + "\n";
  };
  add(text_of(law, "sentence"));
  add(text_of(law, "remark"));
  for (const char *key : {"pair", "no_pair", "strain", "mesh_error"}) add(sentence_of(answer, key));
  for (const auto &doubt : part_of(answer, "doubts"))
    if (doubt.is_string()) add("doubt: " + doubt.get<std::string>());
  return text;
}

} // namespace rimpact::app
