/// What results hold, each name with a sentence: signals of response.h5, columns of tables, files, exit codes.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace rimpact::app {

using NamedTexts = std::vector<std::pair<std::string, std::string>>;
NamedTexts signals();    ///< unit and description; those of one bearing and one floor stand for all
NamedTexts columns();    ///< of response.csv, the signal each holds
NamedTexts files();      ///< of run folders, sweeps, calibrations and the main job
NamedTexts exit_codes(); ///< as shells see them

} // namespace rimpact::app
