/// Values of a TOML file as words.
#pragma once
#include "io/files/toml_reader.h"
#include <map>
#include <string>

namespace rimpact::app {

/// A value as an assignment's right-hand side, quoted where it is text; empty for a table.
std::string as_written(const toml::node &node);
/// Every value of the file by its dotted key.
std::map<std::string, std::string> flattened(const TomlFile &file);

} // namespace rimpact::app
