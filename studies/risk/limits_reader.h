/// Reads [[limit]] of a study: quantities of its runs and the values they must not exceed.
#pragma once
#include "io/files/toml_reader.h"
#include "studies/risk/study.h"

namespace rimpact::risk {

/// Throws InputError "file:line:column: ...".
std::vector<Limit> read_limits(const TomlFile &file);

} // namespace rimpact::risk
