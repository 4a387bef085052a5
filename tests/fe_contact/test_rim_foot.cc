// What goes through the rim's foot: closed forms of uniform states, and the balance of a pressed sector.
#include "box_mesh.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/top_drive.h"
#include "fe_contact/engine/internal_forces.h"
#include "fe_contact/engine/solid_fields.h"
#include "fe_contact/rungs/rim.h"
#include <cmath>
#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <set>

namespace rimpact::fe {
namespace {

using Eigen::Vector3d;
using meshes::Volume;

/// A straight, short piece of the wall on its plate, without lateral strain, so that its faces are free.
struct Piece {
  static constexpr double half_length = 0.002, height = 0.06;
  scene::Bearing bearing = [] {
    scene::Bearing b;
    b.steel.nu = 0;
    return b;
  }();
  meshes::HexMesh mesh = [this] {
    const double inner = bearing.surface.planar_radius, outer = inner + bearing.rim.thickness;
    meshes::HexMesh m;
    test::add_box(m, {{inner, -half_length, -height}, {outer, half_length, height}, {2, 1, 4}, Volume::plate, {}});
    for (std::size_t c = 0; c < m.cells.size(); ++c)
      if (m.nodes[m.cells[c][26]][2] > 0) m.volumes[c] = Volume::rim;
    return m;
  }();
  Discretisation space{mesh, 2};
  Solid solid{space, bearing};
  RimFoot foot{space, solid, bearing, false};
  SolidHistory history = solid.initial_history();

  FootForces of(const std::function<Vector3d(double x, double z)> &displacement) const {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(space.n_dofs()));
    const double middle = bearing.surface.planar_radius + bearing.rim.thickness / 2;
    for (std::size_t a = 0; a < space.n_nodes; ++a)
      u.segment<3>(static_cast<Eigen::Index>(3 * a)) =
          displacement(space.positions[a].x() - middle, space.positions[a].z());
    return foot.of(u, history);
  }
};

TEST(RimFoot, ClosedFormsOfTensionShearAndBending) {
  const Piece piece;
  const double E = piece.bearing.steel.E, G = E / 2, t = piece.bearing.rim.thickness, length = 2 * Piece::half_length;
  constexpr double e = 1e-7, off = 1e-4;
  EXPECT_EQ(piece.foot.nodes().size(), 15u);
  const FootForces pulled = piece.of([](double, double z) { return Vector3d(0, 0, e * z); });
  EXPECT_NEAR(pulled.worst.normal, E * e * t, off * E * e * t);
  EXPECT_NEAR(pulled.normal, E * e * t * length, off * E * e * t * length);
  EXPECT_NEAR(pulled.worst.moment, 0, off * E * e * t * t);
  const FootForces sheared = piece.of([](double, double z) { return Vector3d(e * z, 0, 0); });
  EXPECT_NEAR(sheared.worst.shear, G * e * t, off * G * e * t) << "outwards is positive";
  EXPECT_NEAR(sheared.shear, G * e * t * length, off * G * e * t * length);
  constexpr double curvature = -1e-5; // [1/m]: pressed outside
  const FootForces bent =
      piece.of([](double x, double z) { return Vector3d(-curvature * z * z / 2, 0, curvature * x * z); });
  const double moment = -E * curvature * t * t * t / 12;
  EXPECT_NEAR(bent.worst.moment, moment, off * moment) << "tipping outwards is positive";
  EXPECT_NEAR(bent.moment, moment * length, off * moment * length);
  constexpr double straight = 1e-3; // the piece is no part of a ring
  EXPECT_NEAR(bent.worst.normal, 0, straight * moment / t);
  EXPECT_NEAR(bent.weld, moment / t, straight * moment / t);
  EXPECT_FALSE(bent.use) << "one piece";
}

/// Internal forces of the wall's nodes at the sector's end, above the foot [N].
Vector3d held_at_the_end(const BearingModel &model, const Eigen::VectorXd &u, const SolidHistory &history) {
  const Discretisation &space = model.space;
  const std::set<unsigned> foot(model.foot.nodes().begin(), model.foot.nodes().end());
  const auto ends = space.nodes_of(meshes::Surface::sector_end);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t c = 0; c < space.n_cells; ++c) {
    if (space.volumes[c] != Volume::rim) continue;
    const Eigen::Matrix3Xd forces = internal_forces(model.solid, space, c, u, history);
    for (int a = 0; a < space.nodes_per_cell; ++a) {
      const unsigned node = space.cell_nodes[c * space.nodes_per_cell + a];
      if (foot.count(node) == 0 && std::binary_search(ends.begin(), ends.end(), node)) sum += forces.col(a);
    }
  }
  return sum;
}

