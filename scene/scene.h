/// A scene: a bearing, its load, what excites it, and the models' settings. Read from TOML, every default filled in.
#pragma once
#include "scene/bearing.h"
#include "scene/bounds.h"
#include "scene/choices.h"
#include "scene/excitation.h"
#include "scene/fitted_plates.h"
#include "scene/impact_element.h"
#include "scene/isolator.h"
#include "scene/measured_friction.h"
#include "scene/own_mesh_settings.h"
#include "scene/superstructure.h"
#include "scene/triple_pendulum.h"
#include <string>
#include <vector>

namespace rimpact::scene {

struct Load {
  double vertical = 853e3; ///< dead load W [N], >= 0
  double mass = 86952.0;   ///< inertia in all directions [kg], > 0; base and superstructure together
  double gravity = 9.81;   ///< [m/s^2]
};

/// [model]: the finite-element side.
struct FeSettings {
  Rung rung = Rung::rim;
  int mesh = 1;             ///< 1 | 2 | 3, h divided by 1.5 a level; 0: a draft, h x 1.5
  double step = 0.0;        ///< time step inside an impact [s], 0: chosen by the plan (key `step_ms`)
  double rho_inf = 0.5;     ///< spectral radius of generalised-alpha, 0..1
  double penalty_scale = 1; ///< of contact, times the default of the softer side's stiffness, > 0
  Symmetry symmetry = Symmetry::by_plan;
  OwnMesh own_mesh; ///< instead of the built-in one
};

/// [reduced]: the physical model; friction, impact element and sampling of the other reduced models too.
struct ReducedSettings : ImpactElement {
  ModelKind model = ModelKind::physical;
  double capacity_offset = 0.0;    ///< the reduced rim begins at L_c plus this [m]
  std::string fitted_rim = {};     ///< rim_identity() of the bearing the element was fitted to; empty: not known
  FittedPlates fitted_plates = {}; ///< of rigid bodies, in the place of that identity
  Friction friction = Friction::coulomb;
  double elastic_slip = 1e-4; ///< q of the Park-Wen state [m] (key elastic_slip_mm)
  double mu_fast = 0.07, mu_slow = 0.07;
  double rate = 0.0;         ///< of the velocity law [s/m], needed when mu_slow != mu_fast
  MeasuredFriction measured; ///< by pressure, temperature, table
  NormalForce normal_force = NormalForce::inertia;
  double vertical_restitution = 0.0; ///< of re-contact with the dish after uplift [-], 0..1
  bool finite_pad = false;           ///< extra lift (Ro^2+Ri^2)/8 (kappa_m + kappa_c - 2/R0)
  bool socket_friction = false;      ///< moment of the socket resisting tilt
  double tolerance = 1e-9;           ///< relative, of the integrator
  Integrator integrator = Integrator::own;
  double output_step = 0.005; ///< spacing of stored samples [s]; samples are dense during contact

  /// The element is of no calibration.
  void forget_fit() {
    forget_calibration();
    fitted_rim.clear(), fitted_plates = {};
  }
};

struct Scene {
  std::string name = "scene";
  Bearing bearing;
  Load load;
  Excitation excitation;
  FeSettings model;
  ReducedSettings reduced;
  Isolator isolator;                           ///< [isolator]: the bearing of rigid bodies
  FrictionBounds bounds;                       ///< [bounds]: of friction over the bearing's life
  Superstructure superstructure;               ///< [superstructure]: what the bearing carries
  std::string isolator_remark, springs_remark; ///< those that name keys of [isolator] beside a dish; may be empty
  std::string load_remark;          ///< that of `remarks` which says whose load the bearing carries; may be empty
  std::vector<std::string> remarks; ///< sentences: what the reading of its file filled in or put aside; not written out

  bool impact_resilient() const { return reduced.model == ModelKind::lir_dcfp; }
  bool triple() const { return reduced.model == ModelKind::tfp; }
  /// Of the rims between a triple pendulum's slide plates and its inner slider; of other bearings as of every rim.
  const ImpactElement &inner_element() const {
    return triple() && isolator.inner.own_rims ? isolator.inner.rims : reduced;
  }
  /// Whether its bearing is of rigid bodies between two plates, [isolator].
  bool rigid_bodies() const { return reduced.model != ModelKind::physical; }
  /// "shfps-225"; of rigid bodies "tfp tfp-kim-2023" or "dcfp of [isolator]".
  std::string bearing_name() const;
  /// Whether pad and foot are modelled: rungs rigid-dish and full, and the reduced model's terms of pad and socket.
  bool needs_stack() const { return has_dish(model.rung) || reduced.finite_pad || reduced.socket_friction; }
  /// Displacement at which the rim of the model's bearing is touched, or the last of a triple pendulum's [m].
  double lateral_capacity() const {
    return triple()         ? triple_capacity(isolator)
           : rigid_bodies() ? isolator.lateral_capacity()
                            : bearing.lateral_capacity();
  }

  /// Throws InputError naming value and bound; includes the bearing, pad and foot where they are modelled.
  void validate() const;
};

/// `where` is a path to a TOML file or the name of a built-in scene; `overrides` are dotted KEY=VALUE (--set).
/// Throws InputError ("file:line:column: ... did you mean ...") or DataError (records). Records are read.
Scene load_scene(const std::string &where, const std::vector<std::string> &overrides = {});
/// The same from text; `origin` stands for the file's name in messages, relative files are sought in `folder`.
Scene parse_scene(const std::string &text, const std::string &origin, const std::vector<std::string> &overrides = {},
                  const std::string &folder = ".");
/// One dotted KEY=VALUE by itself: throws InputError, opening with `where`, for an unknown key, a value of the
/// wrong type or out of its range.
void check_assignment(const std::string &assignment, const std::string &where);
/// A bearing file or a built-in bearing's name. Pad and foot are checked by the scenes that model them.
Bearing load_bearing(const std::string &where);

std::vector<std::string> builtin_scene_names();
/// A built-in scene's or bearing's commented TOML text, as `rimpact new` writes it.
std::string builtin_scene_text(const std::string &name);

} // namespace rimpact::scene
