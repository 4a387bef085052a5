/// Commands that tell what a calibration does not know, each with the minutes it takes by what the run itself took.
#pragma once
#include "calibration/answer/answer_error.h"
#include "calibration/fit/run_facts.h"

namespace rimpact::calibration {

/// `run` is of finite elements and hits the rim; `facts` are its own. Each is written for the run's folder, which holds
/// its scene.toml. Outputs go beside it, where the next `calibrate` finds them.
Finding find_step(const StoredRun &run, const RunFacts &facts);
Finding find_rung(const StoredRun &run, const RunFacts &facts);
/// By rim curves over the first of `keys` (of a bearing, with its value) that a push of the rim feels; none where it
/// feels none.
std::optional<Finding> find_geometry(const StoredRun &run, const RunFacts &facts,
                                     const std::vector<scene::Assumption> &keys);

/// Whether a bearing's number takes part in runs of such a rung: pad, foot and friction do not in rung rim.
bool takes_part(const std::string &key, scene::Rung rung);

} // namespace rimpact::calibration
