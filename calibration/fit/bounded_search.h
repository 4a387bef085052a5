/// How Ceres' trust region is set up by the searches of a fit: dense, silent, within bounds.
#pragma once
#include <ceres/ceres.h>
#include <glog/logging.h>

namespace rimpact::calibration {

/// Ceres logs through glog, whose level is the process's; what it has to say is in its summary.
inline ceres::Solver::Options silent_solver(int max_iterations) {
  FLAGS_minloglevel = google::GLOG_FATAL;
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = max_iterations;
  return options;
}

/// Keeps the unknowns `x`, a parameter block of `problem`, between `lower(i)` and `upper(i)`.
template <class Lower, class Upper>
void keep_within(ceres::Problem &problem, double *x, const Lower &lower, const Upper &upper) {
  for (int i = 0; i < problem.ParameterBlockSize(x); ++i) {
    problem.SetParameterLowerBound(x, i, lower(i));
    problem.SetParameterUpperBound(x, i, upper(i));
  }
}

} // namespace rimpact::calibration
