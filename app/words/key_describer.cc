#include "app/words/key_describer.h"

#include "io/files/key_list.h"
#include "io/files/text.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <string_view>

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
  static const std::set<std::string_view> units{"kN", "kg", "g",  "mm",  "mm2", "m",   "m2", "m3", "m4", "m5",
                                                "s",  "s2", "ms", "deg", "MPa", "GPa", "J",  "W",  "K",  "HB"};
  if (name.ends_with("temperature_C")) return "C";
  auto parts = split(name, '_');
  parts.erase(parts.begin()); // what the number is called
  auto begin = parts.end();
  const auto names_one = [&](const auto &part) { // K within a name is a number of its own, not the kelvin
    return part == "per" || (units.contains(part) && (part != "K" || begin == parts.end()));
  };
  while (begin != parts.begin() && names_one(*(begin - 1))) --begin;
  const auto per = std::find(begin, parts.end(), "per");
  const std::string top = fmt::format("{}", fmt::join(begin, per, " "));
  if (per == parts.end()) return top;
  const std::string bottom = fmt::format("{}", fmt::join(per + 1, parts.end(), " "));
  return (top.empty() ? "1" : top) + "/" + (parts.end() - per > 2 ? "(" + bottom + ")" : bottom);
}

} // namespace rimpact::app
