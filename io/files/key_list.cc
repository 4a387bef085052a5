#include "io/files/key_list.h"
#include <fmt/format.h>

namespace rimpact {

std::string toml_quoted(const std::string &text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += '\\', result += c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04X}", static_cast<int>(c));
    else
      result += c;
  }
  return result + "\"";
}

void KeyList::add(const Key &key, std::string value, bool is_number) {
  entries.push_back({section_, key, std::move(value), is_number});
}

void KeyList::section(const char *name, const std::function<void()> &body) {
  const std::string outer = section_;
  section_ = section_.empty() ? name : section_ + "." + name;
  body();
  section_ = outer;
}

void KeyList::number(const Key &key, double &value, Unit unit, Range) {
  add(key, file_number(value, unit), true);
}

void KeyList::limit(const Key &key, std::optional<double> &value, Unit unit, Range) {
  add(key, value ? file_number(*value, unit) : "inf", true);
}

void KeyList::integer(const Key &key, int &value, int, int) {
  add(key, fmt::format("{}", value));
}

void KeyList::flag(const Key &key, bool &value) {
  add(key, value ? "true" : "false");
}

void KeyList::text(const Key &key, std::string &value) {
  add(key, toml_quoted(value));
}

void KeyList::word(const Key &key, std::string &value, const std::vector<std::string> &) {
  add(key, toml_quoted(value));
}

void KeyList::pair(const Key &key, Eigen::Vector2d &value, Range) {
  add(key, fmt::format("[{}, {}]", file_number(value.x(), si), file_number(value.y(), si)));
}

void KeyList::numbers(const Key &key, std::vector<double> &values, Unit unit, Range) {
  constexpr std::size_t a_line = 10; // longer arrays stand on lines of their own
  const bool tall = values.size() > a_line;
  std::string list;
  for (std::size_t i = 0; i < values.size(); ++i) {
    list += i == 0 ? "" : tall && i % a_line == 0 ? "," : ", ";
    list += (tall && i % a_line == 0 ? "\n  " : "") + file_number(values[i], unit);
  }
  add(key, "[" + list + (tall ? "\n]" : "]"));
}

void KeyList::rows(const Key &key, Rows &rows, const std::array<Column, 2> &columns) {
  if (!rows.file.empty()) return add(key, toml_quoted(rows.file));
  std::string list;
  for (const auto &[first, second] : rows.values)
    list += fmt::format("{}[{}, {}]", list.empty() ? "" : ", ", file_number(first, columns[0].unit),
                        file_number(second, columns[1].unit));
  add(key, "[" + list + "]");
}

void KeyList::switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) {
  std::string list;
  for (const auto &[name, on] : flags)
    if (*on) list += (list.empty() ? "" : ", ") + toml_quoted(name);
  add(key, "[" + list + "]");
}

} // namespace rimpact
