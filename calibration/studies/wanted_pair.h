/// Which rims of a geometry study return a wanted constant pair (k_i, e), and at what speed of approach.
#pragma once
#include "calibration/studies/geometry_study.h"

namespace rimpact::calibration {

struct WantedPair {
  double k_i = 0, e = 0; ///< [kN/m] > 0; (0, 1)
  /// Throws InputError naming the value and its bound.
  void validate() const;
};

/// The one speed at which a rim returns the wanted e, and its stiffness there; both by the study's surrogates.
struct RimAtPair {
  std::string name;
  std::vector<double> inputs; ///< reported units, in the axes' order; the last is the speed
  double k_i;                 ///< [kN/m]
  bool met;                   ///< k_i is the wanted one within the surrogate's error
};

struct PairRegion {
  WantedPair wanted;
  double speed_error, k_i_error; ///< relative, rms: of e's surrogate over its exponent of speed, of k_i's
  std::size_t n_rims;            ///< in the study, each once
  std::vector<RimAtPair> rims;   ///< those that return e within the speeds computed
  std::string sentence;
};

/// Empty where the study has no surrogate of k_i or e, or its e falls with speed by less than the surrogate errs.
std::optional<PairRegion> pair_region(const GeometryStudy &study, const WantedPair &wanted);

nlohmann::json to_json(const PairRegion &region);

} // namespace rimpact::calibration
