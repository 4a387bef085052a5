/// What a self-check says: for a file's head, for the terminal, as JSON.
#pragma once
#include "calibration/export/self_check.h"

namespace rimpact::calibration {

std::string sentence_of(const SelfCheck &check);
/// With their numbers: second hits and pulses beyond what is tolerated.
std::vector<std::string> doubts_of(const SelfCheck &check);
/// For a file's head: the sentence, one line a row, and the doubts.
std::vector<std::string> lines_of(const SelfCheck &check);
nlohmann::json to_json(const SelfCheck &check);

} // namespace rimpact::calibration
