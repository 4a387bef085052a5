#include "reduced_models/motion/quasi_static.h"
#include "io/files/error.h"
#include "reduced_models/bearings/curve_limits.h"
#include "reduced_models/bearings/dynamics.h"
#include "reduced_models/simulate.h"
#include "scene/size_limits.h"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::reduced {

using Eigen::Vector2d;

namespace {

/// The prescribed path over the load parameter s, and the forces on it.
class Path {
public:
  explicit Path(const scene::Scene &scene) : excitation_(scene.excitation), dynamics_(scene) {}

  Vector2d at(double s) const { return scene::prescribed_displacement(excitation_, dynamics_.lateral_capacity, s); }
  /// Direction of arrival (of departure at s = 0): friction persists until the path really turns.
  Vector2d direction(double s) const {
    constexpr double ds = 1e-6;
    const Vector2d step = s > ds ? at(s) - at(s - ds) : at(s + ds) - at(s);
    return step.norm() > 0 ? Vector2d(step.normalized()) : Vector2d::UnitX();
  }
  /// Of arrival, where the path has a time; else 0: friction is that of slow motion [m/s].
  double speed(double s) const {
    constexpr double ds = 1e-6;
    const double from = std::max(0.0, s - ds), to = from + ds;
    const auto t0 = scene::prescribed_instant(excitation_, from), t1 = scene::prescribed_instant(excitation_, to);
    return t0 && t1 ? (at(to) - at(from)).norm() / (*t1 - *t0) : 0.0;
  }
  State state(const Vector2d &u) const {
    State y(dynamics_.n_state());
    y[iX] = u[0], y[iY] = u[1], y[iZ] = dynamics_.height.at(u[0], u[1]).z;
    return y;
  }
  Evaluation forces(double s, const Vector2d &u, const Vector2d &direction) const {
    Mode mode;
    mode.e0 = direction;
    mode.dented = rim_;
    mode.rim = dynamics_.has_rim() && u.norm() >= dynamics_.lateral_capacity ? RimContact::pressed : RimContact::open;
    State y = state(u);
    if (dynamics_.heats()) std::copy(heat_.begin(), heat_.end(), y.begin() + dynamics_.heat_begins());
    const double v = speed(s);
    y[iVX] = v * direction[0], y[iVY] = v * direction[1];
    return dynamics_.evaluate(mode, 0, y);
  }
  /// What has been reached so far stays in a rim that yields.
  void press(const Vector2d &u) {
    const double d = u.norm() - dynamics_.lateral_capacity;
    if (d <= 0) return;
    rim_.press(u, d, dynamics_.dents);
    if (const auto reason = dynamics_.rim.curve
                                ? beyond_curve(*dynamics_.rim.curve, {d, 0, 0, false}, rim_, u, dynamics_.dents)
                                : std::nullopt)
      throw InputError("impact_law \"curve\": " + *reason + "; take rung rim (rimpact run --rung rim)");
  }
  /// Why the path ends here: the rim's foot goes.
  std::optional<std::string> gone_at(double s) const {
    if (!dynamics_.foot.is_known() || !dynamics_.foot.gone(forces(s, at(s), direction(s)).rim_force)) return {};
    return fmt::format("at load parameter {:.4g} {}", s, dynamics_.foot.sentence());
  }
  /// Over an interval of a path with a time the steel takes the heat of its middle.
  void heat(double s0, double s1) {
    if (!dynamics_.heats()) return;
    const double time = *scene::prescribed_instant(excitation_, s1) - *scene::prescribed_instant(excitation_, s0);
    const double middle = (s0 + s1) / 2;
    heat_ = dynamics_.heat.after(heat_, forces(middle, at(middle), direction(middle)).heat_flux, time);
  }
  double temperature() const { return dynamics_.heat.temperature(heat_.data()); }
  const Dynamics &dynamics() const { return dynamics_; }

private:
  const scene::Excitation &excitation_;
  Dynamics dynamics_;
  DentedRim rim_;
  friction::HeatModes heat_{};
};

/// Works over one interval of the path by Gauss's four points: of the drive, the friction and the rim.
void add_works(const Path &path, double s0, double s1, EnergyLedger &ledger) {
  constexpr double x[] = {0.8611363115940526, 0.3399810435848563}, w[] = {0.3478548451374538, 0.6521451548625461};
  for (int i = 0; i < 4; ++i) {
    const double s = (s0 + s1) / 2 + (i % 2 ? -1 : 1) * x[i / 2] * (s1 - s0) / 2, ds = 1e-3 * (s1 - s0);
    const Vector2d du = (path.at(s + ds) - path.at(s - ds)) / (2 * ds) * w[i / 2] * (s1 - s0) / 2;
    if (du.norm() == 0) continue;
    const Vector2d u = path.at(s);
    const Evaluation e = path.forces(s, u, du.normalized());
    const double dz = path.dynamics().height.at(u[0], u[1]).gradient.dot(du);
    const bool constant = path.dynamics().reading == NormalForce::constant;
    ledger.external -= (e.pendular + e.friction + e.impact).head<2>().dot(du);
    ledger.friction -= e.friction.head<2>().dot(du) + (constant ? 0.0 : e.friction[2] * dz);
    ledger.impact -= e.impact.head<2>().dot(du);
    if (constant) ledger.gravity -= e.pendular.head<2>().dot(du);
  }
}

void store(const Path &path, double s, EnergyLedger &ledger, Response &response, Summary &summary) {
  const Vector2d u = path.at(s);
  const Evaluation e = path.forces(s, u, path.direction(s));
  const State y = path.state(u);
  const Eigen::Vector3d force = e.pendular + e.friction + e.impact;
  if (path.dynamics().reading != NormalForce::constant)
    ledger.gravity = path.dynamics().potential_energy(y) - path.dynamics().potential_energy(path.state(path.at(0)));
  ledger.largest_input = std::max(ledger.largest_input, std::abs(ledger.external));
  const std::pair<const char *, double> row[] = {{"time", s},
                                                 {"displacement_x", u[0]},
                                                 {"displacement_y", u[1]},
                                                 {"displacement_z", y[iZ]},
                                                 {"velocity_x", 0},
                                                 {"velocity_y", 0},
                                                 {"velocity_z", 0},
                                                 {"force_x", force[0]},
                                                 {"force_y", force[1]},
                                                 {"force_z", force[2]},
                                                 {"pendular_x", e.pendular[0]},
                                                 {"pendular_y", e.pendular[1]},
                                                 {"friction_x", e.friction[0]},
                                                 {"friction_y", e.friction[1]},
                                                 {"impact_x", e.impact[0]},
                                                 {"impact_y", e.impact[1]},
                                                 {"gap", e.gap},
                                                 {"normal_force", e.normal},
                                                 {"energy_external", ledger.external},
                                                 {"energy_gravity", ledger.gravity},
                                                 {"energy_kinetic", 0},
                                                 {"energy_friction", ledger.friction},
                                                 {"energy_impact", ledger.impact},
                                                 {"energy_contact", 0}};
  for (const auto &[name, value] : row) response.append(name, value);
  if (path.dynamics().heats()) {
    response.append("temperature", path.temperature());
    auto &warmest = summary.extra["friction"]["peak_temperature_C"];
    warmest = std::max(warmest.is_null() ? path.temperature() : warmest.get<double>(), path.temperature());
  }
  summary.min_normal_force = std::min(summary.min_normal_force.value_or(e.normal), e.normal);
}

/// Load parameters, a multiple of 4 a cycle, so that turning points are samples; of a file's path the turns as well.
std::vector<double> samples_of(const scene::Excitation &excitation) {
  const int n = scene::instants_a_cycle * static_cast<int>(excitation.whole_rounds());
  std::vector<double> samples;
  samples.reserve(n + 1);
  for (int i = 0; i <= n; ++i) samples.push_back(double(i) / n);
  if (excitation.kind != scene::ExcitationKind::path) return samples;
  for (const double turn : scene::prescribed_breakpoints(excitation)) samples.push_back(turn);
  std::sort(samples.begin(), samples.end());
  const auto same = [](double a, double b) { return b - a < 1e-12; };
  samples.erase(std::unique(samples.begin(), samples.end(), same), samples.end());
  return samples;
}

} // namespace

