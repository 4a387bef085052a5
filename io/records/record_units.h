/// Units of acceleration as headers write them: one table for every form.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace rimpact {

/// How a file's numbers become m/s^2.
struct ReadAs {
  /// A gravity alone is what most callers have.
  ReadAs(double gravity_m_per_s2, std::optional<double> stated_unit = std::nullopt)
      : gravity(gravity_m_per_s2), unit(stated_unit) {}
  double gravity;             ///< of a unit g [m/s^2]
  std::optional<double> unit; ///< of the file's numbers [m/s^2], whatever its header says; none: the header's
  std::size_t column = 0;     ///< which of a table's accelerations, from 0; for forms whose channels are columns
};

/// m/s^2 of one unit: "g", "cm/s^2", "CM/SEC/SEC", "gal", "m/s2"; in brackets or not, with a raised 2 or not, blanks
/// and capitals do not matter. None: it is no unit of acceleration that is known.
std::optional<double> acceleration_unit(std::string_view name, double gravity);

/// The unit that a text begins with; nothing may follow but a remark: "G/10" and "G*100" are none.
std::optional<double> leading_acceleration_unit(std::string_view text, double gravity);

} // namespace rimpact
