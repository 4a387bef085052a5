/// An impact law in OpenSees' words: the uniaxial material, its numbers, and how far it is the law.
#pragma once
#include "io/files/choice.h"
#include <string>
#include <vector>

namespace rimpact::laws {

/// OpenSees' name of a uniaxial material; gap springs stand in parallel and are tuned to the law where it is exported.
enum class RimMaterial { gap_springs, viscoelastic_gap, hertzdamp };
constexpr auto choices(RimMaterial) {
  using enum RimMaterial;
  return choices_of<RimMaterial>(
      {{gap_springs, "ElasticPPGap"}, {viscoelastic_gap, "ViscoelasticGap"}, {hertzdamp, "Hertzdamp"}});
}

inline constexpr auto how_gap_springs_stand = "rim_springs: two along x, each side keeps its own dent; blind to y. "
                                              "rim_round: one round rim for any direction, but "
                                              "every impact meets it as new: no dents.";

struct OpenSeesMaterial {
  struct Number {
    std::string name;
    double value; ///< SI
    std::string meaning;
  };
  RimMaterial material;
  std::vector<Number> numbers = {}; ///< in the order the material takes them, its gap left out
  std::vector<std::string> notes = {};
};

} // namespace rimpact::laws
