/// Equations of motion of a mass on a dish with a rim (thesis 2.2), one smooth branch at a time; the events
/// that end a branch and what follows them. Both integrators (own stepper, CVODE) drive these same branches.
/// SI units.
///
///   m u'' = -m a_g - W e_z + N n + f_t + I,      z = h(x, y) while the dish carries the mass,
///
/// n the upward unit normal, f_t tangent to the surface, I horizontal. Along the surface z'' = grad h . (x'',
/// y'') + v^T H v, so N = m v^T H v / S - n . (-m a_g - W e_z + I), S = sqrt(1 + |grad h|^2): exact, vertical
/// inertia, ground motion and the rim's unloading included; a tangent friction drops out of it.
///   `inertia`   this N; the mass lifts off when it reaches zero.
///   `static`    N from vertical equilibrium N n_z + f_z = W + m a_gz; planar inertia only, no uplift.
///   `constant`  N = W; planar inertia only, no uplift.
///   `pad`       the mass stands on the pad's spring, m z'' = S - W - m a_gz, S = max(0, k (d + theta d')), d = W / k +
///               h(x, y) - z > 0, and the slider below it, without mass, stays on the dish: N n_z + f_z = S. It bounces
///               on the pad, which loses what theta asks for (scene::pad_retardation).
/// Under a building m is the base's mass and W the whole dead load. The first storey's force (a change from the dead
/// load) acts on the base beside the others.
#pragma once
#include "laws/friction/regularised.h"
#include "laws/friction/sliding_heat.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/bearings/foot_limit.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/bearings/riding_height.h"
#include "reduced_models/structures/superstructure.h"
#include <array>
#include <cmath>

namespace rimpact::reduced {

enum class Support { sliding, stuck, airborne };
enum class RimContact { open, pressed, relaxed }; ///< relaxed: d > 0, but a unilateral element has let go

/// The branch the system is on.
struct Mode {
  Support support = Support::sliding;
  RimContact rim = RimContact::open;
  /// Direction of sliding when the branch (or step) began. Friction keeps to its half plane, so that
  /// straight-line motion continues smoothly through v = 0 and the stop is a simple root of v . e0.
  Eigen::Vector2d e0 = Eigen::Vector2d::UnitX();
  /// Slow sliding driven by |D| >= 0.6 mu N: the velocity turns towards the drive D at the rate |D| / (m
  /// |v|), stiffer without bound as |v| -> 0. Below `slow_speed` friction therefore takes the direction where
  /// that leads: the drive's, less a lag of |v| m / (2 |D| - mu N) times its rate of turning (error of second
  /// order in it).
  bool slow = false;
  DentedRim dented; ///< read by a rim that yields: as the path has left it, the step under way included
};

using scene::NormalForce;

/// Orthonormal tangent frame of the surface at u: along the meridian and along the circle.
struct TangentFrame {
  Eigen::Vector3d meridian, circle, normal;
  TangentFrame() = default;
  TangentFrame(const scene::SurfacePoint &p, const Eigen::Vector2d &u);
};

/// The dish below a mass that is held: the same from one call to the next while it stays.
struct Footing {
  Eigen::Vector2d u{std::nan(""), std::nan("")};
  scene::SurfacePoint dish;
  TangentFrame frame;
};

/// Where a state is and what the ground does there: found once for all that acts.
struct Site {
  scene::SurfacePoint dish;            ///< below the mass; not set in the air
  FloorMotion base;                    ///< of the mass, on the surface while the dish carries it
  Eigen::Vector3d ground;              ///< acceleration [m/s^2]
  const TangentFrame *frame = nullptr; ///< of the dish, where it is known
};

/// Everything that acts in a state.
struct Evaluation {
  double normal = 0, rim_force = 0; ///< N; force of the rim, > 0 inwards [N]
  double excess = 0;                ///< of a mass held by friction, as Hold's [-]
  double gap = 0, gap_rate = 0;     ///< L_c - |u_xy| and its rate
  double ground_power = 0;          ///< [W]
  double heat_flux = 0;             ///< into the steel at the dish's vertex, where the slider covers it [W/m^2]
  Eigen::Vector3d pendular, friction, impact, acceleration;
  Eigen::Vector2d eta_rate;
};

/// Whether friction can hold the mass at rest. `excess` > 0: it cannot, by so much over N [-].
struct Hold {
  double excess, normal;
  double drive;              ///< what the sliding face would have to hold [N]
  Eigen::Vector2d direction; ///< in which it would start to slide (planar, unit)
  Eigen::Vector3d friction;  ///< holding force, when it holds [N]
};

/// What ends a branch. Each has a value that is positive before and falls through zero at the event.
/// `target`: what the run was to reach, its stop function's zero.
enum class Event {
  turning,
  stop,
  slip,
  underway,
  uplift,
  landing,
  collapse,
  touch,
  release,
  let_go,
  press_again,
  target
};
/// Touch and what follows it change the rim's force, or may: a run's target is its touch.
inline bool changes_rim(Event event) {
  return event >= Event::touch;
}
struct EventList {
  static constexpr int largest = 8;
  std::array<Event, largest> list{};
  int n = 0;
  void add(Event event) { list[n++] = event; }
  const Event *begin() const { return list.data(); }
  const Event *end() const { return list.data() + n; }
};

class Dynamics {
public:
  /// `with_rim` false or k_i = 0: no rim element. `lateral_capacity` < 0: the bearing's own.
  explicit Dynamics(const scene::Scene &scene, bool with_rim = true, double lateral_capacity = -1);

