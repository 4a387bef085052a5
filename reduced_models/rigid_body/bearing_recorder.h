/// Stores what a rigid-body bearing does, and keeps its extremes and energies.
#pragma once
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/motion/step_budget.h"
#include "reduced_models/rigid_body/heat_memory.h"
#include "reduced_models/rigid_body/rigid_bearing.h"
#include "reduced_models/rigid_body/triple_faces.h"
#include "reduced_models/rigid_body/wall_memory.h"
#include "reduced_models/simulate.h"

namespace rimpact::reduced::rigid {

class BearingRecorder {
public:
  /// `time_unit`: `time` of the response is t / time_unit (1, or a quasi-static run's duration).
  BearingRecorder(RigidBearing &model, const scene::Scene &scene, double time_unit, ReducedRun &result);
  void begin(const MotionState &state);
  void count(const StepReport &report);
  /// After a step: stores it when a sample is due or a rim is, or was, pressed; remembers dents.
  void accept(const MotionState &state, const MotionState &before);
  double next_sample(const MotionState &state) const; ///< instant that must be a step's end
  void end(const MotionState &state);
  bool collapsed() const { return collapse_time_.has_value(); } ///< the building has
  void stop(const MotionState &state, const std::string &reason);

private:
  void store(const MotionState &state);
  void watch(const MotionState &state);
  EnergyLedger ledger(const MotionState &state) const;

  RigidBearing &model_;
  ReducedRun &result_;
  scene::GroundMotion ground_;
  double time_unit_, sample_, potential_ = 0, stored_ = 0, initial_ = 0, largest_input_ = 0, last_ = -1;
  double rest_height_ = 0;
  std::vector<std::string> points_;            ///< signal of each contact, normal_A1 ..., empty for rims
  std::vector<std::string> temperatures_;      ///< signal of each joint's steel, or empty
  std::vector<std::vector<double> *> columns_; ///< of the response, in the order they are stored
  std::vector<double> largest_normal_, smallest_normal_;
  TripleFaces faces_; ///< only of a triple pendulum
  WallMemory walls_;
  HeatMemory heat_;
  bool heats_;
  StepCount steps_;
  BuildingRecorder building_;
  std::optional<double> collapse_time_;
  double largest_travel_ = 0, largest_lateral_ = 0, largest_height_ = -1e300, smallest_on_plate_ = 1e300;
  double largest_moment_ = 0, largest_vertical_ = 0, smallest_vertical_ = 1e300;
};

} // namespace rimpact::reduced::rigid
