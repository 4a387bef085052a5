/// The bearing slid out quasi-statically to just short of the rim, under its dead load: the same for every window of
/// one bearing, mesh and direction, whatever its speed. It is kept beside the results, in the folder `slid-out` next to
/// the run's, and taken from there only where everything that shapes it is the same, the program included.
#pragma once
#include "fe_contact/drive/top_drive.h"
#include "fe_contact/planning/plan.h"

namespace rimpact::fe {

struct RunOptions;

class CachedPreload {
public:
  /// Nothing is kept, and nothing found, where the run keeps no files.
  CachedPreload(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options);

  /// Into a state of the same system, the drive that brought it there, and the top face's height at rest on the vertex
  /// [m]. False: none is kept, or it is not whole.
  bool take(SystemState &state, TopDrive &drive, double &rest_height) const;
  /// Throws IoError. State and drive stay as they are.
  void keep(SystemState &state, TopDrive &drive, double rest_height) const;
  /// Its file; empty: none.
  const std::string &path() const { return path_; }

private:
  std::string key_, path_; ///< what it is of, in words
  bool writes_ = false;
};

} // namespace rimpact::fe
