#include "calibration/answer/answer_error.h"
#include "calibration/laws/percent.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

ErrorSum sum_of(const std::vector<AnswerError> &errors, Erring quantity) {
  ErrorSum sum;
  double squares = 0;
  for (const AnswerError &error : errors) {
    if (error.quantity != quantity) continue;
    if (error.value)
      squares += *error.value * *error.value, sum.known = std::sqrt(squares);
    else
      sum.open.push_back(error.source);
  }
  return sum;
}

std::string sentence(const std::vector<AnswerError> &errors, Erring quantity) {
  std::vector<AnswerError> known;
  std::copy_if(errors.begin(), errors.end(), std::back_inserter(known), [&](const AnswerError &error) {
    return error.quantity == quantity && error.value.value_or(0) > 0; // what adds nothing is in the record alone
  });
  std::sort(known.begin(), known.end(), [](const auto &a, const auto &b) { return *a.value > *b.value; });
  std::vector<std::string> parts, open;
  for (const AnswerError &error : known)
    parts.push_back(fmt::format("{} {}", word(error.source), percent_up(*error.value)));
  const ErrorSum sum = sum_of(errors, quantity);
  for (const ErrorSource source : sum.open) open.push_back(word(source));
  const std::string what = description(quantity);
  std::string text = sum.known && !parts.empty()
                         ? fmt::format("{}: within about {} of the bearing's, by {}.", what, percent_up(*sum.known),
                                       fmt::join(parts, ", "))
                         : fmt::format("{}: how far it is from the bearing's is not known.", what);
  if (!open.empty()) text += fmt::format(" Not known: {}.", fmt::join(open, ", "));
  return text;
}

std::vector<std::string> sentences(const std::vector<AnswerError> &errors) {
  std::vector<std::string> said;
  for (const auto &choice : choices(Erring())) {
    const auto of_it = [&](const AnswerError &error) { return error.quantity == choice.value; };
    if (std::any_of(errors.begin(), errors.end(), of_it)) said.push_back(sentence(errors, choice.value));
  }
  return said;
}

std::vector<std::string> finding_sentences(const std::vector<AnswerError> &errors) {
  std::vector<std::string> said, commands;
  for (const AnswerError &error : errors) {
    // a mesh that is not known has its own sentence, with the command (AnswerMeshError)
    if (!error.find || error.source == ErrorSource::mesh ||
        std::find(commands.begin(), commands.end(), error.find->command) != commands.end())
      continue;
    commands.push_back(error.find->command);
    said.push_back(fmt::format(
        "What is not known of {}: {} tells it{}.", word(error.source), error.find->command,
        error.find->minutes > 0 ? fmt::format(" (about {:.0f} min)", std::max(1.0, error.find->minutes)) : ""));
  }
  return said;
}

} // namespace rimpact::calibration
