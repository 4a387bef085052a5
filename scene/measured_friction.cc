#include "scene/measured_friction.h"
#include "io/files/error.h"
#include "scene/scene.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::scene {

void visit(KeyVisitor &v, MeasuredFriction &m) {
  if (v.wants(m.scale != 1))
    v.number({"mu_scale", "multiplies every coefficient of friction: a lambda of [bounds]"}, m.scale, si,
             {0, 100, true});
  if (v.wants(!m.table_file.empty()))
    v.text({"mu_table",
            "CSV file of measured friction: speed_m_per_s, mu and if wanted pressure_MPa; instead of mu_fast "
            "and mu_slow"},
           m.table_file);
  if (v.wants(m.reference_pressure.has_value()))
    v.limit({"mu_reference_pressure_MPa", "p0 of friction by pressure, 0.7^(0.02 (p - p0)); inf: not by pressure"},
            m.reference_pressure, mega, {0, 1e4});
  if (v.wants(m.by_temperature))
    v.flag({"mu_by_temperature", "friction falls by the heat of sliding: 0.79 (0.7^(0.02 T) + 0.4)"}, m.by_temperature);
  if (v.wants(m.contact_radius.has_value()))
    v.limit({"contact_radius_mm", "of the sliding face as a circle; inf: the pad's area, or a rigid slider's"},
            m.contact_radius, milli, {0, 1e4, true});
  if (!v.wants(m.by_temperature)) return;
  v.number({"temperature_C", "of the sliding steel at the start"}, m.heat.at_start, si, {-50, 500});
  v.number({"conductivity_W_per_m_K", "of the sliding steel (stainless: Constantinou et al. 2007)"},
           m.heat.conductivity, si, {0, 1e4, true});
  v.number({"diffusivity_mm2_per_s", "of the sliding steel (stainless: Constantinou et al. 2007)"}, m.heat.diffusivity,
           Unit{1e-6, false}, {0, 1e4, true});
}

double contact_radius(const Scene &scene) {
  if (scene.reduced.measured.contact_radius) return *scene.reduced.measured.contact_radius;
  if (scene.rigid_bodies()) return scene.isolator.slider_diameter / 2;
  if (scene.bearing.double_concave()) return scene.bearing.slider.diameter / 2;
  const Pad &pad = scene.bearing.pad;
  return std::sqrt(pad.outer_radius * pad.outer_radius - pad.inner_radius * pad.inner_radius);
}

namespace {

/// Friction on a sliding face has its moment about the dish's centre, that of what is carried goes by the slider's
/// middle: mu_e = 2 R mu / R_eff between two dishes, 1 on one.
double arm_of_faces(const Scene &scene) {
  const Bearing &b = scene.bearing;
  return scene.rigid_bodies() || !b.double_concave() ? 1.0 : b.dishes() * b.surface.R0 / b.ridden_surface().R0;
}

} // namespace

friction::FrictionLaw sliding_law(const Scene &scene) {
  return sliding_law(scene, scene.reduced.mu_slow, scene.reduced.mu_fast);
}

friction::FrictionLaw sliding_law(const Scene &scene, double slow, double fast) {
  const MeasuredFriction &m = scene.reduced.measured;
  const double radius = contact_radius(scene);
  const int faces = scene.rigid_bodies() ? 1 : scene.bearing.dishes(); // rigid bodies have each by itself
  friction::FrictionLaw law{.mu_slow = slow,
                            .mu_fast = fast,
                            .rate = slow == fast ? 0.0 : scene.reduced.rate,
                            .scale = m.scale * arm_of_faces(scene),
                            .reference_pressure = m.reference_pressure,
                            .by_temperature = m.by_temperature,
                            .table = m.table,
                            .area = std::numbers::pi * radius * radius,
                            .face_share = arm_of_faces(scene) / faces,
                            .faces = faces};
  law.validate();
  return law;
}

void check_measured_friction(const Scene &scene) {
  const MeasuredFriction &m = scene.reduced.measured;
  if (!m.any()) return;
  if (m.table && m.table->by_pressure() && m.reference_pressure)
    throw InputError(fmt::format("reduced.mu_reference_pressure_MPa {:g} stands beside reduced.mu_table {}, which has "
                                 "pressures of its own; give one",
                                 *m.reference_pressure / 1e6, m.table_file));
  if (m.table && scene.rigid_bodies() && (scene.isolator.top_mu_fast || scene.isolator.top_mu_slow))
    throw InputError(fmt::format("isolator.{} stands beside reduced.mu_table {}, which is of both dishes; give one",
                                 scene.isolator.top_mu_fast ? "top_mu_fast" : "top_mu_slow", m.table_file));
  if (m.table && scene.triple() && scene.isolator.mu_of == FrictionOf::loops)
    throw InputError(fmt::format("isolator.mu_of \"loops\" stands beside reduced.mu_table {}, which is of the faces: "
                                 "isolator.mu_of = \"faces\", with the inner slider's friction in isolator.inner",
                                 m.table_file));
  const auto &e = scene.excitation;
  const bool timed =
      e.is_dynamic() || (e.kind == ExcitationKind::path && !e.path.time.empty() && !scene.rigid_bodies());
  if (m.by_temperature && !timed)
    throw InputError(fmt::format("reduced.mu_by_temperature needs a motion in time: excitation.kind \"{}\" is "
                                 "quasi-static{}",
                                 word(e.kind), scene.rigid_bodies() ? "" : "; a path whose file has time_s takes it"));
}

std::string friction_beyond_speed(const MeasuredFriction &m) {
  if (!m.table_file.empty()) return "reduced.mu_table";
  if (m.reference_pressure) return "reduced.mu_reference_pressure_MPa";
  return m.by_temperature ? "reduced.mu_by_temperature" : "";
}

void refuse_friction_beyond_speed(const MeasuredFriction &m, const std::string &what, const std::string &why) {
  if (const std::string key = friction_beyond_speed(m); !key.empty())
    throw InputError(fmt::format("{} is not for {}: {}", key, what, why));
}

} // namespace rimpact::scene
