#include "app/words/key_describer.h"

#include "io/files/key_list.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::app {

void KeyDescriber::number(const Key &key, double &, Unit, Range range) {
  add(key, "number", range.text());
}

void KeyDescriber::limit(const Key &key, std::optional<double> &, Unit, Range range) {
  add(key, "limit", range.text() + ", or inf");
}

void KeyDescriber::integer(const Key &key, int &, int low, int high) {
  add(key, "integer", fmt::format("{} to {}", low, high));
}

void KeyDescriber::flag(const Key &key, bool &) {
  add(key, "flag", "true, false");
}

void KeyDescriber::text(const Key &key, std::string &) {
  add(key, "text", "text");
}

void KeyDescriber::word(const Key &key, std::string &, const std::vector<std::string> &options) {
  add(key, "choice", fmt::format("{}", fmt::join(options, ", ")));
  choices.emplace_back(keys.back().path, options);
}

void KeyDescriber::pair(const Key &key, Eigen::Vector2d &, Range range) {
  add(key, "pair", "two numbers, each " + range.text());
}

void KeyDescriber::numbers(const Key &key, std::vector<double> &, Unit, Range range) {
  add(key, "numbers", "numbers, each " + range.text());
}

void KeyDescriber::rows(const Key &key, Rows &, const std::array<Column, 2> &columns) {
  add(key, "rows", fmt::format("rows of two numbers, {} and {}", columns[0].range.text(), columns[1].range.text()));
}

void KeyDescriber::switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) {
  std::vector<std::string> words;
  for (const auto &[word, on] : flags) words.push_back(word);
  add(key, "switches", fmt::format("any of {}", fmt::join(words, ", ")));
}

void KeyDescriber::add(const Key &key, const char *kind, std::string range) {
  keys.push_back({.path = path(key),
                  .kind = kind,
                  .unit = unit_in_name(key.name),
                  .preset = key.follows,
                  .range = std::move(range),
                  .meaning = *key.meaning ? key.meaning : key.comment,
                  .assumption = key.assumption,
                  .condition = {},
                  .counts_also = key.counts_also});
}

std::map<std::string, std::string> presets_of(const std::function<void(KeyVisitor &)> &visit,
                                              const std::string &section) {
  KeyList list(section, true);
  visit(list);
  std::map<std::string, std::string> presets;
  for (const auto &entry : list.entries) presets[entry.path()] = entry.value;
  return presets;
}

std::string unit_in_name(const std::string &name) {
  static const std::pair<const char *, const char *> endings[] = {
      // the longer ones first
      {"_kN_per_m2", "kN/m2"}, {"_kN_per_m", "kN/m"}, {"_m_per_s2", "m/s2"}, {"_kg_per_m3", "kg/m3"},
      {"_m_per_s", "m/s"},     {"_s_per_m", "s/m"},   {"_kg_m2", "kg m2"},   {"_per_m5", "1/m5"},
      {"_per_m4", "1/m4"},     {"_per_m3", "1/m3"},   {"_per_m2", "1/m2"},   {"_per_m", "1/m"},
      {"_per_s", "1/s"},       {"_MPa", "MPa"},       {"_GPa", "GPa"},       {"_kN_m", "kN m"},
      {"_deg", "deg"},         {"_kN", "kN"},         {"_kg", "kg"},         {"_mm", "mm"},
      {"_ms", "ms"},           {"_m", "m"},           {"_g", "g"},           {"_s", "s"}};
  for (const auto &[ending, unit] : endings)
    if (name.ends_with(ending)) return unit;
  return {};
}

} // namespace rimpact::app
