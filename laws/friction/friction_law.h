/// Coefficient of sliding friction: constant (Coulomb), by speed, by pressure, by temperature, or by a measured table;
/// a product of what is asked for. A pure value. SI units, temperatures in degrees Celsius.
///   mu = scale mu_v(v) k_p(p) k_T(T)      (factors.h)          or          mu = scale table(v, p) k_T(T)
#pragma once
#include "laws/friction/friction_table.h"
#include <memory>
#include <optional>

namespace rimpact::friction {

/// What a coefficient sees of its face.
struct Sliding {
  double speed = 0;        ///< [m/s], >= 0
  double pressure = 0;     ///< mean over the face [Pa], >= 0
  double temperature = 20; ///< [degrees Celsius]
};

/// The coefficient and its partial derivatives.
struct Coefficient {
  double value;             ///< [-], >= 0
  double d_speed;           ///< [s/m]
  double d_pressure = 0;    ///< [1/Pa]
  double d_temperature = 0; ///< [1/K]
};

struct FrictionLaw {
  double mu_slow = 0.07;                           ///< at rest [-], 0 <= mu_slow <= mu_fast
  double mu_fast = 0.07;                           ///< at speed [-]
  double rate = 0;                                 ///< a [s/m], > 0; not read when mu_slow == mu_fast
  double scale = 1;                                ///< multiplies the coefficient, a table's too [-], > 0
  std::optional<double> reference_pressure = {};   ///< p0 of k_p [Pa]; none: not by pressure
  bool by_temperature = false;                     ///< k_T
  std::shared_ptr<const FrictionTable> table = {}; ///< takes the place of the numbers above
  double area = 0;                                 ///< of the sliding face [m^2], > 0 where pressure is read
  double face_share = 1; ///< way of a face over that of what slides [-], > 0: R / R_eff between two dishes
  int faces = 1;         ///< in series, each with its share of what friction takes, > 0

  void validate() const; ///< throws InputError naming key, value and bound
  bool by_pressure() const { return reference_pressure.has_value() || (table && table->by_pressure()); }
  bool by_speed() const { return table ? table->by_speed() : mu_slow != mu_fast; }
  bool holds() const { return at({}).value > 0; } ///< whether it holds anything at rest
  Coefficient at(const Sliding &sliding) const;   ///< its speed is that of what slides
  /// The same under a normal force on the whole face [N]: mean pressure normal / area.
  Coefficient under(double normal, double speed, double temperature) const {
    return at({speed, by_pressure() && normal > 0 ? normal / area : 0.0, temperature});
  }
  /// Of mu(N) N by the normal force N, speed and temperature held [-].
  double d_force(const Coefficient &mu, double normal) const {
    return by_pressure() ? mu.value + normal / area * mu.d_pressure : mu.value;
  }
};

} // namespace rimpact::friction
