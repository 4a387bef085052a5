/// Helpers of the sweep reader: places in messages, numbers, dotted keys, values a scene can take.
#pragma once
#include "io/files/toml_reader.h"
#include "studies/fleets/sweep.h"
#include <functional>

namespace rimpact::fleets {

/// KEY=VALUE for a scene: a file that the value names is sought beside the file `origin`, and named absolutely.
std::string assignment_beside(const std::string &origin, const std::string &key, const Value &value);
/// A key that is only a column and a factor, not one of the scene.
bool is_variable(const std::string &key);
Value number_value(double number);

class SweepToml {
public:
  SweepToml(const TomlFile &file, const std::string &origin) : file_(file), origin_(origin) {}

protected:
  using Visit = std::function<void(const std::string &key, const toml::node &leaf)>;

  std::string place(const toml::node &node) const; ///< file:line:column
  [[noreturn]] void fail(const toml::node &node, const std::string &what) const;
  double number(const toml::node &node, const std::string &what) const;
  double number_in(const toml::table &table, const char *name, const std::string &key) const;
  /// Refuses names that are not known.
  void only(const toml::table &table, const std::vector<std::string> &known, const std::string &key) const;
  /// Visits the tables of a list of them; `form` says how they are written, where it is none.
  void each_table(const toml::node &list, const std::string &form,
                  const std::function<void(const toml::table &)> &visit) const;
  /// Visits the dotted keys of a part of the file.
  void each_key(const char *part, const Visit &visit) const;
  void leaves(const toml::table &table, const std::string &prefix, const Visit &visit) const;
  /// A value for the scene: its key is known, its type and range are right.
  Value value(const std::string &key, const toml::node &node) const;

  const TomlFile &file_;
  const std::string &origin_;

private:
  Value list_value(const std::string &key, const toml::array &list) const;
};

} // namespace rimpact::fleets
