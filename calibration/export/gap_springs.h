/// The elastoplastic law as four OpenSees ElasticPPGap materials in parallel, tuned to the law over a range of speeds.
///
/// Each is bilinear, unloads along its first stiffness E to its own dent, and never pulls. With x = d - start it yields
/// at x = F / E, of slope eta E beyond. Where all begin with the rim they cannot follow: their unloading is their first
/// loading, while the law unloads the stiffer the deeper its dent. Perfectly plastic ones at the vertices of the load
/// path meet it exactly and return 3 times the law's rebound at 0.7 m/s. Four that may begin later add their stiffness
/// where the law is stiffer. Over a decade of speeds they meet peak force within some 4 %, rebound within 0.04 of the
/// approach speed and the peak force of a second hit within some 9 %, better over less. What is left is measured by the
/// self-check and printed. HyperbolicGapMaterial, whose unloading is free, has a state that an iteration which
/// overshoots spoils (it then presses where it is open); ImpactMaterial forgets dents.
#pragma once
#include "calibration/export/contact.h"
#include "calibration/export/exported_rim.h"

namespace rimpact::calibration {

struct GapSpring {
  double stiffness;                                                                 ///< E [N/m], > 0; of unloading too
  double yield_force;                                                               ///< [N], > 0
  double hardening;                                                                 ///< eta [-], 0..1
  double start = 0;                                                                 ///< penetration where it begins [m]
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
  double work(double d) const; ///< of pressing from the dents to d [J]

private:
  std::vector<GapSpring> springs_;
  std::vector<double> furthest_, open_; ///< of each: where it yields on, and where it lets go [m]
};

/// Four springs that stop the mass as the law does at twelve speeds, and a second time on the dent. From half the
/// exported range's first speed to the fastest it is tuned to. Deterministic.
std::vector<GapSpring> gap_springs(const ExportedRim &rim);
double total_stiffness(const std::vector<GapSpring> &springs);

} // namespace rimpact::calibration
