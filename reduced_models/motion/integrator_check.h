/// Whether two integrators give one motion: CVODE and our own steps go through the same branches and share neither
/// method, step control nor the search for events.
#pragma once
#include "responses/summary.h"
#include <string>

namespace rimpact::reduced {

/// What two runs of one scene differ by, for summary.extra["integrator"]: peaks and ends by their absolute difference,
/// forces by their relative one; of the impacts the largest, where both have as many (else left out).
nlohmann::json integrator_check(const Summary &cvode, const Summary &own);
/// One line of it.
std::string integrator_in_words(const nlohmann::json &check);

} // namespace rimpact::reduced
