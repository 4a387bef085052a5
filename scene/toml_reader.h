/// Reads the keys of one TOML file, its --set overrides applied, and says where each stands.
#pragma once
#include "scene/error.h"
#include "scene/keys.h"
#include "scene/toml_comments.h"
#include <map>
#include <set>
#include <string>
#include <vector>
#ifndef TOML_ENABLE_FORMATTERS
#define TOML_ENABLE_FORMATTERS 0
#endif
#include <toml++/toml.h>

namespace rimpact::scene {

/// A parsed file with overrides. Throws InputError: "scene.toml:3:7: ...", "--set a.b=1: ...".
class TomlFile {
public:
  TomlFile(const std::string &text, const std::string &origin);
  /// `assignment` is KEY=VALUE, KEY dotted, VALUE as in TOML; a bare word counts as a string.
  /// `place` stands in messages; empty: "--set KEY=VALUE".
  void set(const std::string &assignment, const std::string &place = "");

  /// Takes a key out, as if it had not been given.
  void erase(const std::string &path);

  const toml::table &root() const { return root_; }
  /// "file:line:column" or "--set KEY=VALUE" of a dotted key; the file alone when the key is not there.
  std::string location(const std::string &path) const;
  std::string location_of_key(const std::string &path, const toml::key &key) const;
  const toml::node *find(const std::string &path) const;
  const std::string &origin() const { return origin_; }
  /// Whether the key, or a table around it, was set() and does not stand in the file as it was read.
  bool is_set(const std::string &path) const;
  /// The comment behind a key's value, in the file or as typed; empty: none.
  std::string comment_of(const std::string &path) const;
  /// The comment behind the header of the table that a key of the file stands in; empty: none.
  std::string comment_of_table(const std::string &path) const;

private:
  struct Typed {
    std::string place, comment;
  };
  /// What was set() of the key or of the nearest table around it; null: nothing.
  const Typed *typed(const std::string &path) const;
  std::string origin_;
  TomlComments comments_;
  toml::table root_;
  std::map<std::string, Typed> overrides_; ///< by dotted key
};

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
  void choice(const Key &key, std::string &value, const std::vector<std::string> &options) override;
  void pair(const Key &key, Eigen::Vector2d &value, Range range) override;
  void numbers(const Key &key, std::vector<double> &values, Unit unit, Range range) override;
  void switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) override;

private:
  std::string full(const std::string &name) const { return path_.empty() ? name : path_ + "." + name; }
  const toml::node *node(const Key &key);
  [[noreturn]] void fail(const std::string &name, const std::string &what) const;
  double number_of(const std::string &name, const toml::node &node, Range range) const;
  void refuse_unknown(const std::vector<std::string> &also) const;

  const TomlFile &file_;
  std::string path_;
  std::map<std::string, std::vector<std::string>> asked_; ///< names by table
};

} // namespace rimpact::scene
