/// The folder of a fleet: whose it is, and whether its rows are still those that the same call would compute.
#pragma once
#include "responses/identity.h"
#include "studies/fleets/fleet.h"

namespace rimpact::fleets {

/// What makes two fleets the same, and their rows.
struct FleetIdentity {
  std::string scene_name; ///< as it was typed
  std::string sweep;      ///< of its keys, the number of runs, the overrides and the model's name
  std::string values;     ///< of every run's values; those of a folder of records follow from the files
  Identity rows;          ///< of the scene's text and its first run, of every file any run reads, of the program
};
/// Throws DataError where a file cannot be read.
FleetIdentity fleet_identity(const std::string &where, const std::vector<std::string> &overrides, const Sweep &sweep,
                             const scene::Scene &first, const FleetModel &model = reduced_models());

/// Throws InputError where the folder holds another sweep or another kind of result, unless options.force; DataError
/// where its fleet.json is damaged. Rows of other inputs or of another version are removed, which options.remark is
/// told, and fleet.json is written anew.
void open_folder(const FleetIdentity &identity, const Sweep &sweep, const FleetOptions &options);
/// Throws IoError where another call has taken the folder for other inputs since: its rows and these must not stand in
/// one table.
void require_still_ours(const FleetIdentity &identity, const std::string &folder);

} // namespace rimpact::fleets
