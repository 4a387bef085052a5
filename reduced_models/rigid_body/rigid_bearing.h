/// The rigid bodies and contacts of a bearing between two plates, and its configurations: DCFP (slider, top plate),
/// LIR-DCFP (two halves, top plate; thesis 3.3), TFP (slide plate, inner slider, slide plate, top plate). The bottom
/// plate is the ground, its vertex the origin, z up. Planar: 5, 8 or 11 dofs; spatial: 9, 15 or 21, and three more when
/// the top plate is free to rotate.
#pragma once
#include "reduced_models/bearings/foot_limit.h"
#include "reduced_models/record/building_recorder.h"
#include "reduced_models/rigid_body/bearing_parts.h"
#include "reduced_models/rigid_body/stepper.h"
#include "scene/scene.h"

namespace rimpact::reduced::rigid {

/// c of a contact point [N s/m], 2 xi sqrt(k m). Damped mass "supported": m is the supported mass times n_sets /
/// points, which on `n_sets` sets of `points` points in series comes back with the contact's restitution. "bearing": m
/// is the bearing's own reduced mass, as (3-46) prints it.
double contact_damping(const scene::Isolator &bearing, double supported_mass, int n_sets);

class RigidBearing {
public:
  explicit RigidBearing(const scene::Scene &scene);

  System system;
  bool driven; ///< a quasi-static kind: the plate follows a path
  Parts parts;
  int plate; ///< index of the top plate's body; below it are the sliders, from 0
  bool triple() const { return parts.joints.size() == 4; }
  Superstructure building; ///< its floors are the bodies above the plate, its storeys the system's links

  /// At rest, or with the plate displaced and moving on its sphere of radius R_eff, sliders following in line.
  MotionState state_at(const Eigen::Vector2d &displacement, const Eigen::Vector2d &velocity) const;

  Eigen::Vector3d plate_displacement(const MotionState &state) const; ///< from unloaded rest on the axis
  /// Of the top slider's interface past the bottom slider's, in its plane [m]; zero where there is none.
  Eigen::Vector3d interface_slip(const MotionState &state) const;
  /// Of a triple pendulum: the part of the plate's displacement that is of face `joint`, R_eff times the turn of the
  /// bodies on each other; their sum is the displacement [m].
  Eigen::Vector2d travel(const MotionState &state, int joint) const;
  double tilt(const MotionState &state) const; ///< of the bottom slider's axis [rad]
  double gap(const MotionState &state) const;  ///< C - |u - slip|
  double potential_energy(const MotionState &state) const;
  double stored_energy(const MotionState &state) const;         ///< in the normal contacts' springs [J]
  BuildingSnapshot building_at(const MotionState &state) const; ///< only of one that is there
  /// Why a run cannot go on: a slider has left a rim or the stop, broken a rim off, or overturned; null otherwise.
  const char *lost(const MotionState &state) const;

private:
  void add_bodies(const scene::Scene &scene);
  scene::Isolator bearing_;
  double capacity_;
  struct Foot {
    FootLimit limit;
    std::string gone; ///< what `lost` says of it
  };
  std::array<Foot, max_sets> foot_; ///< of each joint's rim
  const Foot *broken_foot(const MotionState &state) const;
};

} // namespace rimpact::reduced::rigid
