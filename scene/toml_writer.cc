#include "scene/keys.h"
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

std::string quoted(const std::string &text) {
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

/// Writes every key with its value, and its comment behind it.
class TomlWriter final : public KeyVisitor {
public:
  explicit TomlWriter(std::string prefix) : path_(std::move(prefix)) {}
  std::string out;

  void section(const char *name, const std::function<void()> &body) override {
    const std::string outer = path_;
    path_ = path_.empty() ? name : path_ + "." + name;
    header_due_ = true; // a table that holds only tables needs no header of its own
    body();
    path_ = outer;
  }
  void line(const Key &key, const std::string &value) {
    if (header_due_ && !path_.empty()) out += fmt::format("\n[{}]\n", path_);
    header_due_ = false;
    const std::string text = fmt::format("{} = {}", key.name, value);
    const char *joint = key.assumption && *key.comment ? ": " : "";
    const std::string comment = fmt::format("{}{}{}", key.assumption ? "assumption" : "", joint, key.comment);
    out += comment.empty() ? text + "\n" : fmt::format("{:<32} # {}\n", text, comment);
  }
  void number(const Key &key, double &value, Unit unit, Range) override {
    line(key, file_number(value, unit));
  }
  void limit(const Key &key, std::optional<double> &value, Unit unit, Range) override {
    line(key, value ? file_number(*value, unit) : "inf");
  }
  void integer(const Key &key, int &value, int, int) override { line(key, fmt::format("{}", value)); }
  void flag(const Key &key, bool &value) override { line(key, value ? "true" : "false"); }
  void text(const Key &key, std::string &value) override { line(key, quoted(value)); }
  void choice(const Key &key, std::string &value, const std::vector<std::string> &) override {
    line(key, quoted(value));
  }
  void pair(const Key &key, Eigen::Vector2d &value, Range) override {
    line(key, fmt::format("[{}, {}]", file_number(value.x(), si), file_number(value.y(), si)));
  }
  void numbers(const Key &key, std::vector<double> &values, Unit unit, Range) override {
    constexpr std::size_t a_line = 10; // longer arrays stand on lines of their own
    const bool tall = values.size() > a_line;
    std::string list;
    for (std::size_t i = 0; i < values.size(); ++i) {
      list += i == 0 ? "" : tall && i % a_line == 0 ? "," : ", ";
      list += (tall && i % a_line == 0 ? "\n  " : "") + file_number(values[i], unit);
    }
    line(key, tall ? "[" + list + ",\n]" : "[" + list + "]");
  }
  void switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) override {
    std::string list;
    for (const auto &[name, on] : flags)
      if (*on) list += (list.empty() ? "" : ", ") + quoted(name);
    line(key, "[" + list + "]");
  }

private:
  std::string path_;
  bool header_due_ = false;
};

} // namespace

std::string to_toml(const Bearing &bearing) {
  TomlWriter writer("");
  Bearing copy = bearing;
  visit(writer, copy);
  return fmt::format("name = {}\n{}", quoted(bearing.name), writer.out);
}

std::string to_toml(const Scene &scene) {
  TomlWriter bearing("bearing"), settings("");
  Scene copy = scene;
  visit(bearing, copy.bearing);
  visit_settings(settings, copy);
  return fmt::format("name = {}\n\n[bearing]\nname = {}\n{}{}", quoted(scene.name),
                     quoted(scene.bearing.name), bearing.out, settings.out);
}

} // namespace rimpact::scene
