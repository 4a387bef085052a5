#include "studies/fleets/sweep_toml.h"
#include "io/files/text.h"
#include "scene/scene.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rimpact::fleets {

bool is_variable(const std::string &key) {
  return key.rfind("variable.", 0) == 0;
}

Value number_value(double number) {
  return {fmt::format("{}", number), number};
}

std::string SweepToml::place(const toml::node &node) const {
  return fmt::format("{}:{}:{}", origin_, node.source().begin.line, node.source().begin.column);
}

void SweepToml::fail(const toml::node &node, const std::string &what) const {
  throw InputError(fmt::format("{}: {}", place(node), what));
}

double SweepToml::number(const toml::node &node, const std::string &what) const {
  const auto value = node.value<double>();
  if (!node.is_number() || !value || !std::isfinite(*value)) fail(node, what + " must be a finite number");
  return *value;
}

double SweepToml::number_in(const toml::table &table, const char *name, const std::string &key) const {
  const auto *node = table.get(name);
  if (!node) fail(table, fmt::format("{} needs {}", key, name));
  return number(*node, key + "." + name);
}

void SweepToml::only(const toml::table &table, const std::vector<std::string> &known, const std::string &key) const {
  for (const auto &[name, node] : table)
    if (std::find(known.begin(), known.end(), name.str()) == known.end())
      fail(node, fmt::format("{}: {}", key, unknown_word(name.str(), known)));
}

/// Tables nest by their dots (a.b.c); a leaf is anything else, or a table that says how to make values.
void SweepToml::leaves(const toml::table &table, const std::string &prefix, const Visit &visit) const {
  for (const auto &[name, node] : table) {
    const std::string key = prefix + std::string(name.str());
    const auto *inner = node.as_table();
    const bool leaf = !inner || inner->contains("from") || inner->contains("low") || inner->contains("product");
    if (leaf)
      visit(key, node);
    else
      leaves(*inner, key + ".", visit);
  }
}

void SweepToml::each_table(const toml::node &list, const std::string &form,
                           const std::function<void(const toml::table &)> &visit) const {
  if (!list.is_array()) fail(list, form);
  for (const auto &entry : *list.as_array()) {
    if (!entry.is_table()) fail(entry, form);
    visit(*entry.as_table());
  }
}

void SweepToml::each_key(const char *part, const Visit &visit) const {
  const auto *node = file_.root().get(part);
  if (!node) return;
  if (!node->is_table()) fail(*node, fmt::format("{0} must be a table: [{0}]", part));
  leaves(*node->as_table(), "", visit);
}

Value SweepToml::value(const std::string &key, const toml::node &node) const {
  Value result;
  if (const auto *text = node.as_string())
    result = {nlohmann::json(text->get()).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), text->get()};
  else if (const auto *whole = node.as_integer())
    result = {fmt::format("{}", whole->get()), static_cast<double>(whole->get())};
  else if (node.is_floating_point())
    result = number_value(number(node, key));
  else if (const auto *flag = node.as_boolean())
    result = {flag->get() ? "true" : "false", flag->get() ? 1.0 : 0.0};
  else if (const auto *list = node.as_array())
    result = list_value(key, *list);
  else
    fail(node, key + " must be a number, a text, true, false or a list of them");
  if (!is_variable(key)) scene::check_assignment(key + "=" + result.toml, place(node));
  return result;
}

Value SweepToml::list_value(const std::string &key,
                            const toml::array &list) const { // e.g. displacement_m = [0.1, 0.0]
  std::string text;
  for (const auto &entry : list) {
    if (!entry.is_number() && !entry.is_string()) fail(entry, key + ": a list in a list holds numbers or texts");
    text += (text.empty() ? "" : ", ") + (entry.is_string() ? nlohmann::json(entry.as_string()->get()).dump()
                                                            : fmt::format("{}", number(entry, key)));
  }
  return {"[" + text + "]", "[" + text + "]"};
}

} // namespace rimpact::fleets
