/// The rigid bodies and contacts of a DCFP (slider, top plate) or LIR-DCFP (bottom slider, top slider, top
/// plate) bearing (thesis 3.3), and its configurations. The bottom plate is the ground, its vertex the
/// origin, z up. Planar: 5 (DCFP) or 8 (LIR) dofs; spatial: 9 or 15, and 12 or 18 when the top plate is free
/// to rotate.
#pragma once
#include "reduced_models/building_recorder.h"
#include "reduced_models/rigid_body/stepper.h"
#include "scene/scene.h"

namespace rimpact::reduced::rigid {

/// c of a contact point [N s/m], 2 xi sqrt(k m). Damped mass "supported": m is the supported mass times n_sets /
/// points, which on `n_sets` sets of `points` points in series comes back with the contact's restitution. "bearing": m
/// is the bearing's own reduced mass, as (3-46) prints it.
double contact_damping(const scene::DoubleConcave &bearing, double supported_mass, int n_sets);

class DoubleConcaveSystem {
public:
  explicit DoubleConcaveSystem(const scene::Scene &scene);

  System system;
  int plate, top_slider;   ///< indices of bodies; the bottom slider is 0
  bool driven;             ///< a quasi-static kind: the plate follows a path
  Superstructure building; ///< its floors are the bodies above the plate, its storeys the system's links

  /// At rest, or with the plate displaced and moving on its sphere of radius R_eff, sliders following.
  MotionState state_at(const Eigen::Vector2d &displacement, const Eigen::Vector2d &velocity) const;

  Eigen::Vector3d plate_displacement(const MotionState &state) const; ///< from unloaded rest on the axis
  /// Of the top slider's interface past the bottom slider's, in its plane [m]; zero for a DCFP.
  Eigen::Vector3d interface_slip(const MotionState &state) const;
  double tilt(const MotionState &state) const; ///< of the bottom slider's axis [rad]
  double gap(const MotionState &state) const;  ///< C_t - |u - slip|
  double potential_energy(const MotionState &state) const;
  double stored_energy(const MotionState &state) const;         ///< in the normal contacts' springs [J]
  BuildingSnapshot building_at(const MotionState &state) const; ///< only of one that is there
  /// Why a run cannot go on: the slider has left a rim or the stop, or overturned; null otherwise.
  const char *lost(const MotionState &state) const;

private:
  void add_bodies(const scene::Scene &scene);
  void add_points(const scene::DoubleConcave &b);
  void add_walls(const scene::DoubleConcave &b);
  scene::DoubleConcave bearing_;
  bool resilient_;
  int n_sets_;
};

} // namespace rimpact::reduced::rigid
