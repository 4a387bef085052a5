/// What every run's checkpoint holds: what the run is of, and its record.
#pragma once
#include "fe_contact/drive/checkpoint.h"
#include "fe_contact/drive/run_record.h"
#include "fe_contact/drive/state_visitor.h"

namespace rimpact::fe {

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

/// What the run is of, and the record; a reader's file is kept_checkpoint's.
void visit(StateVisitor &v, RunRecord &record);

} // namespace rimpact::fe
