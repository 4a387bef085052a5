/// The columns of a table that is a record: time and acceleration, by their names and units.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace rimpact {

/// A column of accelerations.
struct AccelerationColumn {
  std::size_t index = 0; ///< from 0
  double unit = 1;       ///< [m/s^2]
  std::string direction; ///< what its name says besides its unit: "NS" of "NS (gal)"
};

/// Of a header line and, where the line below it has units in place of numbers, of both.
struct RecordColumns {
  std::size_t time = 0, count = 0;
  std::vector<AccelerationColumn> accelerations; ///< at least one; several have known directions, each another
  std::size_t lines = 1;                         ///< of the header: 2 with a line of units
  char separator = ',';
};

/// None: the line is no header of a record, or one of a spectrum. A column is time where its unit is s or sec,
/// acceleration where its unit is one of record_units.h; the unit stands in brackets, behind the last "_"
/// ("acceleration_m_per_s2") or in the line below. Throws DataError, opening with `where`, for two columns of time, or
/// of accelerations unless each one's name is another direction.
std::optional<RecordColumns> record_columns(const std::string &header, const std::string &below, double gravity,
                                            const std::string &where);

} // namespace rimpact
