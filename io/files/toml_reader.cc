#include "io/files/toml_reader.h"
#include "io/files/text.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact {
namespace {

std::string type_name(const toml::node &node) {
  if (const auto *text = node.as_string()) return fmt::format("the string \"{}\"", text->get().substr(0, 60));
  if (const auto *flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (const auto *whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto *real = node.as_floating_point()) return file_number(real->get(), si);
  return "a date or time";
}

/// The key that was meant, those it may have been, or all that the table has.
std::string cure(const std::string &name, std::vector<std::string> known) {
  if (const auto close = nearest(name, known)) return fmt::format("; did you mean \"{}\"?", *close);
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  const auto related = words_near(name, known);
  if (!related.empty()) return fmt::format("; it has {}", fmt::join(related, ", "));
  return known.empty() ? "" : fmt::format("; known: {}", fmt::join(known, ", "));
}

/// A path as messages have it: of the tables of a list without their numbers, which the line says.
std::string shown(std::string path) {
  for (auto at = path.find('['); at != std::string::npos; at = path.find('[')) path.erase(at, path.find(']') + 1 - at);
  return path;
}

} // namespace

void TomlReader::fail(const std::string &name, const std::string &what) const {
  throw InputError(fmt::format("{}: {} {}", file_.location(full(name)), shown(full(name)), what));
}

void TomlReader::refuse(const std::string &name, const std::string &sentence) const {
  throw InputError(fmt::format("{}: {}", file_.location(name.empty() ? path_ : full(name)), sentence));
}

const toml::node *TomlReader::node(const Key &key) {
  asked_[path_].push_back(key.name);
  return file_.find(full(key.name));
}

void TomlReader::section(const char *name, const std::function<void()> &body) {
  asked_[path_].push_back(name);
  const auto *table = file_.find(full(name));
  if (table && !table->is_table()) fail(name, "must be a table, got " + type_name(*table));
  const std::string outer = path_;
  path_ = full(name);
  body();
  refuse_unknown({});
  path_ = outer;
}

std::size_t TomlReader::tables(const char *name, const std::function<void()> &body) {
  const auto *list = node({name});
  if (!list) return 0;
  const std::string form = fmt::format("must be tables, each under a line [[{}]]", shown(full(name))), outer = path_;
  if (!list->is_array()) fail(name, form);
  const std::size_t n = list->as_array()->size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::string entry = fmt::format("{}[{}]", name, i);
    if (!file_.find(full(entry))->is_table()) fail(entry, form);
    path_ = full(entry);
    body();
    refuse_unknown({});
    path_ = outer;
  }
  return n;
}

void TomlReader::texts(const Key &key, std::vector<std::string> &values) {
  const auto *found = node(key);
  if (!found) return;
  const auto *array = found->as_array();
  if (!array) fail(key.name, "must be an array of strings, got " + type_name(*found));
  values.clear();
  for (const auto &entry : *array) {
    if (!entry.is_string()) fail(key.name, "must be an array of strings, got " + type_name(entry));
    values.push_back(entry.as_string()->get());
  }
}

void TomlReader::refuse_unknown(const std::vector<std::string> &also) const {
  const auto *node = file_.find(path_);
  if (!node || !node->is_table()) return;
  std::vector<std::string> known = also;
  if (const auto found = asked_.find(path_); found != asked_.end())
    known.insert(known.end(), found->second.begin(), found->second.end());
  for (const auto &[key, value] : *node->as_table()) {
    const std::string name(key.str());
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw InputError(fmt::format("{}: unknown key \"{}\"{}{}", file_.location_of_key(full(name), key),
                                 name.substr(0, 80), path_.empty() ? "" : " in [" + shown(path_) + "]",
                                 cure(name, known)));
  }
}

double TomlReader::number_of(const std::string &name, const toml::node &node, Range range) const {
  if (!node.is_number()) {
    const auto *text = node.as_string();
    fail(name, "must be a number, got " + type_name(node) + (text ? hint_at_comma(text->get()) : ""));
  }
  const double value =
      node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
  if (!std::isfinite(value)) fail(name, fmt::format("must be a finite number, got {}", value));
  if (!range.contains(value)) fail(name, fmt::format("{} must be {}", value, range.text_for(value)));
  return value;
}

