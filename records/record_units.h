/// Units of acceleration as headers write them: one table for every form.
#pragma once
#include <optional>
#include <string_view>

namespace rimpact {

/// m/s^2 of one unit: "g", "cm/s^2", "CM/SEC/SEC", "gal", "m/s2"; in brackets or not, with a raised 2 or not, blanks
/// and capitals do not matter. None: it is no unit of acceleration that is known.
std::optional<double> acceleration_unit(std::string_view name, double gravity);

/// The unit that a text begins with; nothing may follow but a remark: "G/10" and "G*100" are none.
std::optional<double> leading_acceleration_unit(std::string_view text, double gravity);

} // namespace rimpact
