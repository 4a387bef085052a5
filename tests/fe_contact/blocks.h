/// Blocks in contact that several tests share.
#pragma once
#include "box_mesh.h"
#include "fe_contact/drive/motion.h"
#include "fe_contact/engine/supports.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace rimpact::fe {

using Eigen::Vector3d;
using meshes::Surface;
using meshes::Volume;

constexpr double block_modulus = 1e9; ///< [Pa]

/// A contact at dof displacements u by equation, at the end of a step of 1 ms from `state`.
struct ContactAtU {
  SurfaceContact &contact;
  SurfaceContactState &state;
  const Equations &equations;
  const Eigen::VectorXd &u;
  SurfaceContactReport report{};
  Eigen::VectorXd forces{};

  Eigen::VectorXd forces_at(const Eigen::VectorXd &v, Tangent *tangent = nullptr) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(equations.n);
    report = contact.assemble(equations.expand(v), state, 1e-3, equations, result, tangent);
    return result;
  }
  /// The tangent is the derivative of the forces, where some points stick and others slip. Report and forces are left
  /// as they are at u.
  void expect_tangent(std::mt19937 &random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto couplings = contact.couplings(equations, equations.expand(u), state.opposite);
    TimeSplit times;
    Tangent tangent(equations.n, {}, couplings, Symmetry::general, times);
    forces_at(u, &tangent);
    ASSERT_GT(report.stick, 0);
    ASSERT_GT(report.slip, 0);
    for (int trial = 0; trial < 5; ++trial) {
      Eigen::VectorXd direction(equations.n);
      for (int i = 0; i < equations.n; ++i) direction[i] = unit(random);
      const double h = 1e-10;
      const Eigen::VectorXd expected = (forces_at(u + h * direction) - forces_at(u - h * direction)) / (2 * h);
      EXPECT_LT((tangent.multiply(direction) - expected).norm(), 1e-5 * expected.norm());
    }
    forces = forces_at(u);
  }
};

/// A block whose lower face rides on a carried sphere, held by its top; `covers`: where there is a sphere.
struct Block {
  explicit Block(const FrictionCoefficient &friction, int degree = 2, std::function<bool(const Vector3d &)> covers = {})
      : space(mesh(), degree), solid(space, {{Volume::rim, scene::Material{block_modulus, 0.3, 1000, {}, {}}}}),
        supports(space) {
    carrier = supports.add_body();
    for (int i = 0; i < 3; ++i) supports.fix(i, [](const Vector3d &x) { return x.z() > 0.1 - 1e-9; });
    system.emplace(space, solid, supports.number());
    SurfaceContactOptions options{{block_modulus / 0.05, block_modulus / 0.05, friction}};
    options.carrier_dof = carrier;
    MasterSurface ball = sphere({0.1, 0.05, -20.0}, 20.0, Side::outside);
    if (covers) ball.covers = std::move(covers);
    system->add_contact(Surface::slider_side, ball, options);
    system->add_mass(carrier, 5.0);
    for (int i = 0; i < 3; ++i) carrier_equations[i] = system->equations().of_dof[carrier + i];
  }
  static meshes::HexMesh mesh() {
    meshes::HexMesh result;
    test::add_box(result, {{0, 0, 0}, {0.2, 0.1, 0.1}, {2, 1, 1}, Volume::rim, {{4, Surface::slider_side}}});
    return result;
  }
  StepTerms drive(double dx, double dz, double dt) const {
    StepTerms terms{Eigen::VectorXd::Zero(system->equations().n)};
    terms.driven = {{carrier_equations[0], dx}, {carrier_equations[1], 0.3 * dx}, {carrier_equations[2], dz}};
    terms.dt = dt;
    return terms;
  }

  Discretisation space;
  Solid solid;
  Supports supports;
  int carrier = -1;
  int carrier_equations[3]{};
  std::optional<ContactSystem> system;
};

