/// A part of how far a number of an answer may be from the bearing it speaks of.
#pragma once
#include "io/files/choice.h"
#include <optional>
#include <string>
#include <vector>

namespace rimpact::calibration {

enum class Erring { peak_force, depth, rebound, k_i, e, strain };
constexpr auto choices(Erring) {
  return choices_of<Erring>({{Erring::peak_force, "peak_force", "Peak force"},
                             {Erring::depth, "depth", "Depth"},
                             {Erring::rebound, "rebound", "Rebound"},
                             {Erring::k_i, "k_i", "k_i"},
                             {Erring::e, "e", "e"},
                             {Erring::strain, "strain", "Strain"}});
}
enum class ErrorSource { mesh, step, rung, law, energy, steel, geometry };
constexpr auto choices(ErrorSource) {
  return choices_of<ErrorSource>({{ErrorSource::mesh, "mesh"},
                                  {ErrorSource::step, "step"},
                                  {ErrorSource::rung, "rung"},
                                  {ErrorSource::law, "law"},
                                  {ErrorSource::energy, "energy"},
                                  {ErrorSource::steel, "steel"},
                                  {ErrorSource::geometry, "geometry"}});
}
enum class Known { measured, transferred, unknown };
constexpr auto choices(Known) {
  return choices_of<Known>({{Known::measured, "measured", "of this rim"},
                            {Known::transferred, "transferred", "of another rim or load"},
                            {Known::unknown, "unknown"}});
}

/// A part at one impact, where runs or kept studies tell impacts apart.
struct ErrorAt {
  std::string load;            ///< kind of excitation, or the kept study's scene
  double speed;                ///< approach [m/s]
  std::optional<double> depth; ///< of the impact [m]; none: not kept
  double value;                ///< as AnswerError::value
};

/// What tells a part that is not known.
struct Finding {
  std::string command;
  double minutes; ///< expected, > 0; 0: not known
};

struct AnswerError {
  Erring quantity;
  ErrorSource source;
  std::optional<double> value; ///< absolute, relative to the quantity [-]; none: unknown
  Known how = Known::unknown;
  std::string from;                 ///< where it was read, or why it is not known
  std::vector<ErrorAt> by = {};     ///< by load and depth; `value` is the worst of them, or of more
  std::optional<Finding> find = {}; ///< of a part that is not known; none: no command tells it
};

/// Of one quantity.
struct ErrorSum {
  std::optional<double> known;   ///< root of the sum of squares of the parts that are known [-]
  std::vector<ErrorSource> open; ///< the parts that are not
};
ErrorSum sum_of(const std::vector<AnswerError> &errors, Erring quantity);
/// "Peak force: within about 30 % of the bearing's, by steel 27 %, rung 12 %, law 5 %. Not known: step, geometry."
std::string sentence(const std::vector<AnswerError> &errors, Erring quantity);
/// The same of every quantity that has a part.
std::vector<std::string> sentences(const std::vector<AnswerError> &errors);
/// One a command: "What is not known of step: rimpact study ... tells it (about 3 min)."
std::vector<std::string> finding_sentences(const std::vector<AnswerError> &errors);

} // namespace rimpact::calibration
