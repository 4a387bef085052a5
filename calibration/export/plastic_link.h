/// The elastoplastic law as links of SAP2000 and ETABS: a Gap in series with a MultiLinear Plastic of hysteresis type
/// Kinematic.
///
/// One link alone does not do: a table that is zero up to the gap has a first segment without stiffness, and Kinematic
/// unloads along the first segment. In series the plastic link carries the dent and the gap never pulls. Kinematic
/// unloads on a line parallel to the first segment, over the forces of the first segments of both sides together; so
/// the first segment is short and as steep as the law unloads, and the tension side (never reached behind a gap) is one
/// long elastic segment: unloading is that line down to zero, and the dent stays. Takeda and Pivot unload alike but
/// reload towards the largest point; what never goes into tension is the same for them.
#pragma once
#include "calibration/export/contact.h"
#include "calibration/export/exported_rim.h"

namespace rimpact::calibration {

struct PlasticLink {
  double gap_stiffness;                    ///< of the closed gap [N/m]
  double unloading;                        ///< of the plastic link: the slope of its first segment [N/m]
  std::vector<double> displacement, force; ///< of the plastic link in compression, from (0, 0), growing [m], [N]; on
                                           ///< past the last as its last segment
};

/// Gap and plastic link in series as one contact.
class PlasticLinkContact : public RimContact {
public:
  explicit PlasticLinkContact(const PlasticLink &link);
  double force(double d, double rate) const override;
  void accept(double d) override;

private:
  double backbone(double d) const;
  std::vector<double> d_, f_;
  double unloading_, deepest_ = 0;
};

/// Vertices on the law's load path from a tenth of the smallest to 1.5 times the largest penetration of the exported
/// range; the unloading that returns closest to the law's rebound over it; the gap 100 times as stiff, its own give
/// taken off the table.
PlasticLink plastic_link(const ExportedRim &rim);

} // namespace rimpact::calibration
