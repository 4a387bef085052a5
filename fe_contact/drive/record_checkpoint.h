/// What every rung's checkpoint holds: what the run is of, its record, and the arrays of a state.
#pragma once
#include "fe_contact/drive/checkpoint.h"
#include "fe_contact/drive/run_record.h"
#include "fe_contact/engine/solid.h"

namespace rimpact::fe {

std::vector<double> list(const Eigen::VectorXd &v);
Eigen::VectorXd vector(const std::vector<double> &v);
std::vector<double> list(const SolidHistory &history); ///< 9 numbers a point
/// A field of as many material points as `history` has. Throws DataError.
void restore(const Checkpoint &file, const std::string &name, SolidHistory &history);
/// Vectors of motion: as many values as they have; `last_change` may be empty while there was no step (last_dt 0).
void restore(const Checkpoint &file, const std::string &name, Eigen::VectorXd &v);
Eigen::VectorXd last_change(const Checkpoint &file, const std::string &name, double last_dt, std::size_t n);

std::vector<double> list(const Impact &impact);
Impact impact_from(const Checkpoint &file, const std::string &name);

inline std::string checkpoint_of(const RunOptions &options) {
  return options.folder + "/checkpoint.h5";
}

/// A checkpoint that says what is run here and holds nothing yet: written before the first step, so that a run that is
/// killed early is known again.
void begin_checkpoint(const RunOptions &options, const RunRecord &record);
/// The folder's checkpoint. Throws DataError where there is none, where it is damaged, or of another scene, other files
/// or another version, which it says.
Checkpoint kept_checkpoint(const RunOptions &options, const RunRecord &record);
/// It was written by begin_checkpoint.
bool has_only_begun(const Checkpoint &file);

/// What the run is of, and the record.
void put(Checkpoint &file, const RunRecord &record);
void get(const Checkpoint &file, RunRecord &record); ///< of kept_checkpoint; throws DataError

} // namespace rimpact::fe
