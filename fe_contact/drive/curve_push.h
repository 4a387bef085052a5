/// Makes a rim curve: rung rim's solids are pushed quasi-statically, and unloaded from copies of their state on the
/// way.
#pragma once
#include "fe_contact/drive/run.h"
#include "reduced_models/bearings/rim_curve_file.h"

namespace rimpact::fe {

struct CurveOrder {
  double mass = 86952;    ///< that comes at `speed` [kg], > 0
  double speed = 0.72;    ///< fastest approach the curve stops [m/s], > 0
  int unloadings = 10;    ///< at speeds up to it, closer where they are low, >= 3
  bool estimate = true;   ///< of the mesh's error, by a loading on the next coarser mesh
  bool held_only = false; ///< without the path along the dish, and so without the estimate, which is made on it
};
/// Of the scene's bearing on its mesh; the rest of the scene is not read. Throws InputError where the order or the
/// bearing will not do, SolverStopped, Interrupted.
reduced::RimCurveFile push_rim_curve(const scene::Scene &scene, const CurveOrder &order, const RunOptions &options);

} // namespace rimpact::fe
