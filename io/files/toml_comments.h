/// The comments of a TOML text, which its parser drops.
#pragma once
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace rimpact {

struct TomlComments {
  std::map<std::size_t, std::string> by_line; ///< lines from 1; what follows the first # outside strings
  std::set<std::size_t> headers;              ///< lines that open a table
};
/// Never fails: what is no TOML has whatever comments it has.
TomlComments toml_comments(std::string_view text);

} // namespace rimpact
