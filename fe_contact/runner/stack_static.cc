// Quasi-static paths of rung R2: preload under the dead load, then the top face is driven along the path.
#include "fe_contact/runner/record_checkpoint.h"
#include "fe_contact/runner/stack_model.h"
#include "fe_contact/runner/stack_run.h"
#include "fe_contact/runner/system_checkpoint.h"
#include "scene/error.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <tuple>

namespace rimpact::fe {
namespace {

struct StaticPath {
  const scene::Scene &scene;
  const RunOptions &options;
  RunRecord &record;
  StackModel model;
  SystemState state;
  Eigen::VectorXd load, last_change; ///< the last step's
  Eigen::Vector2d last_way = Eigen::Vector2d::Zero();
  StepOptions step_options;
  double rest_height = 0; ///< of the top face under the load [m]

  StaticPath(const scene::Scene &scene, const Plan &plan, const RunOptions &options, RunRecord &record)
      : scene(scene), options(options), record(record),
        model(scene.bearing, {scene.model.mesh, plan.half, false}), state(model.system().at_rest()),
        load(model.dead_load(scene.load.vertical)) {
    record.n_dofs = model.system().equations().n;
    step_options.newton.tolerance = 1e-6;
    step_options.gap_tolerance = 1e-5;
    step_options.slip_tolerance = 1e-5;
    step_options.max_augmentations = 4;
  }

  void preload() {
    constexpr double springs = 1e8; // first round of stabilisation [N/m an equation]
    const PreloadReport report = fe::preload(model.system(), state, load, springs, step_options);
    record.n_newton += report.iterations;
    if (!report.converged) throw SolverStopped("the bearing did not come to rest under its load: " + report.reason);
    rest_height = model.top_of(state.u).z();
  }

  Attempt attempt(double s, double ds) {
    if (options.interrupted && *options.interrupted) throw Interrupted();
    const Eigen::Vector2d target = scene::prescribed_displacement(scene.excitation, scene.bearing.lateral_capacity(), s + ds);
    StepTerms terms{load};
    for (int i = 0; i < 2; ++i)
      if (model.top(i) >= 0) terms.driven.push_back({model.top(i), target[i]});
    const Eigen::Vector3d before = model.top_of(state.u), force_before = on_the_mass();
    const Eigen::VectorXd u_before = state.u;
    const Eigen::Vector2d way = target - before.head<2>();
    const ContactStepReport step = static_step(model.system(), state, terms, step_options, guess(way));
    record.n_newton += step.iterations;
    if (!step.converged) {
      ++record.n_cuts;
      return {false, 0, step.reason};
    }
    last_change = state.u - u_before;
    last_way = way;
    ++record.n_steps;
    record.augmentation_caps += step.capped;
    account(before, force_before);
    sample(s + ds, step, ds);
    if (options.progress)
      options.progress({s + ds, 1.0, ds, step.iterations, scene.bearing.lateral_capacity() - target.norm(),
                        on_the_mass().head<2>().norm(), "sliding"});
    return {true, 0, {}};
  }

  /// The stack follows its top face: the last step's change scaled to this step's way, at first a translation.
  Eigen::VectorXd guess(const Eigen::Vector2d &way) const {
    if (last_way.squaredNorm() > 0) return state.u + way.dot(last_way) / last_way.squaredNorm() * last_change;
    const auto &equations = model.system().equations();
    Eigen::VectorXd u = state.u;
    for (std::size_t dof = 0; dof < equations.of_dof.size(); ++dof)
      if (const int equation = equations.of_dof[dof]; equation >= 0 && dof % 3 < 2)
        u[equation] = state.u[equation] + way[dof % 3];
    return u;
  }

  /// What the bearing does to the mass: the dish's force on the pad, everything between being in equilibrium.
  Eigen::Vector3d on_the_mass() const {
    Eigen::Vector3d force = model.share() * state.reports[StackModel::dish].force;
    if (model.share() > 1) force.y() = 0; // the mirrored half takes it away
    return force;
  }

  void account(const Eigen::Vector3d &before, const Eigen::Vector3d &force_before) {
    const Eigen::Vector3d du = model.top_of(state.u) - before;
    auto &ledger = record.ledger;
    ledger.external -= 0.5 * (force_before + on_the_mass()).head<2>().dot(du.head<2>());
    ledger.gravity += scene.load.vertical * du.z();
    ledger.elastic = model.share() * state.energies.elastic - rest_elastic;
    ledger.plastic = model.share() * state.energies.plastic;
    for (const auto &report : state.reports) {
      ledger.friction += model.share() * report.friction_work;
      ledger.contact += model.share() * report.normal_work;
    }
    ledger.largest_input = std::max(ledger.largest_input, std::abs(ledger.external));
  }

