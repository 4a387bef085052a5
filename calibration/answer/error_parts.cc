#include "calibration/answer/error_parts.h"
#include "calibration/answer/kept_errors.h"
#include <algorithm>
#include <cmath>

namespace rimpact::calibration {

ErrorPart no_error(const std::string &why) {
  return {.value = 0, .how = Known::measured, .from = why};
}

void ErrorParts::add(Erring quantity, ErrorSource source, ErrorPart part) {
  AnswerError error{.quantity = quantity,
                    .source = source,
                    .value = part.value,
                    .how = part.how,
                    .from = part.from,
                    .by = std::move(part.by),
                    .find = std::move(part.find)};
  if (error.value && !std::isfinite(*error.value)) error.value.reset();
  if (error.value)
    error.value = std::abs(*error.value), error.find.reset();
  else
    error.how = Known::unknown;
  errors_.push_back(std::move(error));
}

bool ErrorParts::has(Erring quantity, ErrorSource source) const {
  return std::any_of(errors_.begin(), errors_.end(),
                     [&](const AnswerError &error) { return error.quantity == quantity && error.source == source; });
}

std::vector<AnswerError> ErrorParts::all() const {
  std::vector<AnswerError> sorted = errors_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const AnswerError &a, const AnswerError &b) {
    return std::pair(a.quantity, a.source) < std::pair(b.quantity, b.source);
  });
  return sorted;
}

void ErrorParts::transfer(const AnswerError &part, Erring to, double times, const std::string &how) {
  if (has(to, part.source)) return;
  const bool nothing = part.value && *part.value == 0;
  ErrorPart moved{.value = part.value,
                  .how = nothing ? part.how : Known::transferred,
                  .from = nothing ? part.from : how + part.from,
                  .by = part.by,
                  .find = part.find};
  if (moved.value) *moved.value *= times;
  for (ErrorAt &at : moved.by) at.value *= times;
  add(to, part.source, std::move(moved));
}

void ErrorParts::of_similar(bool reads_k_i, bool reads_e, bool has_strain) {
  const auto each = [&](Erring quantity, auto then) {
    for (const AnswerError &part : std::vector<AnswerError>(errors_))
      if (part.quantity == quantity && part.source != ErrorSource::law) then(part);
  };
  const std::string by_energy = "of the peak force, by the energy stored: ";
  each(Erring::peak_force, [&](const AnswerError &part) {
    transfer(part, Erring::depth, 1, by_energy);
    if (reads_k_i) transfer(part, Erring::k_i, 2, "twice that " + by_energy);
  });
  each(Erring::rebound, [&](const AnswerError &part) {
    if (reads_e) transfer(part, Erring::e, 1, "of the rebound: ");
  });
  if (has_strain)
    each(Erring::depth, [&](const AnswerError &part) {
      transfer(part, Erring::strain, strain_over_depth, "2.2 times that of the depth: ");
    });
}

} // namespace rimpact::calibration
