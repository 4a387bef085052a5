/// The parts of an answer's errors as they are put together: none stands twice, none is silently zero.
#pragma once
#include "calibration/answer/answer.h"
#include "calibration/studies/stored_study.h"

namespace rimpact::calibration {

/// A part without its quantity and source, as in AnswerError.
struct ErrorPart {
  std::optional<double> value; ///< of either sign
  Known how = Known::unknown;
  std::string from;
  std::vector<ErrorAt> by = {};
  std::optional<Finding> find = {};
};
/// Known to be nothing, with the reason.
ErrorPart no_error(const std::string &why);

class ErrorParts {
public:
  void add(Erring quantity, ErrorSource source, ErrorPart part);
  /// What moves every peak force by one share moves depth, strain, k_i and e too. A rim that presses F (1 + s) at the
  /// depth d / (1 + s) stores the same energy: it is met as deep as that, its stiffness is k (1 + s)^2, and e is the
  /// rebound over the approach. Strain goes with the depth (strain_over_depth). Of parts of solids that stand already;
  /// a part that stands is left alone.
  void of_similar(bool reads_k_i, bool reads_e, bool has_strain);
  bool has(Erring quantity, ErrorSource source) const;
  std::vector<AnswerError> all() const; ///< by quantity and source

private:
  /// `times` the part, for a quantity where it does not stand.
  void transfer(const AnswerError &part, Erring to, double times, const std::string &how);

  std::vector<AnswerError> errors_;
};

} // namespace rimpact::calibration
