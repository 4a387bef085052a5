/// Whose a folder is: a run's folder holds the result of one scene, a sweep's or a study's the results of one sweep or
/// study, and one process at a time writes there.
#pragma once
#include "app/console/console.h"
#include "app/jobs/main_jobs.h"
#include "io/files/folder_lock.h"
#include "responses/kept_run.h"

namespace rimpact::app {

/// What a run is about to do with a folder.
struct FolderUse {
  std::string given; ///< SCENE as it was typed
  std::string folder;
  bool finite_elements = false, resume = false, force = false;
};
struct ClaimedFolder {
  FolderLock lock;
  bool finished =
      false; ///< to be resumed, but the folder's run of this very scene has ended well: nothing is left to do
};
/// Takes the folder for a run of the scene. Throws IoError (exit code 6) while another process has it, InputError (2)
/// where it holds a run of another scene, the other kind of run, a sweep or a study, unless `force`; or where the
/// user's own scene file would be replaced, force or not. What an earlier run left and this one would not replace is
/// removed. A reduced run of the same name, a scene being edited, may be replaced: it takes a moment to make again;
/// that is said.
ClaimedFolder claim_for_run(const FolderUse &use, const scene::Scene &scene, Console &console);

/// Takes a folder of many runs. `part` of shards that run side by side ("2-of-3").
/// Throws as claim_for_run where the folder holds something else, or runs of another scene (by the same program;
/// another version's jobs may differ without the user's doing: these are run again).
FolderLock claim_for_jobs(const std::string &folder, Collection kind, const std::vector<Job> &jobs, bool force,
                          const std::string &part = "");

/// "2-of-3"; empty for the whole.
std::string part_name(int shard, int n_shards);

} // namespace rimpact::app
