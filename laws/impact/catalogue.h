/// Every impact law by its name, and their keys of [reduced].
#pragma once
#include "laws/impact/impact_law.h"

namespace rimpact::laws {

/// One a pair of files, in the order of lists.
const LawFamily &kelvin_voigt_laws();
const LawFamily &hunt_crossley_laws();
const LawFamily &elastoplastic_laws();
const LawFamily &pushed_curve_laws();

const std::vector<const ImpactLaw *> &impact_laws();
/// Throws InputError naming the known laws.
const ImpactLaw &impact_law(const std::string &name);
/// The law of scenes that name none.
const ImpactLaw &default_law();
/// Where a rim that yields lets go on the way back from `deepest`, both [m]: the dent that stays. By bisection.
double residual_indentation(const RimElement &rim, double deepest);
/// Of every family, in its order.
const std::vector<LawParameter> &law_parameters();
/// k_i, e, the law and the numbers it reads.
void visit(KeyVisitor &visitor, LawNumbers &numbers, const ImpactLaw *&law);

} // namespace rimpact::laws
