/// The keys of a scene or bearing as a list, each with its value as the file writes it.
#pragma once
#include "io/files/key_visitor.h"
#include <string>
#include <vector>

namespace rimpact {

struct KeyEntry {
  std::string section; ///< dotted, without brackets; empty: the root
  Key key;
  std::string value;      ///< as TOML writes it
  bool is_number = false; ///< a number, or a limit that may be absent
  std::string path() const { return section.empty() ? key.name : section + "." + key.name; }
};

/// Collects the keys that matter, or every one of them.
class KeyList final : public KeyVisitor {
public:
  explicit KeyList(std::string section = "", bool every = false) : section_(std::move(section)), every_(every) {}
  std::vector<KeyEntry> entries;

  void section(const char *name, const std::function<void()> &body) override;
  bool wants(bool relevant) const override { return relevant || every_; }
  void number(const Key &key, double &value, Unit unit, Range range) override;
  void limit(const Key &key, std::optional<double> &value, Unit unit, Range range) override;
  void integer(const Key &key, int &value, int low, int high) override;
  void flag(const Key &key, bool &value) override;
  void text(const Key &key, std::string &value) override;
  void word(const Key &key, std::string &value, const std::vector<std::string> &options) override;
  void pair(const Key &key, Eigen::Vector2d &value, Range range) override;
  void numbers(const Key &key, std::vector<double> &values, Unit unit, Range range) override;
  void rows(const Key &key, Rows &rows, const std::array<Column, 2> &columns) override;
  void switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) override;

private:
  void add(const Key &key, std::string value, bool is_number = false);
  std::string section_;
  bool every_;
};

/// A string as TOML writes it, quotes included.
std::string toml_quoted(const std::string &text);

} // namespace rimpact
