/// Whether a run stayed where its models hold: within the rim's thickness, the speeds its element was fitted to, and
/// the plastic strain the steel is trusted to.
#pragma once
#include "responses/summary.h"

namespace rimpact {

/// Gives the summary's steel the limits of its places (steel_limits.h). Sets summary.extra (docs/interface.md):
/// `beyond_rim` (true: pressed deeper than the rim is thick; null: a model without a rim of that kind), `beyond_fit`
/// (true: an approach outside reduced.fitted_from_m_per_s to _to_; null: no range is known), `strain_limit`
/// ({limit, largest, exceeded, assumption}; null: no strain, or no limit), `rim_foot` (foot_report.h; null: no finite
/// elements), `hit_limits` (hit_limits.h). Sentences go behind those of extra["warnings"]. To be called once, after the
/// impacts and the strain are in the summary; for any rung, the reduced models too.
void judge(const scene::Scene &scene, Summary &summary);

} // namespace rimpact
