/// What a file's key is: its name, unit and range, and the visitor that walks over the keys of a description. The
/// reader, the writer, the range check and the list of assumptions are visitors.
#pragma once
#include "io/files/choice.h"
#include <array>
#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rimpact {

/// How a file's number becomes SI: divided by or multiplied with a power of ten (both exact to one rounding).
struct Unit {
  double factor;
  bool divide;
  double to_si(double file_value) const { return divide ? file_value / factor : file_value * factor; }
  double from_si(double value) const { return divide ? value * factor : value / factor; }
};
inline constexpr Unit si{1, false}, milli{1e3, true}, kilo{1e3, false}, mega{1e6, false};

/// Admissible numbers, in the file's unit.
struct Range {
  double low, high;
  bool low_open = false, high_open = false;
  bool contains(double x) const { // false for NaN
    return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
  }
  std::string text() const; ///< "> 0", "between 0 and 1", ...
  /// The same for a value outside it: the largest magnitude is named where that is what it passes.
  std::string text_for(double value) const;
};
inline constexpr double unbounded = std::numeric_limits<double>::infinity();
/// Any finite magnitude the machine's arithmetic survives; lengths are far below it.
inline constexpr double huge = 1e12;
inline constexpr Range positive{0, huge, true};

struct Key {
  const char *name;
  const char *comment = "";     ///< what a file says beside it; of a choice without one: its words
  bool assumption = false;      ///< its default is an assumption of ours
  const char *meaning = "";     ///< what the list of keys says; empty: the comment
  const char *follows = "";     ///< the default in words, where it follows from other keys
  const char *counts_also = ""; ///< who reads it beside the choices that say so; appended to its condition
};

/// One of the two columns of a table of rows.
struct Column {
  Unit unit;
  Range range;
};
/// Rows of two numbers [SI], or the name of a file that holds them.
struct Rows {
  std::vector<std::array<double, 2>> values = {};
  std::string file = {}; ///< empty once it is read
  bool operator==(const Rows &) const = default;
};

class KeyVisitor {
public:
  virtual ~KeyVisitor() = default;
  /// A table of the file, its keys visited by `body`.
  virtual void section(const char *name, const std::function<void()> &body) = 0;
  /// Whether to visit keys that matter only when `relevant` (readers: always, writers: when relevant).
  virtual bool wants(bool relevant) const { return relevant; }
  virtual void number(const Key &key, double &value, Unit unit, Range range) = 0;
  /// A number that may be absent; the file writes absence as inf.
  virtual void limit(const Key &key, std::optional<double> &value, Unit unit, Range range) = 0;
  virtual void integer(const Key &key, int &value, int low, int high) = 0;
  virtual void flag(const Key &key, bool &value) = 0;
  virtual void text(const Key &key, std::string &value) = 0;
  /// One of the options, as the file writes it.
  virtual void word(const Key &key, std::string &value, const std::vector<std::string> &options) = 0;
  /// One of a table's words; a key without a comment is described by the table.
  template <Worded E> void choice(Key key, E &value) {
    if (!*key.comment) key.comment = words_in_line<E>();
    std::string written = rimpact::word(value);
    word(key, written, words<E>());
    value = parse<E>(written).value_or(value); // a reader has refused every other word
  }
  virtual void pair(const Key &key, Eigen::Vector2d &value, Range range) = 0;
  /// An array of any length.
  virtual void numbers(const Key &key, std::vector<double> &values, Unit unit, Range range) = 0;
  /// An array of rows of two numbers, or a file's name in its place.
  virtual void rows(const Key &key, Rows &rows, const std::array<Column, 2> &columns) = 0;
  /// An array of words, each switching a flag on.
  virtual void switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) = 0;
};

/// Shortest decimal number that reads back as the same SI value through `unit`.
std::string file_number(double value, Unit unit);

} // namespace rimpact
