/// Whole scenes by the reduced models.
#pragma once
#include "reduced_models/bearings/physical_model.h"

namespace rimpact::reduced {

/// A whole scene by the reduced model named in scene.reduced.model, rim element included. A slider that
/// leaves the dish gives status "stopped" with the reason. Energy: `impact` is what the rim element has taken
/// (dissipated, plus stored while pressed); `contact` what landings after uplift have lost; a `free` scene's
/// height at the start counts as initial energy. A weightless window moves in the horizontal plane; its
/// friction, if asked for, is mu W.
struct ReducedRun {
  Response response;
  Summary summary;
};
ReducedRun simulate(const scene::Scene &scene);
/// The same by SUNDIALS CVODE with root finding, whatever scene.reduced.integrator says: the independent check of the
/// event-driven stepper. `simulate` of a scene that asks for it adds summary.extra["integrator"] (integrator_check.h).
ReducedRun simulate_with_cvode(const scene::Scene &scene);
/// Peaks and impacts only, nothing stored: the calibration's and the benchmarks' hot path.
Summary simulate_summary(const scene::Scene &scene);
/// As `simulate`, but from `start` at time start.t to t_end: one impact shot from a state just at touch, say.
/// `lateral_capacity_override` >= 0 replaces the bearing's L_c (a dented rim is touched further out; laws
/// that yield read start.rim instead). The scene's capacity_offset comes on top. Throws InputError for the
/// quasi-static kinds: they have no state to start from.
ReducedRun simulate_from(const scene::Scene &scene, const BearingState &start, double t_end,
                         double lateral_capacity_override = -1);
/// Scale of the excitation at which the rim is first touched (thesis notes, 1), by bisection to `relative`;
/// nullopt when it is not bracketed in [low, high].
std::optional<double> critical_scale(scene::Scene scene, double low = 0.2, double high = 3.0, double relative = 1e-6);

} // namespace rimpact::reduced
