/// Which of the varied rims meets its limits, and how sure that is.
#pragma once
#include "calibration/studies/vary_study.h"

namespace rimpact::calibration {

struct VaryAnswer {
  std::optional<std::vector<double>> design; ///< the keys' values of the rim to prove; none: no rim has a result
  std::optional<VaryPoint> predicted;        ///< there
  double force_error = 0;                    ///< relative: curve and interpolation, summed in squares
  std::vector<VaryPoint> between;            ///< of one key: as interpolated over its range
  bool reached = false;                      ///< it meets the targets, and its steel its limit
  std::string sentence;
};
VaryAnswer vary_answer(const std::vector<VaryPoint> &points, const VaryQuestion &question);

} // namespace rimpact::calibration
