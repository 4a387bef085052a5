/// The same branches and events as `HybridRun`, integrated by SUNDIALS CVODE (BDF, dense Newton, its own root
/// finder): the independent check of the event-driven stepper.
#pragma once
#include "reduced_models/record/recorder.h"

namespace rimpact::reduced {

/// Runs from `start` to t_end. True: the building has collapsed, which ended the run. Throws SolverStopped when CVODE
/// gives up.
bool run_with_cvode(const Dynamics &dynamics, const scene::Scene &scene, const BearingState &start, double t_end,
                    Recorder &recorder);

} // namespace rimpact::reduced
