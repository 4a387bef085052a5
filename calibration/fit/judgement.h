/// What is said of each fitted parameter: value, interval, and whether the data determine it.
#pragma once
#include "calibration/fit/uncertainty.h"

namespace rimpact::calibration {

/// Fills parameters, correlation and condition of `result` from a solution; decides what is identifiable.
void judge(const Problem &problem, const Eigen::VectorXd &x, const Covariance &spread, FitResult &result);

} // namespace rimpact::calibration
