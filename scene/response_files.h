/// The two file forms of a response, from and to bytes.
#pragma once
#include "scene/response.h"
#include <string>

namespace rimpact::scene {

/// Throw DataError; `path` is for messages only.
Response parse_hdf5(const std::string &bytes, const std::string &path);
Response parse_csv(const std::string &text, const std::string &path);

} // namespace rimpact::scene