/// A sector whose wall yields: what goes through the foot is what the slider presses on the wall with, less what the
/// sector's cuts hold. Moments alike.
TEST(RimFoot, BalancesTheSlidersPress) {
  scene::Scene scene = scene::load_scene("impact-window", {"model.mesh=0"});
  scene.bearing.rim.connection.kind = scene::ConnectionKind::fillet;
  scene.bearing.rim.connection.throat = 0.010;
  const BearingModel model(rungs::rim, scene.bearing, {.level = 0, .half = true});
  BearingSystem system(model, 0);
  SystemState state = system.at_rest();
  TopDrive drive;
  const Eigen::VectorXd no_load = Eigen::VectorXd::Zero(system.equations().n);
  StepOptions options = step_options(rungs::rim, scene);
  options.newton.tolerance = 1e-7, options.newton.max_iterations = 40;
  for (const double d : {0.05e-3, 0.1e-3, 0.2e-3, 0.4e-3, 0.8e-3, 1.3e-3, 2e-3}) {
    const auto report = drive.move_to(system, state, {{d, 0}, 0.0}, no_load, options);
    ASSERT_TRUE(report.converged) << report.reason;
  }
  const Eigen::VectorXd u = system.expand(state);
  const Discretisation &space = model.space;
  const std::set<unsigned> foot(model.foot.nodes().begin(), model.foot.nodes().end());
  std::set<unsigned> cut;
  for (const auto group : {meshes::Surface::symmetry, meshes::Surface::sector_end})
    for (const unsigned node : space.nodes_of(group)) cut.insert(node);
  Vector3d pressed = Vector3d::Zero(), held = pressed, moment = pressed; // of the half
  double strain = 0;
  for (std::size_t c = 0; c < space.n_cells; ++c) {
    if (space.volumes[c] != Volume::rim) continue;
    const Eigen::Matrix3Xd forces = internal_forces(model.solid, space, c, u, state.history);
    for (int a = 0; a < space.nodes_per_cell; ++a) {
      const unsigned node = space.cell_nodes[c * space.nodes_per_cell + a];
      if (foot.count(node) > 0) continue;
      (cut.count(node) > 0 ? held : pressed) += forces.col(a);
      moment += (space.positions[node] + u.segment<3>(3 * node)).cross(Vector3d(forces.col(a)));
    }
    for (int q = 0; q < space.full.n_points; ++q)
      strain = std::max(strain, state.history[c * space.full.n_points + q].alpha);
  }
  ASSERT_GT(strain, 1e-3) << "the wall is to yield";
  const double force = -system.force_of(state, Role::wall).x() / model.share();
  ASSERT_GT(force, 1e5);
  // Nodes of the wall on the plane of symmetry are pressed too: radially they are free.
  const Eigen::Matrix3Xd through = model.foot.nodal_forces(u, state.history);
  EXPECT_NEAR(through.row(0).sum(), pressed.x() + held.x(), 1e-9 * force);
  EXPECT_NEAR(through.row(2).sum(), pressed.z() + held.z(), 1e-9 * force);
  Vector3d of_foot = Vector3d::Zero();
  for (std::size_t k = 0; k < model.foot.nodes().size(); ++k) {
    const unsigned node = model.foot.nodes()[k];
    of_foot += (space.positions[node] + u.segment<3>(3 * node)).cross(Vector3d(through.col(static_cast<int>(k))));
  }
  EXPECT_LT((of_foot - moment).norm(), 1e-9 * moment.norm());
  const Vector3d of_ends = held_at_the_end(model, u, state.history); // radially held there alone
  EXPECT_NEAR(through.row(0).sum() - of_ends.x(), force, 1e-5 * force) << "the contact's own force";
  const FootForces forces = model.foot.of(u, state.history);
  EXPECT_GT(forces.worst.moment, 0);
  EXPECT_GT(forces.worst.shear, 0);
  EXPECT_NEAR(*forces.use, weld_force(forces.worst, 0.04) / (0.010 * weld_strength(scene.bearing.rim.connection)),
              1e-3 * *forces.use);
  EXPECT_NEAR(forces.shear, 2 * through.row(0).sum(), 0.05 * forces.shear) << "less what the cuts hold along the rim";
}

/// A wall that is thrown outwards: what goes through its foot is the press less what accelerates the wall, by the
/// integrator's own acceleration.
TEST(RimFoot, BalancesThePressLessTheWallsInertiaInMotion) {
  scene::Scene scene = scene::load_scene("impact-window", {"model.mesh=0"});
  scene.bearing.steel.rate.model = scene::RateModel::cowper_symonds;
  const BearingModel model(rungs::rim, scene.bearing, {.level = 0, .half = true});
  BearingSystem system(model, scene.load.mass);
  SystemState state = system.at_rest();
  system.set_position(state, {-2e-5, 0, 0}, {1, 0, 0}, Vector3d::Zero());
  StepOptions options = step_options(rungs::rim, scene);
  options.newton.tolerance = 1e-7, options.newton.max_iterations = 40;
  StepTerms terms{Eigen::VectorXd::Zero(system.equations().n)};
  terms.dt = 1e-4;
  Eigen::VectorXd before;
  for (int k = 0; k < 8; ++k) {
    before = state.a;
    const auto report = time_step(system, state, terms, options);
    ASSERT_TRUE(report.converged) << report.reason;
  }
  const double alpha_m = GeneralizedAlpha::from(options.rho_inf).alpha_m;
  const Eigen::VectorXd inertial = system.mass_times((1 - alpha_m) * state.a + alpha_m * before);
  const Discretisation &space = model.space;
  std::set<unsigned> wall;
  for (std::size_t c = 0; c < space.n_cells; ++c)
    for (int a = 0; a < space.nodes_per_cell && space.volumes[c] == Volume::rim; ++a)
      wall.insert(space.cell_nodes[c * space.nodes_per_cell + a]);
  for (const unsigned node : model.foot.nodes()) wall.erase(node);
  for (const unsigned node : space.nodes_of(meshes::Surface::sector_end)) wall.erase(node);
  double inertia = 0;
  for (const unsigned node : wall)
    if (const int equation = system.equations().of_dof[3 * node]; equation >= 0) inertia += inertial[equation];
  const Eigen::VectorXd u = system.expand(state);
  const double force = -system.force_of(state, Role::wall).x() / model.share();
  const double through = model.foot.nodal_forces(u, state.history).row(0).sum();
  ASSERT_GT(largest_plastic_strain(state.history), 1e-3) << "the wall is to yield";
  EXPECT_GT(std::abs(inertia), 1e-3 * force) << "the wall's inertia is to be seen";
  EXPECT_NEAR(through - held_at_the_end(model, u, state.history).x(), force - inertia, 1e-5 * force);
}

} // namespace
} // namespace rimpact::fe