void TomlReader::number(const Key &key, double &value, Unit unit, Range range) {
  if (const auto *found = node(key)) value = unit.to_si(number_of(key.name, *found, range));
}

void TomlReader::limit(const Key &key, std::optional<double> &value, Unit unit, Range range) {
  const auto *found = node(key);
  if (!found) return;
  const auto *real = found->as_floating_point();
  if (real && std::isinf(real->get()) && real->get() > 0)
    value.reset();
  else
    value = unit.to_si(number_of(key.name, *found, range));
}

void TomlReader::integer(const Key &key, int &value, int low, int high) {
  const auto *found = node(key);
  if (!found) return;
  if (!found->is_integer()) fail(key.name, "must be a whole number, got " + type_name(*found));
  const auto whole = found->as_integer()->get();
  if (whole < low || whole > high) fail(key.name, fmt::format("{} must be between {} and {}", whole, low, high));
  value = static_cast<int>(whole);
}

void TomlReader::flag(const Key &key, bool &value) {
  const auto *found = node(key);
  if (!found) return;
  if (!found->is_boolean()) fail(key.name, "must be true or false, got " + type_name(*found));
  value = found->as_boolean()->get();
}

void TomlReader::text(const Key &key, std::string &value) {
  const auto *found = node(key);
  if (!found) return;
  if (!found->is_string()) fail(key.name, "must be a string, got " + type_name(*found));
  value = found->as_string()->get();
}

void TomlReader::word(const Key &key, std::string &value, const std::vector<std::string> &options) {
  text(key, value);
  if (std::find(options.begin(), options.end(), value) == options.end()) fail(key.name, unknown_word(value, options));
}

void TomlReader::pair(const Key &key, Eigen::Vector2d &value, Range range) {
  const auto *found = node(key);
  if (!found) return;
  const auto *array = found->as_array();
  if (!array || array->size() != 2) fail(key.name, "must be two numbers, e.g. [0.1, 0.0]");
  for (int i = 0; i < 2; ++i) value[i] = number_of(key.name, (*array)[static_cast<std::size_t>(i)], range);
}

void TomlReader::numbers(const Key &key, std::vector<double> &values, Unit unit, Range range) {
  const auto *found = node(key);
  if (!found) return;
  const auto *array = found->as_array();
  if (!array) fail(key.name, "must be an array of numbers, got " + type_name(*found));
  values.clear();
  for (const auto &entry : *array) values.push_back(unit.to_si(number_of(key.name, entry, range)));
}

void TomlReader::rows(const Key &key, Rows &rows, const std::array<Column, 2> &columns) {
  const auto *found = node(key);
  if (!found) return;
  rows = {};
  if (found->is_string()) {
    rows.file = found->as_string()->get();
    return;
  }
  const auto *array = found->as_array();
  if (!array) fail(key.name, "must be rows of two numbers or a file's name, got " + type_name(*found));
  for (const auto &entry : *array) {
    const auto *row = entry.as_array();
    if (!row || row->size() != 2)
      fail(key.name, fmt::format("row {} must be two numbers, e.g. [0.05, 480]", rows.values.size() + 1));
    auto &values = rows.values.emplace_back();
    for (std::size_t i = 0; i < 2; ++i)
      values[i] = columns[i].unit.to_si(number_of(key.name, (*row)[i], columns[i].range));
  }
}

void TomlReader::switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) {
  const auto *found = node(key);
  if (!found) return;
  const auto *array = found->as_array();
  if (!array) fail(key.name, "must be an array of words, got " + type_name(*found));
  std::vector<std::string> names;
  names.reserve(flags.size());
  for (const auto &[name, target] : flags) names.push_back(name), *target = false;
  for (const auto &entry : *array) {
    if (!entry.is_string()) fail(key.name, "must be an array of words, got " + type_name(entry));
    const auto at = std::find(names.begin(), names.end(), entry.as_string()->get());
    if (at == names.end()) fail(key.name, unknown_word(entry.as_string()->get(), names));
    *flags[static_cast<std::size_t>(at - names.begin())].second = true;
  }
}

} // namespace rimpact
