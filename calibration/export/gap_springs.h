/// The elastoplastic law as four OpenSees ElasticPPGap materials in parallel, tuned to the law over a range of speeds.
///
/// Each is bilinear, unloads along its first stiffness E to its own dent, and never pulls: penetration d, yield at F /
/// E, slope eta E beyond. One of them alone cannot follow: its unloading is its first loading, so a spring that bends
/// late gives back the more. Perfectly plastic ones at the vertices of the load path meet it exactly and return 3
/// times the law's rebound at 0.7 m/s. Four, fitted together, meet peak force within some 8 % and rebound within 0.15
/// of the approach speed over a decade of speeds, better over less. What is left is measured by the self-check and
/// printed. HyperbolicGapMaterial, whose unloading is free, follows better, but its state is spoiled by an iteration
/// that overshoots (it then presses where it is open); ImpactMaterial forgets dents.
#pragma once
#include "calibration/export/contact.h"
#include "calibration/export/exported_rim.h"

namespace rimpact::calibration {

struct GapSpring {
  double stiffness;                                                                 ///< E [N/m], > 0; of unloading too
  double yield_force;                                                               ///< [N], > 0
  double hardening;                                                                 ///< eta [-], 0..1
  double force(double d) const;                                                     ///< first loading [N]
  double work(double d) const;                                                      ///< of first loading to d [J]
  double returned(double d) const { return force(d) * force(d) / (2 * stiffness); } ///< on the way back from d [J]
};

/// In parallel, with the state rules of OpenSees' EPPGapMaterial ("damage": the dent stays).
class GapSpringsContact : public RimContact {
public:
  explicit GapSpringsContact(std::vector<GapSpring> springs);
  double force(double d, double rate) const override;
  void accept(double d) override;

private:
  std::vector<GapSpring> springs_;
  std::vector<double> furthest_, open_; ///< of each: where it yields on, and where it lets go [m]
};

/// Four springs that stop the mass as the law does at ten speeds over the exported range. Deterministic.
std::vector<GapSpring> gap_springs(const ExportedRim &rim);
double total_stiffness(const std::vector<GapSpring> &springs);

} // namespace rimpact::calibration
