/// In which direction a record was taken, as headers, file names and people write it: the one table of spellings.
#pragma once
#include "io/files/choice.h"
#include <optional>
#include <string>
#include <string_view>

namespace rimpact {

enum class DirectionKind { unknown, horizontal, vertical };
constexpr auto choices(DirectionKind) {
  using enum DirectionKind;
  return choices_of<DirectionKind>({{unknown, "unknown"}, {horizontal, "horizontal"}, {vertical, "vertical"}});
}

/// Of positive motion.
struct Direction {
  DirectionKind kind = DirectionKind::unknown;
  /// Clockwise from north [deg], 0 to 360 as written; none: vertical, unknown, or along an axis of the instrument's
  /// own. North by its letter is 360.
  std::optional<double> azimuth_deg;
  std::string spelling; ///< as it was written, in capitals; empty: unknown
};

/// Of a word that says nothing else: "090", "360 Deg", "N55W", "E-W", "UP", "Comp: DWN", "HNZ", "vertical". A word that
/// is not known gives an unknown direction.
Direction direction_written(std::string_view word);

/// A direction at the end of a file's name, and the name before it.
struct NamedDirection {
  std::string station; ///< without the marks between both; all of the name where its direction is not known
  Direction direction;
};

/// Of a name without folder and ending: "RSN1086_NORTHR_SYL090", "TCU102-E", "A-HMCDWN", "GDLCN55W". A letter alone
/// counts behind "-", "_", "." or a digit, and behind letters in the names of PEER ("RSN6953_DARFIELD_PRPCS"), which
/// all end with a direction.
NamedDirection direction_in_name(std::string_view stem);

} // namespace rimpact
