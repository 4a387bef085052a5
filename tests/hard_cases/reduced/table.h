/// One row a case: what came out, how far it is from CVODE and from what is known, and whether that is right.
#pragma once
#include "cases.h"

namespace rimpact::hard_cases {

struct Outcome {
  std::string name;
  RunStatus status;
  std::string reason, fact;
  bool must_be_right = true;
  std::size_t n_impacts = 0;
  double peak_displacement = 0, peak_force = 0, residual = 0; ///< [m], [N], [m]
  /// Against CVODE: relative in the peaks (displacement, force), metres in the residual.
  double off_displacement = 0, off_force = 0, off_residual = 0;
  double imbalance = 0;
  std::vector<std::string> failures;
};

/// Runs a case by the own stepper and by CVODE at a tolerance of 1e-11, and judges it.
Outcome judge(const Case &hard);

/// The row as text. Left of '|' what a baseline holds on to; right of it errors, which are rounding.
std::string row(const Outcome &outcome);
std::string header();
/// What of `now` is not in the stored table: words equal, numbers within 1e-5.
std::vector<std::string> differences(const std::string &now, const std::string &stored);

} // namespace rimpact::hard_cases
