/// Reads [[difference]] of a study: which of its systems are compared with which.
#pragma once
#include "io/files/toml_reader.h"
#include "studies/risk/study.h"

namespace rimpact::risk {

/// `parts`: the study's, whose systems a difference must tell apart. Throws InputError "file:line:column: ...".
std::vector<Difference> read_differences(const TomlFile &file, const fleets::SweepParts &parts);

} // namespace rimpact::risk