/// Two blocks that meet on a sphere of radius 2 m, the lower one's deformed face carrying it; meshes do not match.
struct TwoBlocks {
  explicit TwoBlocks(int degree)
      : space(mesh(), degree), solid(space, materials()), supports(space), equations(supports.number()) {
    contact.emplace(space, Surface::slider_side, master(), options());
  }
  static std::map<Volume, scene::Material> materials() {
    const scene::Material elastic{block_modulus, 0.3, 1000, {}, {}};
    return {{Volume::rim, elastic}, {Volume::plate, elastic}};
  }
  static MasterSurface master() { return sphere(Vector3d(0, 0, -2), 2.0, Side::outside); }
  static SurfaceContactOptions options() {
    SurfaceContactOptions result{{block_modulus / 0.05, block_modulus / 0.05, FrictionCoefficient::constant(0.3)}};
    result.carrier_faces = Surface::dish;
    return result;
  }
  static meshes::HexMesh mesh() {
    const auto bent = [](std::array<double, 3> x) {
      return std::array<double, 3>{x[0], x[1], x[2] + std::sqrt(4 - x[0] * x[0] - x[1] * x[1]) - 2};
    };
    meshes::HexMesh result;
    test::add_box(result, {{-0.1, -0.1, 0}, {0.1, 0.1, 0.1}, {2, 2, 1}, Volume::rim, {{4, Surface::slider_side}}},
                  bent);
    test::add_box(result, {{-0.15, -0.15, -0.1}, {0.15, 0.15, 0}, {3, 3, 1}, Volume::plate, {{5, Surface::dish}}},
                  bent);
    return result;
  }
  /// Upper block moved by `slide`, all nodes off by noise, the lower block sheared.
  Eigen::VectorXd moved(const Vector3d &slide, double noise) const {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    Eigen::VectorXd u(equations.n);
    std::vector<char> upper(space.n_nodes, 0);
    for (std::size_t c = 0; c < space.n_cells; ++c)
      for (int a = 0; a < space.nodes_per_cell; ++a)
        upper[space.cell_nodes[c * space.nodes_per_cell + a]] = space.volumes[c] == Volume::rim;
    for (std::size_t a = 0; a < space.n_nodes; ++a) {
      const Vector3d x = space.positions[a];
      u.segment<3>(3 * a) = (upper[a] ? slide : Vector3d(0.02 * x.z(), 0, 0.01 * x.x())) +
                            noise * Vector3d(unit(random), unit(random), unit(random));
    }
    return u;
  }
  Discretisation space;
  Solid solid;
  Supports supports;
  Equations equations;
  std::optional<SurfaceContact> contact;
};

/// A copper bar, plane strain, that hits a wall at 100 m/s and yields.
struct Bar {
  explicit Bar(const scene::StrainRate &rate = {})
      : space(mesh(), 2), solid(space, {{Volume::rim, scene::Material{117e9, 0.35, 8930, 200e6, 100e6, {}, rate}}}),
        supports(space) {
    supports.fix(1, [](const Vector3d &) { return true; });
    supports.fix(0, [](const Vector3d &x) { return x.x() < 1e-12; });
    system.emplace(space, solid, supports.number());
    const double penalty = 117e9 / 0.004;
    system->add_contact(Surface::slider_side, plane(Vector3d::Zero(), Vector3d::UnitZ()),
                        {{penalty, penalty, FrictionCoefficient::constant(0.2)}});
    options.step.max_augmentations = 0;
    options.largest_step = options.contact_step = 4e-7;
    options.smallest_step = 1e-8;
    options.energy_tolerance = 1e-3;
  }
  static meshes::HexMesh mesh() {
    meshes::HexMesh result;
    test::add_box(result, {{0, 0, 2e-4}, {0.006, 0.002, 0.024}, {2, 1, 5}, Volume::rim, {{4, Surface::slider_side}}});
    return result;
  }
  SystemState thrown() {
    SystemState state = system->at_rest();
    for (std::size_t dof = 2; dof < system->equations().of_dof.size(); dof += 3)
      if (const int equation = system->equations().of_dof[dof]; equation >= 0) state.v[equation] = -100;
    return state;
  }
  MotionReport run(SystemState &state, double end) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(state.u.size());
    return run_in_time(
        *system, state, end, [&](double) { return none; }, options,
        [](double, const SystemState &, const ContactStepReport &) {}, from, after_point);
  }
  Discretisation space;
  Solid solid;
  Supports supports;
  std::optional<ContactSystem> system;
  MotionOptions options;
  MotionPoint from;
  AfterPoint after_point;
};

} // namespace rimpact::fe
