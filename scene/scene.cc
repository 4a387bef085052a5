#include "scene/scene.h"
#include "io/files/error.h"
#include "scene/face_friction.h"
#include "scene/keys.h"
#include "scene/names.h"
#include "scene/range_check.h"
#include "scene/size_limits.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// The rim stays outside the bearing's middle and within its dish.
void check_offset(const Scene &s) {
  const double begins = s.bearing.lateral_capacity() + s.reduced.capacity_offset;
  const double edge = s.bearing.ridden_surface().planar_radius;
  if (s.rigid_bodies() || (begins > 0 && begins < edge)) return;
  throw InputError(
      fmt::format("reduced.capacity_offset_mm {:g} puts the rim's touch at a travel of {:.6g} mm, where it "
                  "must be within 0..{:g} mm, the dish's edge",
                  1e3 * s.reduced.capacity_offset, 1e3 * begins, 1e3 * edge));
}

void check_excitation(const Excitation &e, double lateral_capacity) {
  if (e.kind == ExcitationKind::record && e.x.values.empty() && e.y.values.empty() && e.z.values.empty())
    throw InputError("excitation.x needs a file: a record has x, y or z");
  if (e.kind == ExcitationKind::path && e.path.at.empty())
    throw InputError("excitation.file needs a file: a path is read from one");
  if (e.kind == ExcitationKind::cyclic && e.amplitudes.size() > 1 && std::remainder(2 * e.cycles, 1) != 0)
    throw InputError(fmt::format("excitation.cycles {} with {} excitation.amplitudes_m must be a whole number of half "
                                 "cycles, so that the next amplitude begins at 0",
                                 e.cycles, e.amplitudes.size()));
  if (e.kind == ExcitationKind::window && !(e.impact_speed() > 0))
    throw InputError(fmt::format("excitation.scale {} leaves a window no approach speed", e.scale));
  if (e.kind == ExcitationKind::push && !(e.scale > 0))
    throw InputError(fmt::format("excitation.scale {} must be > 0 for a push", e.scale));
  if (e.kind == ExcitationKind::free && !(e.start_displacement().norm() <= lateral_capacity))
    throw InputError(fmt::format("excitation.displacement_m starts at {:.6g} m, beyond the rim at L_c = {:.6g} m",
                                 e.start_displacement().norm(), lateral_capacity));
}

/// What the models of rigid bodies do not offer is refused, never ignored.
void check_isolator(const Scene &s) {
  const auto refuse = [&](const std::string &key, const std::string &why) {
    throw InputError(fmt::format("{} is not for reduced.model \"{}\": {}", key, word(s.reduced.model), why));
  };
  s.isolator.validate(s.reduced.model);
  const auto &e = s.excitation;
  if (e.kind == ExcitationKind::window)
    refuse("excitation.kind \"window\"", "it isolates the rim element of the physical model");
  if (s.reduced.normal_force != NormalForce::inertia)
    refuse("reduced.normal_force", "its normal forces follow from the motion, \"inertia\"");
  if (s.reduced.finite_pad || s.reduced.socket_friction)
    refuse(s.reduced.finite_pad ? "reduced.finite_pad" : "reduced.socket_friction", "its slider is rigid");
  if (s.isolator.space == Space::spatial) return;
  const bool off_x = (e.kind == ExcitationKind::record && !e.y.values.empty()) ||
                     e.kind == ExcitationKind::figure_eight ||
                     (e.kind == ExcitationKind::path && !e.path.stays_on_x()) ||
                     (e.kind != ExcitationKind::record && e.kind != ExcitationKind::free && e.direction()[1] != 0) ||
                     (e.kind == ExcitationKind::free && (e.initial_displacement[1] != 0 || e.initial_velocity[1] != 0));
  if (off_x) throw InputError("isolator.space \"planar\" moves along x only: this excitation needs \"spatial\"");
}

/// A building's axial springs need the vertical motion, and its sway a time.
void check_superstructure(const Scene &s) {
  const auto &e = s.excitation;
  s.superstructure.validate(s.load.mass);
  if (!e.is_dynamic() || e.kind == ExcitationKind::window)
    throw InputError(fmt::format("superstructure.kind \"{}\" needs a motion in time, not excitation.kind \"{}\"",
                                 word(s.superstructure.kind), word(e.kind)));
  if (s.reduced.normal_force != NormalForce::inertia)
    throw InputError(fmt::format("superstructure.kind \"{}\" needs reduced.normal_force \"inertia\", not \"{}\"",
                                 word(s.superstructure.kind), word(s.reduced.normal_force)));
}

