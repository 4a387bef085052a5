#include "app/key_catalogue.h"

#include "app/key_meanings.h"
#include "files/key_list.h"
#include "files/toml_reader.h"
#include "scene/keys.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace rimpact::app {
namespace {

/// Writes down kind and range of every key; its value comes from KeyList.
class Describer final : public KeyVisitor {
public:
  std::vector<KeyDescription> keys;

  void section(const char *name, const std::function<void()> &body) override {
    const std::string outer = prefix_;
    prefix_ += std::string(name) + ".";
    body();
    prefix_ = outer;
  }
  bool wants(bool) const override { return true; }
  void number(const Key &key, double &, Unit, Range range) override { add(key, "number", range.text()); }
  void limit(const Key &key, std::optional<double> &, Unit, Range range) override {
    add(key, "limit", range.text() + ", or inf");
  }
  void integer(const Key &key, int &, int low, int high) override {
    add(key, "integer", fmt::format("{} to {}", low, high));
  }
  void flag(const Key &key, bool &) override { add(key, "flag", "true, false"); }
  void text(const Key &key, std::string &) override { add(key, "text", "text"); }
  void word(const Key &key, std::string &, const std::vector<std::string> &options) override {
    add(key, "choice", fmt::format("{}", fmt::join(options, ", ")));
    choices.emplace_back(keys.back().path, options);
  }
  void pair(const Key &key, Eigen::Vector2d &, Range range) override {
    add(key, "pair", "two numbers, each " + range.text());
  }
  void numbers(const Key &key, std::vector<double> &, Unit, Range range) override {
    add(key, "numbers", "numbers, each " + range.text());
  }
  void switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) override {
    std::vector<std::string> words;
    for (const auto &[word, on] : flags) words.push_back(word);
    add(key, "switches", fmt::format("any of {}", fmt::join(words, ", ")));
  }
  std::vector<std::pair<std::string, std::vector<std::string>>> choices;

private:
  void add(const Key &key, const char *kind, std::string range) {
    const std::string path = prefix_ + key.name, own = meaning_of(path);
    keys.push_back({.path = path,
                    .kind = kind,
                    .unit = unit_in_name(key.name),
                    .preset = {},
                    .range = std::move(range),
                    .meaning = own.empty() ? key.comment : own,
                    .assumption = key.assumption,
                    .condition = {}});
  }
  std::string prefix_;
};

void visit_all(KeyVisitor &visitor, scene::Scene &scene) {
  visitor.section("bearing", [&] { scene::visit(visitor, scene.bearing); });
  scene::visit_settings(visitor, scene);
}

/// Keys that count in a scene of these settings.
std::set<std::string> relevant(const std::vector<std::string> &settings) {
  scene::Scene scene;
  TomlFile file("", "");
  for (const auto &setting : settings) file.set(setting);
  TomlReader reader(file, "");
  visit_all(reader, scene);
  KeyList list;
  visit_all(list, scene);
  std::set<std::string> paths;
  for (const auto &entry : list.entries) paths.insert(entry.path());
  return paths;
}

/// What the keys that do not always count depend on: every choice is tried with each of its words.
void find_conditions(const Describer &describer, std::vector<KeyDescription> &keys) {
  auto choices = describer.choices;
  choices.emplace_back("reduced.model", words<scene::ModelKind>()); // a text: models are a catalogue
  for (const auto &[path, words] : choices) {
    std::map<std::string, std::vector<std::string>> words_of; // by key
    for (const auto &word : words)
      for (const auto &key : relevant({fmt::format("{}=\"{}\"", path, word)})) words_of[key].push_back(word);
    for (auto &key : keys)
      if (const auto found = words_of.find(key.path); found != words_of.end() && found->second.size() < words.size())
        key.condition +=
            fmt::format("{}{} = {}", key.condition.empty() ? "" : "; ", path, fmt::join(found->second, " | "));
  }
  const auto always = relevant({});
  for (auto &key : keys)
    if (key.condition.empty() && always.count(key.path) == 0) key.condition = conditions_by_hand(key.path);
}

} // namespace

std::string unit_in_name(const std::string &name) {
  static const std::pair<const char *, const char *> endings[] = {// the longer ones first
                                                                  {"_kN_per_m", "kN/m"},
                                                                  {"_m_per_s2", "m/s2"},
                                                                  {"_kg_per_m3", "kg/m3"},
                                                                  {"_m_per_s", "m/s"},
                                                                  {"_s_per_m", "s/m"},
                                                                  {"_kg_m2", "kg m2"},
                                                                  {"_per_m5", "1/m5"},
                                                                  {"_per_m4", "1/m4"},
                                                                  {"_per_m3", "1/m3"},
                                                                  {"_per_m2", "1/m2"},
                                                                  {"_per_m", "1/m"},
                                                                  {"_MPa", "MPa"},
                                                                  {"_deg", "deg"},
                                                                  {"_kN", "kN"},
                                                                  {"_kg", "kg"},
                                                                  {"_mm", "mm"},
                                                                  {"_ms", "ms"},
                                                                  {"_m", "m"},
                                                                  {"_g", "g"},
                                                                  {"_s", "s"}};
  for (const auto &[ending, unit] : endings)
    if (name.ends_with(ending)) return unit;
  return {};
}

std::vector<KeyDescription> scene_keys() {
  Describer describer;
  scene::Scene scene;
  visit_all(describer, scene);
  KeyList values("", true);
  visit_all(values, scene);
  std::map<std::string, std::string> presets;
  for (const auto &entry : values.entries) presets[entry.path()] = entry.value;
  std::vector<KeyDescription> keys = describer.keys;
  for (auto &key : keys) {
    const std::string follows = preset_by_hand(key.path);
    key.preset = follows.empty() ? presets.at(key.path) : follows;
  }
  find_conditions(describer, keys);
  for (const auto &[path, meaning] :
       {std::pair{"name", "of the scene; default: the file's"},
        {"bearing.name", "a built-in bearing, or that of your own"},
        {"bearing.file", "a bearing file beside the scene; keys of [bearing] override it"}})
    keys.insert(keys.begin(), {path, "text", "", "\"\"", "text", meaning, false, ""});
  keys.insert(keys.begin() + 3, {"bearing.assumed", "switches", "", "[]", "any number's key",
                                 "keys to be marked as assumptions", false, ""});
  return keys;
}

} // namespace rimpact::app
