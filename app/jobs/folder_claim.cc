#include "app/jobs/folder_claim.h"

#include "io/files/file.h"
#include "responses/response.h"
#include "scene/toml_writer.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

constexpr const char *cure = "choose another folder with -o, or replace it with --force";

/// The reason against taking the folder for a run; empty: none.
std::string objection(const FolderUse &use, const KeptRun &kept) {
  if (const auto what = collection_in(use.folder)) return "holds " + word(*what);
  if (!kept.any) return {};
  if (kept.finite_elements != use.finite_elements)
    return kept.finite_elements ? "holds a run by finite elements" : "holds a run by the reduced model";
  if (kept.other_scene.empty() || use.resume) return {}; // a checkpoint says itself what it is of
  const bool edited = !use.finite_elements && !kept.other_name;
  return edited ? "" : fmt::format("holds a run of another scene ({})", kept.other_scene);
}

/// Leaves nothing that would stand beside the new result as if it were part of it.
void clear(const FolderUse &use, const KeptRun &kept, const scene::Scene &scene, Console &console) {
  remove_unfinished(use.folder);
  if (use.resume && use.finite_elements) return;
  if (kept.any && !kept.other_scene.empty())
    console.message(fmt::format("{}: the run of another scene there is replaced ({})", use.folder, kept.other_scene));
  else if (kept.any && !kept.changed.empty())
    console.detail(fmt::format("{}: the run there is replaced; {}", use.folder, kept.changed));
  if (kept.any && (use.finite_elements != kept.finite_elements || (use.finite_elements && !kept.is_current())))
    remove_run(use.folder);
  else if (kept.any) // else nothing there is a run's
    remove_by_products(use.folder);
  if (use.finite_elements)
    write_atomically(scene::to_toml(scene), use.folder + "/scene.toml"); // what is run here, should it be killed
}

} // namespace

ClaimedFolder claim_for_run(const FolderUse &use, const scene::Scene &scene, Console &console) {
  keep_scene_file(use.given, scene, use.folder);
  console.made_folder = use.folder;
  ClaimedFolder claimed{FolderLock(use.folder)};
  const KeptRun kept = kept_run(use.folder, scene);
  const std::string against = use.force ? "" : objection(use, kept);
  if (!against.empty()) throw InputError(fmt::format("{} {}; {}", use.folder, against, cure));
  claimed.finished = use.resume && kept.is_current() && kept.status == RunStatus::done;
  if (!claimed.finished) clear(use, kept, scene, console);
  return claimed;
}

FolderLock claim_for_jobs(const std::string &folder, Collection kind, const std::vector<Job> &jobs, bool force,
                          const std::string &part) {
  FolderLock lock(folder, part);
  if (force) return lock;
  if (const auto what = collection_in(folder); what && *what != kind)
    throw InputError(fmt::format("{} holds {}; {}", folder, word(*what), cure));
  std::error_code none;
  if (std::filesystem::exists(folder + "/summary.json", none))
    throw InputError(fmt::format("{} holds a run; {}", folder, cure));
  for (const auto &job : jobs) {
    const auto kept = kept_run(job.folder, job.scene);
    if (kept.any && !kept.other_scene.empty() && kept.same_program)
      throw InputError(fmt::format("{} holds {} of another scene ({}: {}); {}", folder, word(kind), job.name,
                                   kept.other_scene, cure));
  }
  return lock;
}

std::string part_name(int shard, int n_shards) {
  return n_shards > 1 ? fmt::format("{}-of-{}", shard, n_shards) : "";
}

} // namespace rimpact::app
