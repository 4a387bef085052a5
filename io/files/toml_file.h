/// One parsed TOML file, its --set overrides applied, that says where each key stands.
#pragma once
#include "io/files/toml_comments.h"
#include <map>
#include <string>
#ifndef TOML_ENABLE_FORMATTERS
#define TOML_ENABLE_FORMATTERS 0
#endif
#include <toml++/toml.h>

namespace rimpact {

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
  /// `path`: dotted; part "limit[2]" is the third entry of the list "limit". Null: it is not there.
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

} // namespace rimpact
