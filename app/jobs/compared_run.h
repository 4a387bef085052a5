/// A run or table that `compare` reads, and what its folder says of it.
#pragma once
#include "app/words/scene_differences.h"
#include "responses/response.h"
#include <string>
#include <vector>

namespace rimpact::app {

/// What is compared: a response, and the scene it is of where that is known.
struct ComparedRun {
  std::string path, scene; ///< the scene's text, resolved; empty: not known
  std::string carried;     ///< by how many bearings; empty: not known
  std::string solver;      ///< rung, or the reduced model; empty: not known
  std::string doubt;       ///< why its figures are no result; empty: nothing is known against them
  Response response;
};

/// Of a run folder, an .h5 or .csv, or a mapping file. Throws DataError where a signal is missing, or where a bare
/// table holds noise that would be taken for contact.
ComparedRun read_compared(const std::string &path);

/// Differences between their scenes, without settings that one of the two runs does not read, and who solved them.
std::vector<Difference> differences_between(const ComparedRun &a, const ComparedRun &b);

} // namespace rimpact::app
