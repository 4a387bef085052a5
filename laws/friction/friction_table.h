/// A coefficient of friction as it was measured: over speed, or over speed and pressure, linear in each between the
/// measured values and constant beyond them. SI units.
#pragma once
#include <string>
#include <vector>

namespace rimpact::friction {

struct Coefficient;

class FrictionTable {
public:
  /// `value[i * pressures + j]` at speed i and pressure j; both grow. One pressure: over speed alone.
  FrictionTable(std::vector<double> speeds, std::vector<double> pressures, std::vector<double> values);
  Coefficient at(double speed, double pressure) const; ///< [m/s], [Pa]
  bool by_speed() const { return speeds_.size() > 1; }
  bool by_pressure() const { return pressures_.size() > 1; }

private:
  std::vector<double> speeds_, pressures_, values_;
};

/// CSV with a header: "speed_m_per_s" or "speed_mm_per_s", "mu", and if wanted "pressure_MPa", in any order; a row for
/// each pair of the speeds and pressures it has. Comment lines begin with #. Throws DataError naming file, line, value.
FrictionTable read_friction_table(const std::string &file);

} // namespace rimpact::friction
