/// Reads the keys of a description from one table of a TOML file.
#pragma once
#include "io/files/error.h"
#include "io/files/key_visitor.h"
#include "io/files/toml_file.h"
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rimpact {

class TomlReader final : public KeyVisitor {
public:
  /// Keys are read from the table at `prefix` (empty: the root).
  TomlReader(const TomlFile &file, std::string prefix) : file_(file), path_(std::move(prefix)) {}
  /// Refuses keys of the table at the prefix that neither a visit nor `also` has asked for.
  void finish(const std::vector<std::string> &also = {}) const { refuse_unknown(also); }

  void section(const char *name, const std::function<void()> &body) override;
  bool wants(bool) const override { return true; }
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

  /// A list of tables, [[name]], the keys of each visited by `body`; others are refused. Returns their number, 0 where
  /// there is none.
  std::size_t tables(const char *name, const std::function<void()> &body);
  void texts(const Key &key, std::vector<std::string> &values);
  /// A key of any type; null: it is not there.
  const toml::node *node(const Key &key);
  bool has(const char *name) const { return file_.find(full(name)) != nullptr; }
  /// Throws InputError with the place of a key of the table being read, or of that table (empty), and `sentence`.
  [[noreturn]] void refuse(const std::string &name, const std::string &sentence) const;

private:
  std::string full(const std::string &name) const { return path_.empty() ? name : path_ + "." + name; }
  [[noreturn]] void fail(const std::string &name, const std::string &what) const;
  double number_of(const std::string &name, const toml::node &node, Range range) const;
  void refuse_unknown(const std::vector<std::string> &also) const;

  const TomlFile &file_;
  std::string path_;
  std::map<std::string, std::vector<std::string>> asked_; ///< names by table
};

} // namespace rimpact