void check_foot(const ImpactElement &element, const std::string &section) {
  if (element.foot_force && element.foot_joint.empty())
    throw InputError(fmt::format("{0}.foot_force_kN {1:g} needs {0}.foot_joint, the joint at the rim's foot that "
                                 "it is known for, in the words of a calibration",
                                 section, *element.foot_force / 1e3));
}

/// Of a triple pendulum's inner rims that have their own.
void check_inner_element(const ImpactElement &element) {
  if (element.impact_law->pushed)
    throw InputError(fmt::format("{}.impact_law \"{}\" is for bearings of one dish; a triple pendulum takes the other "
                                 "laws (rimpact list laws)",
                                 inner_rims_section, element.impact_law->name));
  check_foot(element, inner_rims_section);
}

/// A slider that sticks on a mass that bounces is no branch of the model's: friction has to be Park and Wen's.
void check_pad_spring(const Scene &s) {
  if (s.reduced.friction != Friction::park_wen)
    throw InputError(fmt::format("reduced.normal_force \"{}\" needs reduced.friction \"{}\", not \"{}\"",
                                 word(NormalForce::pad), word(Friction::park_wen), word(s.reduced.friction)));
}

/// Groups of drawn meshes are those of a slider on one dish.
void check_own_mesh(const Scene &s) {
  if (s.model.own_mesh.any() && s.bearing.double_concave())
    throw InputError(fmt::format("model.own_mesh is for bearings of one dish: surface.concave \"{}\" has the built-in "
                                 "mesh only",
                                 word(s.bearing.surface.concave)));
}

/// A prescribed path the sliding surface cannot follow is refused here, not by the surface in mid-run.
void check_path(const Scene &scene) {
  const auto &e = scene.excitation;
  const double limit = scene.rigid_bodies() ? scene.isolator.effective_radius()
                                            : make_surface(scene.bearing.ridden_surface())->limit_radius();
  const auto refuse = [&](const char *key, double value, double reach) {
    if (reach < limit) return;
    throw InputError(
        fmt::format("excitation.{} {} takes the slider to {:.6g} m, past the sliding surface's end at {} m", key, value,
                    reach, limit));
  };
  const double reach = std::abs(e.scale) * e.largest_amplitude();
  if (e.kind == ExcitationKind::cyclic)
    refuse(e.amplitudes.empty() ? "amplitude_m" : "amplitudes_m", e.largest_amplitude(), reach);
  if (e.kind == ExcitationKind::path) refuse("scale", e.scale, std::abs(e.scale) * e.path.reach());
  if (e.kind == ExcitationKind::figure_eight) refuse("amplitude_m", e.amplitude, 1.25 * reach);
  if (e.kind == ExcitationKind::push)
    refuse("travel_mm", e.travel * 1e3,
           scene.lateral_capacity() + (scene.rigid_bodies() ? 0.0 : scene.reduced.capacity_offset) +
               e.scale * e.travel);
}

/// A curve is of one bearing's rim, and it must be named.
void check_curve(const Scene &scene) {
  if (scene.reduced.impact_curve.empty())
    throw InputError("reduced.impact_law \"curve\" needs reduced.impact_curve, the file curve.h5 that `rimpact curve "
                     "BEARING` writes");
  if (scene.rigid_bodies())
    throw InputError("reduced.impact_law \"curve\" is for bearings of one dish; reduced.model \"" +
                     word(scene.reduced.model) + "\" takes the other laws (rimpact list laws)");
}

} // namespace

std::string Scene::bearing_name() const {
  if (!rigid_bodies()) return bearing.name;
  return word(reduced.model) + (isolator.name.empty() ? " of [isolator]" : " " + isolator.name);
}

void Scene::validate() const {
  check_names(*this);
  check_bearing(*this);
  check_ranges(*this);
  check_face_friction(*this);
  check_offset(*this);
  if (rigid_bodies()) check_isolator(*this);
  check_excitation(excitation, triple() ? triple_start_capacity(isolator) : lateral_capacity());
  if (reduced.impact_law->pushed) check_curve(*this);
  if (superstructure.any()) check_superstructure(*this);
  if (reduced.normal_force == NormalForce::pad) check_pad_spring(*this);
  check_foot(reduced, reduced_section);
  if (triple() && isolator.inner.own_rims) check_inner_element(isolator.inner.rims);
  check_measured_friction(*this);
  bounds.validate();
  check_path(*this);
  check_own_mesh(*this);
  check_sizes(*this);
}

} // namespace rimpact::scene
