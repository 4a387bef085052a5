#include "io/files/json_fields.h"

#include "io/files/error.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact {

using nlohmann::json;

JsonReader::JsonReader(const json &object, std::string file, std::string path)
    : object_(object), file_(std::move(file)), path_(std::move(path)) {
  if (!object_.is_object()) fail(path_.empty() ? "it" : path_, "is not a JSON object");
}

const json *JsonReader::find(const char *key) const {
  const auto found = object_.find(key);
  return found == object_.end() || found->is_null() ? nullptr : &*found;
}

const json &JsonReader::at(const char *key) const {
  const json *found = find(key);
  if (!found) fail(path_of(key), "is missing");
  return *found;
}

std::string JsonReader::path_of(const std::string &key) const {
  constexpr std::size_t longest = 60; // a name from outside stays a name
  const std::string name = key.substr(0, longest);
  return path_.empty() ? name : path_ + "." + name;
}

void JsonReader::fail(const std::string &path, const std::string &what) const {
  throw DataError(fmt::format("{}: {} {}", file_, path, what));
}

void JsonReader::needed(const char *key, double &value, Unit unit) const {
  needed(key, value);
  value = unit.to_si(value);
}

void JsonReader::operator()(const char *key, std::optional<double> &value, Unit unit) const {
  (*this)(key, value);
  if (value) value = unit.to_si(*value);
}

void JsonReader::read(const json &from, const std::string &path, double &value) const {
  if (!from.is_number()) fail(path, "is not a number");
  value = from.get<double>();
  if (!std::isfinite(value)) fail(path, "is not a finite number");
}

void JsonReader::read(const json &from, const std::string &path, int &value) const {
  if (!from.is_number_integer()) fail(path, "is not a whole number");
  constexpr double most = std::numeric_limits<int>::max();
  if (std::abs(from.get<double>()) > most) fail(path, fmt::format("is beyond {:.0f}", most));
  value = from.get<int>();
}

void JsonReader::read(const json &from, const std::string &path, bool &value) const {
  if (!from.is_boolean()) fail(path, "is not true or false");
  value = from.get<bool>();
}

void JsonReader::read(const json &from, const std::string &path, std::string &value) const {
  if (!from.is_string()) fail(path, "is not a text");
  value = from.get<std::string>();
}

std::size_t JsonReader::length(const json &list, const std::string &path) const {
  if (!list.is_array()) fail(path, "is not a list");
  return list.size();
}

json JsonWriter::made(double value) {
  return std::isfinite(value) ? json(value) : json();
}

void JsonWriter::operator()(const char *key, const std::optional<double> &value, Unit unit) {
  object[key] = value ? made(unit.from_si(*value)) : json();
}

void JsonWriter::or_null(const char *key, const std::string &value) {
  object[key] = value.empty() ? json() : json(value);
}

} // namespace rimpact
