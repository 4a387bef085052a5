/// Keys of [reduced] by which friction follows pressure, temperature and measured tables
/// (laws/friction/friction_law.h). SI units, temperatures in degrees Celsius.
#pragma once
#include "io/files/key_visitor.h"
#include "laws/friction/friction_law.h"
#include "laws/friction/sliding_heat.h"
#include <memory>
#include <optional>
#include <string>

namespace rimpact::scene {

struct MeasuredFriction {
  double scale = 1;            ///< of every coefficient [-], > 0 (key mu_scale)
  std::string table_file = {}; ///< absolute once it is read; empty: none
  std::shared_ptr<const friction::FrictionTable> table = {};
  std::optional<double> reference_pressure = {}; ///< p0 of k_p [Pa]; none: not by pressure
  bool by_temperature = false;
  std::optional<double> contact_radius = {}; ///< of the sliding face's circle [m]; none: the model's own
  friction::HeatSink heat;

  /// Whether it goes by more than speed.
  bool any() const { return table || reference_pressure || by_temperature; }
};
void visit(KeyVisitor &visitor, MeasuredFriction &friction);

struct Scene;
/// Radius of the circle that the sliding face is as large as [m]: as given, else the pad's, or of two dishes the
/// slider's.
double contact_radius(const Scene &scene);
/// Of the scene's sliding face. Throws InputError naming what contradicts.
friction::FrictionLaw sliding_law(const Scene &scene);
/// The same with other coefficients at rest and at speed [-]: of the second dish of a pair.
friction::FrictionLaw sliding_law(const Scene &scene, double mu_slow, double mu_fast);
/// Throws InputError where measured friction contradicts itself or the scene gives it no time to heat in.
void check_measured_friction(const Scene &scene);
/// By which of speed aside the friction goes that `what` does not know: "reduced.mu_by_temperature"; empty: nothing.
std::string friction_beyond_speed(const MeasuredFriction &friction);
/// Throws InputError where friction goes by more than speed: "reduced.mu_table is not for WHAT: WHY".
void refuse_friction_beyond_speed(const MeasuredFriction &friction, const std::string &what, const std::string &why);

} // namespace rimpact::scene
