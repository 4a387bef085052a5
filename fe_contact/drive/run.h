/// Runs a scene by finite elements. No deal.II in this header.
#pragma once
#include "fe_contact/planning/plan.h"
#include "meshes/hex_mesh.h"
#include "responses/summary.h"
#include <atomic>
#include <functional>

namespace rimpact::fe {

/// What a run does at the moment.
enum class Phase { flight, sliding, sliding_out, near_rim, contact, pressing, held, dish };
constexpr auto choices(Phase) {
  using enum Phase;
  return choices_of<Phase>({{flight, "flight"},
                            {sliding, "sliding"},
                            {sliding_out, "sliding out"},
                            {near_rim, "near the rim"},
                            {contact, "contact"},
                            {pressing, "pressing"},
                            {held, "held", "a rim pushed by itself"},
                            {dish, "dish", "the same with its dish below"}});
}

/// What a progress line shows (docs/interface.md).
struct Progress {
  double time, end_time, step;
  int newton_iterations;
  double gap, force; ///< L_c - |u| [m], negative while the rim is pressed; of the rim, or of a path's drive [N]
  Phase phase;
};
struct RunOptions {
  std::string folder; ///< run folder to write
  bool resume = false;
  bool fields = true;      ///< VTU files and pictures
  double fields_every = 0; ///< of an impact [s]; 0: at its deepest and its end alone
  bool writes = true;      ///< false: a rank that computes along and leaves the files to the first one
  std::function<void(const Progress &)> progress;
  std::function<void(const std::string &)> remark; ///< told what the user should know at once
  const std::atomic<bool> *interrupted = nullptr;  ///< set by Ctrl-C
  std::function<void(Summary &)> annotate;         ///< adds keys to the summary of a run that ended well

  bool keeps_files() const { return writes && !folder.empty(); }
  bool keeps_fields() const { return fields && keeps_files(); }
};

/// Throws InputError when this build cannot run the scene (see planning::refusal).
void check_supported(const scene::Scene &scene);

/// Writes the run folder whatever happens (partial results, status, checkpoint). Returns the summary.
/// Throws SolverStopped, Interrupted after writing.
Summary run(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options);

/// What the scene's run is solved on: built-in, or the scene's own mesh. Throws DataError for one that does not fit.
meshes::HexMesh mesh_of(const scene::Scene &scene, const planning::Plan &plan);

/// Whether this process is alone, or the first of `mpirun -np N`.
bool is_first_rank();
/// Whether it is so on any rank; every rank must ask.
bool on_any_rank(bool here);

} // namespace rimpact::fe
