/// The law of contact at a slave point whose master is carried by a deforming body, with the tangents of its traction.
#pragma once
#include "fe_contact/engine/contact_search.h"

namespace rimpact::fe {

/// The master's distance where a point is, on the deformed carrier. The gap's gradient by w, nu, has the length
/// `stretch`; it changes with w and, w held, with the carrier's own strain.
struct CarriedDistance {
  double gap;                       ///< [m]
  Eigen::Vector3d normal, gradient; ///< unit; d gap / d w
  Eigen::Matrix3d curvature;        ///< d normal / d w [1/m]
  Eigen::Vector3d nu = Eigen::Vector3d::Zero();
  double stretch = 1;

  static CarriedDistance of(const MasterSurface &master, const PointCoupling &coupling);
};

/// Tangents of a traction by w [Pa/m] and by nu [Pa].
struct TractionTangents {
  Eigen::Matrix3d by_w, by_nu = Eigen::Matrix3d::Zero();
};

/// What a point bears at the end of a step of length dt [s]: multipliers [Pa], slip since the step began [m].
struct PointLoad {
  double multiplier;
  const Eigen::Vector3d &tangential;
  Eigen::Vector3d slip;
  double dt;
};

/// The law with its tangents.
CoulombContact::Result<double> traction_at(const CoulombContact &law, const CarriedDistance &distance,
                                           const PointCoupling &coupling, const PointLoad &load,
                                           TractionTangents &tangents);

} // namespace rimpact::fe
