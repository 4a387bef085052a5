/// How a run of a measured table is named: FILE.toml, or FILE.toml#TEST where a file holds several.
#pragma once
#include "calibration/data/mapping.h"

namespace rimpact::calibration {

struct MeasuredName {
  std::string file, test; ///< no test: all of the file
};
/// None: the path is no mapping file, with or without a test.
std::optional<MeasuredName> measured_name(const std::string &path);
/// Whether a run is named by a mapping file.
bool is_mapping(const std::string &path);

/// The part of `mapping` that the name says. Throws InputError naming the tests there are where it has none of that
/// name, or where the name says none and there are several.
TestPart named_part(const Mapping &mapping, const MeasuredName &name, const std::vector<std::string> &tests);

/// Each mapping file with several tests replaced by its tests, in their order; all else as it is. Throws as
/// read_mapping() and MeasuredTable do.
std::vector<std::string> each_test(const std::vector<std::string> &paths);

} // namespace rimpact::calibration
