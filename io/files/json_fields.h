/// The keys of a JSON object, described once: `visit(fields, value)` of a struct, found beside the struct, walks over
/// them. A JsonReader fills the struct from the object, a JsonWriter makes the object of the struct. Values are
/// numbers, words, texts, such structs, and optionals, arrays, lists and maps by name of these.
#pragma once
#include "io/files/key_visitor.h"
#include <map>
#include <nlohmann/json.hpp>

namespace rimpact {

/// Throws DataError with the file, the whole path of the key and what is wrong there: "a/calibration.json:
/// answer.law.element.k_i.value is not a number".
class JsonReader {
public:
  /// `object` stands at `path` of `file`, "" where it is the whole of it, and outlives the reader.
  JsonReader(const nlohmann::json &object, std::string file, std::string path = "");

  /// Where the key is absent or null the value stays as it was.
  template <class T> void operator()(const char *key, T &value) const {
    if (const auto *found = find(key)) read(*found, path_of(key), value);
  }
  /// The key has to be there.
  template <class T> void needed(const char *key, T &value) const { read(at(key), path_of(key), value); }
  /// As an SI value.
  void needed(const char *key, double &value, Unit unit) const;
  void operator()(const char *key, std::optional<double> &value, Unit unit) const;
  /// An empty text is null in the file.
  void or_null(const char *key, std::string &value) const { (*this)(key, value); }
  /// A list, of which the file may hold the only value by itself.
  template <class T> void one_or_list(const char *key, std::vector<T> &values) const {
    const auto *found = find(key);
    if (found && !found->is_array())
      read(*found, path_of(key), values.emplace_back());
    else
      (*this)(key, values);
  }

  const nlohmann::json *find(const char *key) const; ///< none: it is absent or null
  const nlohmann::json &at(const char *key) const;
  const nlohmann::json &object() const { return object_; }
  std::string path_of(const std::string &key) const;
  [[noreturn]] void fail(const std::string &path, const std::string &what) const;

private:
  using json = nlohmann::json;
  void read(const json &from, const std::string &path, double &value) const;
  void read(const json &from, const std::string &path, int &value) const;
  void read(const json &from, const std::string &path, bool &value) const;
  void read(const json &from, const std::string &path, std::string &value) const;
  template <Worded E> void read(const json &from, const std::string &path, E &value) const {
    std::string written;
    read(from, path, written);
    const auto known = parse<E>(written);
    if (!known) fail(path, "is \"" + written + "\", none of " + words_in_line<E>());
    value = *known;
  }
  template <class T> void read(const json &from, const std::string &path, std::optional<T> &value) const {
    value.reset();
    if (!from.is_null()) read(from, path, value.emplace());
  }
  template <class T> void read(const json &from, const std::string &path, std::vector<T> &values) const {
    values.resize(length(from, path));
    for (std::size_t i = 0; i < values.size(); ++i) read(from[i], path + "[" + std::to_string(i) + "]", values[i]);
  }
  template <class T, std::size_t n>
  void read(const json &from, const std::string &path, std::array<T, n> &values) const {
    if (length(from, path) != n) fail(path, "is not a list of " + std::to_string(n));
    for (std::size_t i = 0; i < n; ++i) read(from[i], path + "[" + std::to_string(i) + "]", values[i]);
  }
  template <class T> void read(const json &from, const std::string &path, std::map<std::string, T> &values) const {
    const JsonReader inner(from, file_, path);
    for (const auto &[name, item] : from.items()) read(item, inner.path_of(name), values[name]);
  }
  template <class T> void read(const json &from, const std::string &path, T &value) const {
    const JsonReader inner(from, file_, path);
    visit(inner, value);
  }
  std::size_t length(const json &list, const std::string &path) const;

  const json &object_;
  std::string file_, path_;
};

/// Numbers that are not finite are null.
class JsonWriter {
public:
  nlohmann::json object = nlohmann::json::object();

  template <class T> void operator()(const char *key, const T &value) { object[key] = made(value); }
  template <class T> void needed(const char *key, const T &value) { object[key] = made(value); }
  void needed(const char *key, double value, Unit unit) { object[key] = made(unit.from_si(value)); }
  void operator()(const char *key, const std::optional<double> &value, Unit unit);
  void or_null(const char *key, const std::string &value);
  template <class T> void one_or_list(const char *key, const std::vector<T> &values) {
    object[key] = values.empty() ? nlohmann::json() : values.size() == 1 ? made(values.front()) : made(values);
  }

private:
  template <class T> friend nlohmann::json json_of(const T &value);
  using json = nlohmann::json;
  static json made(double value);
  static json made(int value) { return value; }
  static json made(bool value) { return value; }
  static json made(const std::string &value) { return value; }
  template <Worded E> static json made(const E &value) { return word(value); }
  template <class T> static json made(const std::optional<T> &value) { return value ? made(*value) : json(); }
  template <class T> static json list_of(const T &values) {
    json list = json::array();
    for (const auto &value : values) list.push_back(made(value));
    return list;
  }
  template <class T> static json made(const std::vector<T> &values) { return list_of(values); }
  template <class T, std::size_t n> static json made(const std::array<T, n> &values) { return list_of(values); }
  template <class T> static json made(const std::map<std::string, T> &values) {
    json all = json::object();
    for (const auto &[name, value] : values) all[name] = made(value);
    return all;
  }
  template <class T> static json made(const T &value) {
    JsonWriter inner;
    T copy = value; // one `visit` reads and writes
    visit(inner, copy);
    return inner.object;
  }
};

/// The JSON of a struct that has a `visit`, or of anything that is made of such.
template <class T> nlohmann::json json_of(const T &value) {
  return JsonWriter::made(value);
}

} // namespace rimpact
