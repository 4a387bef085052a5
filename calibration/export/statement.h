/// The sentences every exported file begins with, made from the answer that its numbers come from.
#pragma once
#include "calibration/export/comment.h"
#include "calibration/export/exported_rim.h"

namespace rimpact::calibration {

/// Bearing, load, who was fitted, law with its numbers and intervals, range, errors on runs left out, errors of the
/// answer, strain, mesh, assumptions, doubts, validity. `law` is the answer's or what stands for it.
std::vector<std::string> statement_of(const ExportedRim &rim, const scene::StoredAnswer &answer,
                                      const scene::StoredLaw &law);

} // namespace rimpact::calibration
