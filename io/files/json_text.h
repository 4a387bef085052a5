/// JSON as it leaves the program.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace rimpact {

/// Indented by two, with a line end. Bytes that are not UTF-8 (file names may be anything) are replaced: they must not
/// stop the writing of results.
template <class Json> std::string json_text(const Json &json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Null where there is none.
template <class Json = nlohmann::json, class T> Json or_null(const std::optional<T> &value) {
  return value ? Json(*value) : Json(nullptr);
}

} // namespace rimpact
