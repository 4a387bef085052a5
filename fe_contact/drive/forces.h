/// Forces of the bearing on what it carries, and a row of signals an instant.
#pragma once
#include "fe_contact/drive/run_record.h"
#include "fe_contact/rungs/bearing_model.h"
#include "fe_contact/rungs/rim_frame.h"
#include <optional>
#include <string>

namespace rimpact::fe {

/// The steel of a state by its places; `frame`: where the mesh stands in the bearing, none where it is the bearing's.
SteelReport steel_of(const BearingModel &model, const SystemState &state, const std::optional<RimFrame> &frame = {});

/// Whole bearing, in the plate's frame [N]; the solids' own inertia is left out.
struct BearingForces {
  Eigen::Vector3d pendular = Eigen::Vector3d::Zero(), friction = Eigen::Vector3d::Zero(), rim = Eigen::Vector3d::Zero();
  std::optional<double> normal; ///< of the dish; none: no dish is there
  Eigen::Vector3d total() const { return pendular + friction + rim; }
};
/// Of the solids' contacts. Where the dish is a law it adds its own.
BearingForces forces_of(const BearingSystem &system, const SystemState &state);

/// A sentence where the slider's halves have slipped to their stop, which no solid is; `where`: "t = 1.2 s".
std::optional<std::string> stop_of_halves(const BearingSystem &system, const SystemState &state,
                                          const std::string &where);

/// An instant of a run as its response stores it.
struct Instant {
  double time;          ///< [s], or the load parameter
  Eigen::Vector3d u, v; ///< of the slider, from rest on the vertex, in the plate's frame
  BearingForces forces;
  double gap; ///< L_c - |u|, u without what the slider's halves have slipped apart [m]
  int newton_iterations;
  double step; ///< taken [s], or of the load parameter
};
/// With the state's gap, pressure and strain, and the energies of the record's ledger as it stands.
void sample(RunRecord &record, const BearingSystem &system, const SystemState &state, const Instant &instant);

} // namespace rimpact::fe
