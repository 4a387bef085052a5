/// Doubts of one kind as one line.
#pragma once
#include <string>
#include <vector>

namespace rimpact::calibration {

/// Sentences that differ in a run's name and in numbers alone become one, in the place of the first: how many there
/// are, and the one whose first differing number is largest in size. Others stay as they are.
std::vector<std::string> said_once(const std::vector<std::string> &sentences);

} // namespace rimpact::calibration