  Site site(const Mode &mode, double t, const State &y) const;
  Evaluation evaluate(const Mode &mode, double t, const State &y) const;
  Evaluation evaluate(const Mode &mode, double t, const State &y, const Site &site) const;
  /// Fills the rates; returns what acts, which they were made of (as it was born where the state is inadmissible).
  /// `footing` (may be null): kept by the caller between calls of one run.
  Evaluation rhs(const Mode &mode, double t, const State &y, State &dy, Footing *footing = nullptr) const;
  /// At rest on the dish; the rim, when pressed, pushes with its spring.
  Hold hold(const Mode &mode, double t, const State &y) const;
  Hold hold(const Mode &mode, double t, const State &y, const Site &site) const;

  /// Events that can end `mode`.
  EventList events(const Mode &mode) const;
  double value(Event event, const Mode &mode, double t, const State &y) const;
  /// Applies an event: switches the branch, projects the state on it. Returns the energy lost in a landing
  /// [J].
  double apply(Event event, Mode &mode, double t, State &y) const;
  /// What an event that changes the rim (changes_rim) leaves of its contact.
  RimContact rim_after(Event event, const Mode &mode, double t, const State &y) const;
  /// By the rim on a pressing slider at u, v (any |u| > 0).
  RimPush rim_push(const Mode &mode, double t, const Eigen::Vector2d &u, const Eigen::Vector2d &v) const;
  /// Throws SolverStopped where the rim's element holds no longer for a slider beyond L_c: thrown over the rim, the
  /// joint at its foot gone (foot_limit.h), or past a curve's limits (curve_limits.h).
  void keep_to_rim(const Mode &mode, double t, const State &y) const;
  /// Branch of a state at the start of a run or after a jump: decides between sliding, stuck and airborne.
  void update_mode(Mode &mode, double t, State &y) const;
  /// Before a step from y (its rates dy) and after it: a rim that yields keeps the path it was pressed along.
  void begin_step(Mode &mode, double t, const State &y, const State &dy) const;
  void arrive(Mode &mode, double t, const State &y) const;
  /// Whether the rim is pressed and remembers it: steps need `begin_step` and `arrive`.
  bool denting(const Mode &mode) const { return mode.rim == RimContact::pressed && rim.law->yields; }
  /// After a step: true when the branch changed because a mass has crept to its stop or its sliding has
  /// become slow.
  bool slow_down(Mode &mode, double t, State &y) const;
  /// At the end of a rest: slides (or lifts) whatever rounding says of the limit.
  void release_from_rest(Mode &mode, double t, State &y) const;
  Mode starting_mode(const BearingState &start, State &y) const;
  /// Fills z and v_z from the surface while the dish carries the mass.
  void place(const Mode &mode, State &y) const;
  /// As `place`, and e0 follows the velocity: before each step.
  void project(Mode &mode, State &y) const;