ReducedRun quasi_static(const scene::Scene &given) {
  const auto begin = std::chrono::steady_clock::now();
  scene::Scene scene = given;
  // Slow motion: nothing accelerates, friction is fully developed and its vertical part shares in carrying W.
  if (scene.reduced.normal_force != scene::NormalForce::constant)
    scene.reduced.normal_force = scene::NormalForce::statics;
  scene.reduced.friction = scene::Friction::coulomb;
  Path path(scene);
  ReducedRun run;
  EnergyLedger ledger;
  const std::vector<double> samples = samples_of(scene.excitation);
  store(path, 0, ledger, run.response, run.summary);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EnergyLedger after = ledger;
    add_works(path, samples[i - 1], samples[i], after);
    path.press(path.at(samples[i]));
    if (const auto end = path.gone_at(samples[i])) {
      run.summary.status = RunStatus::stopped, run.summary.reason = *end;
      break;
    }
    run.summary.n_steps = static_cast<long>(i), ledger = after;
    path.heat(samples[i - 1], samples[i]);
    store(path, samples[i], ledger, run.response, run.summary);
  }
  summarise_response(run.response, run.summary);
  run.summary.energy = ledger;
  run.summary.rung = SolvedBy::reduced;
  run.summary.n_dofs = 3;
  run.summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return run;
}

} // namespace rimpact::reduced