  void sample(double s, const ContactStepReport &step, double ds) {
    auto &r = record.response;
    const Eigen::Vector3d force = on_the_mass(), u = model.top_of(state.u) - Eigen::Vector3d(0, 0, rest_height);
    Eigen::Vector3d friction = model.share() * state.reports[StackModel::dish].friction;
    if (model.share() > 1) friction.y() = 0;
    r.append("time", s);
    const char *axes[3] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
      r.append(std::string("displacement_") + axes[i], u[i]);
      r.append(std::string("velocity_") + axes[i], 0);
      r.append(std::string("force_") + axes[i], force[i]);
      if (i == 2) break;
      r.append(std::string("pendular_") + axes[i], force[i] - friction[i]);
      r.append(std::string("friction_") + axes[i], friction[i]);
      r.append(std::string("impact_") + axes[i], 0);
    }
    const double gap = scene.bearing.lateral_capacity() - u.head<2>().norm();
    double strain = 0;
    for (const auto &point : state.history) strain = std::max(strain, point.alpha);
    const auto &e = record.ledger;
    const std::pair<const char *, double> values[] = {
        {"normal_force", force.z()},
        {"gap", gap},
        {"surface_gap", gap},
        {"plastic_strain_max", strain},
        {"contact_pressure_max", state.reports[StackModel::dish].largest_pressure},
        {"newton_iterations", static_cast<double>(step.iterations)},
        {"step", ds},
        {"energy_external", e.external},
        {"energy_gravity", e.gravity},
        {"energy_kinetic", 0},
        {"energy_elastic", e.elastic},
        {"energy_plastic", e.plastic},
        {"energy_friction", e.friction},
        {"energy_impact", 0},
        {"energy_contact", e.contact},
        {"energy_integrator", 0}};
    for (const auto &[name, value] : values) r.append(name, value);
  }

  void write_fields(double s) {
    if (!options.fields || options.folder.empty()) return;
    const Discretisation &space = model.space();
    const Eigen::VectorXd u = model.system().expand(state);
    SolidFields cells = model.solid().fields(u, state.history);
    std::vector<double> pressure(space.n_nodes, 0.0), gap(space.n_nodes, 0.0);
    for (std::size_t i = 0; i < state.contacts.size(); ++i)
      model.system().contact(i).nodal_fields(state.contacts[i], pressure, gap);
    for (double &value : pressure) value *= 1e-6;
    for (double &value : gap) value *= 1e3;
    for (double &value : cells.von_mises) value *= 1e-6;
    const auto name = fmt::format("fields/stack_{:03d}.vtu", record.fields.size());
    std::filesystem::create_directories(options.folder + "/fields");
    space.write_vtu(options.folder + "/" + name, {{"displacement", 3, false, {u.data(), u.data() + u.size()}},
                                                  {"contact_pressure_MPa", 1, false, pressure},
                                                  {"gap_mm", 1, false, gap},
                                                  {"von_mises_MPa", 1, true, cells.von_mises},
                                                  {"equivalent_plastic_strain", 1, true, cells.plastic_strain}});
    record.fields.emplace_back(s, name);
  }

  double rest_elastic = 0; ///< energy of the preload, not counted [J]

  std::string checkpoint_path() const { return options.folder + "/checkpoint.h5"; }

  void save(double s, double ds) const {
    if (options.folder.empty()) return;
    Checkpoint file;
    put(file, scene, record);
    put(file, state);
    file.numbers["path"] = {s, ds, rest_height, rest_elastic, last_way.x(), last_way.y()};
    file.numbers["last_change"] = list(last_change);
    write_checkpoint(file, checkpoint_path());
  }

  /// Where the kept run stopped, and its next step.
  std::pair<double, double> restore() {
    const Checkpoint file = read_checkpoint(checkpoint_path());
    get(file, checkpoint_path(), scene, record);
    get(file, state);
    const auto &p = numbers(file, "path");
    rest_height = p[2], rest_elastic = p[3], last_way = {p[4], p[5]};
    last_change = vector(numbers(file, "last_change"));
    return {p[0], p[1]};
  }

  void run() {
    constexpr int steps_a_cycle = 160, checkpoint_every = 10;
    const double cycles = scene.excitation.kind == scene::ExcitationKind::cyclic ? scene.excitation.cycles : 1.0;
    const double largest = 1.0 / (steps_a_cycle * cycles), picture = 0.25 / cycles;
    double start = 0, first = 1e-3 * largest;
    if (options.resume) {
      std::tie(start, first) = restore();
    } else {
      preload();
      rest_elastic = model.share() * state.energies.elastic;
      sample(0, {}, 0);
      write_fields(0);
    }
    const MarchReport report = march(start, 1, {first, 1e-8 * largest, largest, 2.0}, [&](double s, double ds) {
      const Attempt result = attempt(s, ds);
      if (!result.accepted) return result;
      if (std::floor((s + ds) / picture + 1e-9) > std::floor(s / picture + 1e-9)) write_fields(s + ds);
      if (record.n_steps % checkpoint_every == 0) save(s + ds, ds);
      return result;
    });
    save(report.reached, largest);
    if (!report.finished)
      throw SolverStopped(fmt::format("the path stopped at load parameter {:.4f}: {}; partial results are kept; try "
                                      "--mesh 2, or go on with --resume",
                                      report.reached, report.reason));
  }
};

} // namespace

void run_stack_static(const scene::Scene &scene, const Plan &plan, const RunOptions &options, RunRecord &record) {
  StaticPath path(scene, plan, options, record);
  const auto keep = [&] {
    record.time_split = path.model.system().time_split;
  };
  try {
    path.run();
  } catch (...) {
    keep();
    throw;
  }
  keep();
}

} // namespace rimpact::fe