  double kinetic_energy(const State &y) const;
  double potential_energy(const State &y) const; ///< W z and the pad's spring, or the pendular work for `constant`
  /// Coefficient of the sliding face at a speed [m/s] under N, by the temperature of the state.
  friction::Coefficient mu(double speed, double normal, const State &y) const {
    return friction_law.under(normal, speed, temperature(y));
  }
  /// Of the steel at the dish's vertex [degrees Celsius]; where friction does not go by it, that at the start.
  double temperature(const State &y) const {
    return heats() ? heat.temperature(y.begin() + heat_begins()) : heat.at_start();
  }
  /// Whether friction goes by the heat of sliding: the state ends with its modes.
  bool heats() const { return friction_law.by_temperature; }
  int heat_begins() const { return state_size(building.n_floors()); }
  bool inside(const State &y) const { return y[iX] * y[iX] + y[iY] * y[iY] < limit_squared_; }
  bool has_rim() const { return rim.stiffness > 0; }
  bool park_wen() const { return park_wen_; }

  /// A mass held by friction is at rest, and with it everything that does not cool: only time passes until it slides.
  bool at_rest(const Mode &mode) const { return mode.support == Support::stuck && !building.any() && !heats(); }
  int n_state() const { return heat_begins() + (heats() ? friction::n_heat_modes : 0); }
  /// Position and velocity of the mass, on the surface while the dish carries it.
  FloorMotion base(const Mode &mode, const State &y) const;

  // Read by the drivers and the recorder.
  Superstructure building;
  double mass;           ///< of what slides: without the building's floors [kg]
  double supported_mass; ///< with them [kg]
  double weight, lateral_capacity, elastic_slip = 0;
  double lift_over_rim; ///< of the slider, above which the rim no longer stands before it [m]
  double speed_scale;   ///< for tolerances [m/s]
  double stop_speed;    ///< below it a decelerating mass has stopped [m/s]
  double slow_speed;    ///< see Mode::slow [m/s]
  laws::RimElement rim;
  FootLimit foot; ///< where its joint goes
  DentShape dents;
  RidingHeight height;
  friction::FrictionLaw friction_law;
  friction::SlidingHeat heat;
  double contact_radius; ///< of the sliding face [m]
  NormalForce reading = NormalForce::inertia;
  double pad_stiffness = 0, pad_retardation = 0; ///< read by `pad` [N/m], [s]
  /// The mass has a height of its own: beside `pad`'s spring, or in the air.
  bool rises(const Mode &mode) const { return mode.support == Support::airborne || reading == NormalForce::pad; }
  scene::GroundMotion ground;

  /// Friction per unit of normal force, tangent to the surface and opposed to `v`; zero for v = 0.
  /// `p` the riding height at `u`. Includes the socket: the foot must turn with the surface's normal n inside
  /// the socket of arm a (pad_on_dish.h), dissipating mu_ss N a |n'|, n' = -(kappa_m v_m, kappa_c v_c) along
  /// meridian and circle, i.e. a tangent force mu_ss N a K^2 v / |K v|; in unidirectional motion mu_ss N a kappa_m.
  Eigen::Vector3d friction_per_normal(const scene::SurfacePoint &p, const Eigen::Vector2d &u, const Eigen::Vector2d &v,
                                      double mu) const;
  /// Per unit of normal force: mu_ss times the socket's arm [m], 0 when the socket is frictionless.
  double socket = 0;

private:
  Eigen::Vector3d applied(const Evaluation &e, const State &y, const FloorMotion &base,
                          const Eigen::Vector3d &ground) const;
  Site on_dish(double t, const State &y) const;
  Site on_dish(double t, const State &y, Footing &footing) const;
  FloorMotion above(const scene::SurfacePoint &p, const State &y) const;
  double pad_compression(const scene::SurfacePoint &p, const State &y) const;
  double pad_compression_rate(const scene::SurfacePoint &p, const State &y) const;
  double pad_force(const scene::SurfacePoint &p, const State &y) const;
  double pad_loss(const scene::SurfacePoint &p, const State &y) const;
  Eigen::Vector3d friction_of(const Site &site, const State &y, const Eigen::Vector2d &direction, Evaluation &e) const;
  Eigen::Vector2d slow_direction(const Mode &mode, double t, const State &y, const Site &site) const;
  double drive_share(const Mode &mode, double t, const State &y) const;
  void rim_terms(const Mode &mode, double t, const Eigen::Vector2d &u, const Eigen::Vector2d &v, Evaluation &e) const;
  double land(Mode &mode, double t, State &y) const;
  double dead_load_ = 0; ///< W that acts vertically (0 for a window without weight)
  double vertical_restitution_ = 0, limit_squared_ = 0;
  bool park_wen_ = false;
};

} // namespace rimpact::reduced
