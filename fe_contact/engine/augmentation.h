/// The multipliers of a contact's next augmentation. More Gauss points than a face has room for would over-constrain it
/// if each had a multiplier of its own: the pressures oscillate (the inf-sup condition fails). Multipliers are
/// therefore the tractions' least-squares fit over a face's active points, bilinear for Q2 and constant for Q1; the
/// penalty sees every point.
#pragma once
#include "fe_contact/engine/contact_search.h"
#include "fe_contact/engine/surface_contact_state.h"

namespace rimpact::fe {

/// Multipliers, and how far they are from the present ones over the penalty: the gap and the stick's slip, in the
/// multipliers' sense, that are left [m].
struct Augmentation {
  std::vector<double> multiplier;          ///< [Pa]
  std::vector<Eigen::Vector3d> tangential; ///< [Pa]
  double gap_left = 0, slip_left = 0;
};

/// Of an evaluated state; `degree`: of the solids' shape functions.
Augmentation augmentation(const ContactSearch &search, const CoulombContact &law, int degree,
                          const SurfaceContactState &state);

/// What the normal multipliers are for the next step: none (a penalty's conservative spring), those of the next
/// augmentation, or those the step was solved with: where augmentation was broken off the next ones would be a jolt.
enum class NextMultipliers { none, augmented, same };

struct Renewal {
  NextMultipliers normal = NextMultipliers::augmented;
  double share = 1; ///< of the way to the augmented multipliers, in a step too short for the whole
};

} // namespace rimpact::fe
