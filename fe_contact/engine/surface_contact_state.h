/// What a frictional contact keeps for each of its slave points, from evaluation to evaluation and from step to step.
#pragma once
#include "fe_contact/laws/coulomb.h"
#include <Eigen/Core>
#include <vector>

namespace rimpact::fe {

/// Per slave point; trial/committed by the caller.
struct SurfaceContactState {
  std::vector<double> multiplier;          ///< normal [Pa]
  std::vector<Eigen::Vector3d> tangential; ///< friction multiplier [Pa]
  std::vector<Eigen::Vector3d> start;      ///< position relative to the carrier at the step's start [m]
  std::vector<double> gap, pressure;       ///< at the last evaluation [m], [Pa]
  std::vector<Eigen::Vector3d> friction;   ///< [Pa]
  /// The friction by the slip as it is measured, in the carrier's reference configuration: F^T friction [Pa].
  std::vector<Eigen::Vector3d> pulled_back;
  std::vector<ContactStatus> status;
  /// Opposite the master, not past its edge; settled once a step, so that Newton does not chatter: within a step
  /// a point that crosses the edge sees the surface go on.
  std::vector<char> covered;
  std::vector<int> opposite; ///< carrier face last found opposite, -1: none
  /// Overlap with which a point came over a free edge [m], >= 0: what it bears is measured from there. It is given up
  /// along the point's path over the master, by its own width, as the area that it stands for comes over the edge.
  std::vector<double> entry;
  double stiffening = 1;        ///< factor on the stated penalties where augmentation alone was slow
  std::vector<double> change{}; ///< of the pressures over the last step [Pa]; empty: none yet

  /// Of n points that bear nothing. They are covered, so that what overlaps from the start bears; `start` is left out.
  static SurfaceContactState of(std::size_t n);
  void note_change(const std::vector<double> &pressures_before);
  /// lambda <- lambda + times * the pressure's last change, not below 0, where a point bears. The gap left is then the
  /// pressure's second difference over the penalty and not its first, which would give back the integral of (dp)^2 /
  /// eps over an impact: energy from nothing, in proportion to the step.
  void expect(double times);
};

} // namespace rimpact::fe
