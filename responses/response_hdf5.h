/// Responses as HDF5 files.
#pragma once
#include "responses/response.h"

namespace rimpact {

/// Files are written beside their final name and renamed, so a full disk or a killed run leaves earlier results
/// readable. Throw IoError.
void write_hdf5(const Response &response, const std::string &path);
/// Throws DataError; `path` is for messages only.
Response parse_hdf5(const std::string &bytes, const std::string &path);

} // namespace rimpact
