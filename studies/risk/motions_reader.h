/// Reads [motions] of a study: folders of records, a table or sets of them, and how they are scaled.
#pragma once
#include "io/files/toml_reader.h"
#include "studies/risk/study.h"

namespace rimpact::risk {

/// A file or folder named in a study, by its absolute name: it is sought beside the study's file `origin`.
std::string beside(const std::string &origin, const std::string &name);

/// Throws InputError "file:line:column: ...".
MotionSource read_motions(const TomlFile &file, const std::string &origin);

} // namespace rimpact::risk
