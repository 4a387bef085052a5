/// The figures in which two responses are compared, as an engineer reads them. One catalogue line each.
#pragma once
#include "calibration/data/metrics.h"
#include <optional>
#include <string>
#include <vector>

namespace rimpact::app {

struct ComparedFigure {
  const char *name; ///< as --max takes it; one that ends in _ms is limited in milliseconds, else in per cent
  const char *title, *meaning;
  std::optional<double> calibration::Comparison::*value;
  double factor; ///< the comparison's value times this is in `unit`
  const char *unit;
};
const std::vector<ComparedFigure> &compared_figures();

/// In the figure's unit; none: it has no meaning here, and the comparison's notes say why.
std::optional<double> value_of(const ComparedFigure &figure, const calibration::Comparison &metrics);
/// "+5.41 %", never "-0.00 %"; "-" where there is none.
std::string in_words(const ComparedFigure &figure, std::optional<double> value);

/// Every figure: name, title, unit and value, null where it has no meaning.
nlohmann::json figures_json(const calibration::Comparison &metrics);

} // namespace rimpact::app
