/// The runs that a folder of records makes.
#pragma once
#include "studies/fleets/sweep_reader.h"

namespace rimpact::fleets {

/// A station without all of the components is left out and said. Throws InputError when the folder has none, DataError
/// for a damaged record. `sa_period` [s]: of the spectral acceleration, 0: none.
RecordCases cases_of_folder(const std::string &folder, Components components, double sa_period);

} // namespace rimpact::fleets
