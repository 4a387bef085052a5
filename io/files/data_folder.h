/// Where the data that go with the programs lie: the report's Python and the kept studies.
#pragma once
#include <string>

namespace rimpact {

/// share/rimpact beside this executable's own folder: PREFIX/bin/../share/rimpact once installed; in a build folder,
/// links into the source tree. No path is compiled in, so that an installation may be moved. Throws IoError where /proc
/// is not there.
std::string data_folder();
/// Folder of this executable. Throws IoError where /proc is not there.
std::string program_folder();

} // namespace rimpact
