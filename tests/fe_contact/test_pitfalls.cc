// Failures of other contact codes, each a test (VERIFICATION, last paragraph). The state after a cut-back is tested in
// test_surface_contact.cc, restarts in test_restart.cc, stiff and soft penalties by verify_contact hard-states.
#include "blocks.h"
#include "fe_contact/drive/flight_step.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

TEST(Pitfall, FrictionFollowsThePressureOfItsOwnStepNotTheLastOnes) {
  Block block(FrictionCoefficient::constant(0.3));
  SystemState state = block.system->at_rest();
  ASSERT_TRUE(static_step(*block.system, state, block.drive(1e-3, 1e-4, 1e-3), {}).converged);
  const double before = state.reports[0].force.z();
  // One step slides on and trebles the pressure.
  const auto step = static_step(*block.system, state, block.drive(2e-3, 3e-4, 1e-3), {});
  ASSERT_TRUE(step.converged) << step.reason;
  EXPECT_GT(state.reports[0].force.z(), 2.5 * before);
  const auto &contact = state.contacts[0];
  int slipping = 0;
  for (std::size_t k = 0; k < contact.pressure.size(); ++k) {
    if (contact.status[k] != ContactStatus::slip) continue;
    ++slipping;
    EXPECT_NEAR(contact.friction[k].norm(), 0.3 * contact.pressure[k], 1e-9 * contact.pressure[k]);
  }
  EXPECT_GT(slipping, 0);
}

TEST(Pitfall, PairingIsNotFrozenWithinAStep) {
  // The lower block's faces are 0.1 m wide; one step slides by 0.08 m, many points over a face's edge.
  TwoBlocks blocks(2);
  SurfaceContactState state = blocks.contact->open(blocks.moved({0.0, 0, 0}, 0));
  const auto first = state.opposite;
  const Eigen::VectorXd u = blocks.moved({0.045, 0.03, -1e-4}, 1e-5);
  blocks.contact->couplings(blocks.equations, u, state.opposite);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(blocks.equations.n), fresh_forces = forces;
  const auto report = blocks.contact->assemble(u, state, 0, blocks.equations, forces, nullptr);
  SurfaceContactState fresh = blocks.contact->open(u);
  fresh.start = state.start;
  blocks.contact->assemble(u, fresh, 0, blocks.equations, fresh_forces, nullptr);
  int changed = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    changed += state.opposite[k] != first[k];
    EXPECT_EQ(state.opposite[k], fresh.opposite[k]) << k;
    EXPECT_NEAR(state.gap[k], fresh.gap[k], 1e-15) << k;
  }
  EXPECT_GT(changed, 10);
  EXPECT_GT(report.slip, 0);
  EXPECT_LT((forces - fresh_forces).norm(), 1e-12 * forces.norm());
}

TEST(Pitfall, AFaceOnceFoundIsFoundAgain) {
  // Two faces, stretched: from the middle of either one the search for a point at their common edge leads into the
  // other. Looked for from what was found last it must stay there, or each evaluation of Newton's sees another face.
  constexpr double stretch = 0.2;
  meshes::HexMesh mesh;
  test::add_box(mesh, {{-0.01, 0, 0}, {0.01, 0.01, 0.01}, {2, 1, 1}, Volume::rim, {{5, Surface::dish}}});
  for (const int degree : {1, 2}) {
    const Discretisation space(mesh, degree);
    const MasterFaces faces(space, Surface::dish);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * space.positions.size());
    for (std::size_t node = 0; node < space.positions.size(); ++node) u[3 * node] = stretch * space.positions[node].x();
    for (const double past : {-2e-5, 0.0, 2e-5}) // of a half width of 5 mm
      for (const int first : {0, 1}) {
        const Vector3d x((1 + stretch) * past, 0.005, 0.0101);
        const Opposite found = faces.find(x, u, first, 0);
        ASSERT_GE(found.face, 0);
        EXPECT_NEAR(found.y.x(), past, 1e-12);
        EXPECT_EQ(faces.find(x, u, found.face, 0).face, found.face) << degree << ", " << past << ", from " << first;
      }
    EXPECT_EQ(faces.find({0.006, 0.005, 0.0101}, u, 0, 0).face, faces.find({0.006, 0.005, 0.0101}, u, 1, 0).face);
  }
}

TEST(Pitfall, APointThatLeavesADentedFaceIsFoundOnItsNeighbour) {
  // The face found last is dented by 6 mm at its middle: pulled back with the middle's displacement the point lies
  // beside no face at all, though the neighbour carries it.
  meshes::HexMesh mesh;
  test::add_box(mesh, {{-0.01, 0, 0}, {0.01, 0.01, 0.01}, {2, 1, 1}, Volume::rim, {{5, Surface::dish}}});
  const Discretisation space(mesh, 2);
  const MasterFaces faces(space, Surface::dish);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * space.positions.size());
  const int left = faces.find({-0.005, 0.005, 0.0101}, u, -1, 0).face;
  ASSERT_GE(left, 0);
  const auto &nodes = space.faces_of(Surface::dish)[left]->nodes;
  u[3 * nodes[nodes.size() / 2] + 2] = -0.006;
  const Vector3d x(1.5e-4, 0.005, 0.0101); // past the edge by 0.03 half widths: more than a point keeps its face
  const Opposite found = faces.find(x, u, left, 0);
  EXPECT_EQ(found.face, 1 - left);
  EXPECT_NEAR((found.y - x).norm(), 0, 1e-12);
}

TEST(Pitfall, APatternMadeOnADentedCarrierHoldsWhatIsOpposite) {
  // A dent deeper than the margin at the carrier's first face: what lies opposite elsewhere must not be looked for
  // there.
  TwoBlocks blocks(2);
  SurfaceContactState state = blocks.contact->open(blocks.moved({0, 0, 0}, 0));
  Eigen::VectorXd u = blocks.moved({0, 0, -1e-4}, 0);
  const auto &first = blocks.space.faces_of(Surface::dish)[0]->nodes;
  u[3 * first[first.size() / 2] + 2] -= 0.3;
  blocks.contact->couplings(blocks.equations, u, state.opposite);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(blocks.equations.n);
  const auto report = blocks.contact->assemble(u, state, 0, blocks.equations, forces, nullptr);
  EXPECT_TRUE(report.pattern_holds);
  EXPECT_GT(report.stick + report.slip, 30);
  EXPECT_LT(forces.norm(), 3 * report.force.norm()); // of both bodies
  EXPECT_GT(forces.norm(), 0.1 * report.force.norm());
}

TEST(Pitfall, APointThrownPastTheFacesOppositeIsMissedAndItsStepRefused) {
  // Flat blocks: the upper one ends at 0.1 m, the lower one at 0.15 m; half of half a face's width beyond is still
  // looked at.
  meshes::HexMesh mesh;
  test::add_box(mesh, {{-0.1, -0.1, 0}, {0.1, 0.1, 0.1}, {2, 2, 1}, Volume::rim, {{4, Surface::slider_side}}});
  test::add_box(mesh, {{-0.15, -0.15, -0.1}, {0.15, 0.15, 0}, {3, 3, 1}, Volume::plate, {{5, Surface::dish}}});
  const Discretisation space(mesh, 2);
  const Solid solid(space, TwoBlocks::materials());
  Supports supports(space);
  supports.fix(Volume::plate);
  const auto top = [](const Vector3d &x) { return x.z() > 0.09; };
  const int along = supports.tie(0, top), down = supports.tie(2, top);
  supports.fix(1, top);
  ContactSystem system(space, solid, supports.number());
  SurfaceContactOptions smooth = TwoBlocks::options();
  smooth.law.friction = FrictionCoefficient::constant(0);
  system.add_contact(Surface::slider_side, plane(Vector3d::Zero(), Vector3d::UnitZ()), smooth);
  SystemState state = system.at_rest();
  const auto step = [&](double x, double z) {
    StepTerms terms{Eigen::VectorXd::Zero(system.equations().n)};
    terms.driven = {{along, x}, {down, z}};
    return static_step(system, state, terms, {});
  };
  ASSERT_TRUE(step(0, -1e-4).converged);
  const double bore = state.reports[0].force.z();
  EXPECT_GT(bore, 0);
  const auto refused = step(0.09, -1e-4);
  EXPECT_FALSE(refused.converged);
  EXPECT_NE(refused.reason.find("past the faces"), std::string::npos);
  EXPECT_EQ(state.reports[0].force.z(), bore); // the state is as it was
  for (double x = 0.01; x < 0.095; x += 0.01) {
    const auto taken = step(x, -1e-4);
    EXPECT_TRUE(taken.converged) << x << ": " << taken.reason;
  }
  // Lifted, what has nothing opposite any more bears nothing; at 8 mm a window on mesh 1 once stopped for such a point,
  // at less than one, between bodies of millimetres, ironing by a die.
  for (const double lift : {0.0005, 0.008, 0.015}) {
    ASSERT_TRUE(step(0, lift).converged) << lift;
    const auto &covered = state.contacts[0].covered;
    ASSERT_NE(std::find(covered.begin(), covered.end(), 1), covered.end()) << lift;
    EXPECT_TRUE(step(0.09, lift).converged) << lift;
  }
}

/// A block on a plane under its weight `normal` [N] and a push along the plane, shared out over its mass.
struct Pushed {
  Pushed()
      : space(mesh(), 2), solid(space, {{Volume::rim, scene::Material{block_modulus, 0.0, 1000, {}, {}}}}),
        supports(space) {
    supports.fix(1, [](const Vector3d &) { return true; });
    system.emplace(space, solid, supports.number());
    system->add_contact(Surface::slider_side, plane(Vector3d(0, 0, 1e-9), Vector3d::UnitZ()),
                        {{block_modulus / 0.05, block_modulus / 0.05, FrictionCoefficient::constant(0.3)}});
    state = system->at_rest();
    options.gap_tolerance = options.slip_tolerance = 1e-10;
  }
  static meshes::HexMesh mesh() {
    meshes::HexMesh result;
    test::add_box(
        result, {{0, 0, 0}, {0.4, 0.1, 0.01}, {4, 1, 1}, Volume::rim, {{4, Surface::slider_side}, {5, Surface::top}}});
    return result;
  }
  Eigen::VectorXd load(double pressure, double share) const {
    return system->surface_load(Surface::top, [=](const Vector3d &, const Vector3d &) {
      return Vector3d(share * 0.3 * pressure, 0, -pressure);
    });
  }
  Discretisation space;
  Solid solid;
  Supports supports;
  std::optional<ContactSystem> system;
  SystemState state;
  StepOptions options;
};

TEST(Pitfall, SpringsOfAPreloadAreWeakenedByLessWhereNewtonFails) {
  Pushed usual, hurried;
  hurried.options.newton.max_iterations = 2; // tenfold is then too much for one round
  const auto whole = preload(*usual.system, usual.state, usual.load(1e5, 0.5), 1e8, usual.options),
             parts = preload(*hurried.system, hurried.state, hurried.load(1e5, 0.5), 1e8, hurried.options);
  ASSERT_TRUE(whole.converged && parts.converged) << whole.reason << parts.reason;
  EXPECT_GT(parts.rounds, whole.rounds);
  EXPECT_LT(parts.stabilisation_share, 1e-6);
  EXPECT_LT((hurried.state.u - usual.state.u).norm(), 0.02 * usual.state.u.norm()); // friction keeps the way it came
}

TEST(Pitfall, ALoadOnTheVergeOfSlipOrOfTouchDoesNotChatter) {
  Pushed pushed;
  // One step from half the friction's limit to nine tenths fails and is cut; to and fro near the limit none is.
  ASSERT_TRUE(preload(*pushed.system, pushed.state, pushed.load(1e5, 0.5), 1e8, pushed.options).converged);
  for (const auto &[from, to] : {std::pair{0.5, 0.9}, {0.9, 0.99}, {0.99, 0.97}, {0.97, 0.99}}) {
    int iterations = 0;
    const auto report = march(0, 1, {1, 0.01, 1}, [&](double t, double dt) -> Attempt {
      const StepTerms terms{pushed.load(1e5, from + (t + dt) * (to - from))};
      const auto step = static_step(*pushed.system, pushed.state, terms, pushed.options);
      iterations += step.iterations;
      return {step.converged, 0, step.reason};
    });
    ASSERT_TRUE(report.finished) << to << ": " << report.reason;
    EXPECT_LE(report.cuts, 3) << to;
    EXPECT_NEAR(pushed.state.reports[0].force.x() / pushed.state.reports[0].force.z(), -0.3 * to, 1e-6);
    EXPECT_LE(iterations, 120) << to; // about two a solution of the augmentations
  }
  // Beyond the limit nothing holds the block: a bounded number of iterations and a sentence, not a dance.
  const SystemState before = pushed.state;
  const auto step = static_step(*pushed.system, pushed.state, StepTerms{pushed.load(1e5, 1.05)}, pushed.options);
  EXPECT_FALSE(step.converged);
  EXPECT_FALSE(step.reason.empty());
  EXPECT_EQ((before.u - pushed.state.u).norm(), 0);
}

TEST(Pitfall, AfterAStepThatDoesNotConvergeTheNextOnesDoNotGrow) {
  Pushed pushed;
  MotionOptions options{.step = pushed.options, .largest_step = 1, .smallest_step = 1e-6, .contact_step = 1e-3};
  int asked = 0; // for the load, at a step's start and at its end
  const auto load = [&](double) {
    ++asked;
    options.step.newton.max_iterations = asked == 3 || asked == 4 ? 0 : 20; // the second step does not converge
    return pushed.load(1e5, 0.5);
  };
  ASSERT_TRUE(preload(*pushed.system, pushed.state, pushed.load(1e5, 0.5), 1e8, pushed.options).converged);
  MotionPoint from{.t = 0.1, .next_step = 1e-4};
  from.ledger = ledger_at(*pushed.system, pushed.state);
  from.scale = {from.ledger.initial, from.ledger.initial};
  std::vector<double> growth; // it rests: nothing speaks against longer steps
  double before = from.t;
  const auto report = run_in_time(
      *pushed.system, pushed.state, 0.2, load, options, [](double, const SystemState &, const ContactStepReport &) {},
      from,
      [&](const MotionPoint &point) {
        growth.push_back(point.next_step / (point.t - before));
        before = point.t;
      });
  ASSERT_TRUE(report.march.finished) << report.march.reason;
  EXPECT_EQ(report.march.cuts, 1);
  ASSERT_GT(growth.size(), 5U);
  EXPECT_GT(growth[0], 1.5);
  for (const int k : {1, 2, 3}) EXPECT_LE(growth[k], 1 + 1e-9) << k;
  EXPECT_GT(growth[4], 1.5);
}

TEST(Pitfall, ABodyThatJustTouchesStaysAsItIs) {
  Block block(FrictionCoefficient::constant(0.3));
  SystemState state = block.system->at_rest();
  for (int k = 0; k < 5; ++k) { // to and fro by a hundred nanometres about touch
    const auto step = static_step(*block.system, state, block.drive(0, k % 2 ? 1e-7 : 0.0, 1e-3), {});
    ASSERT_TRUE(step.converged) << step.reason;
    EXPECT_LE(step.iterations / (1 + step.augmentations), 6);
  }
  EXPECT_GE(state.reports[0].force.z(), 0);
}

TEST(Pitfall, AStepCutToMicrosecondsDoesNotLeaveAPenaltyStifferThanTheSolid) {
  // The inertia of a short step is stiffer than any solid; a penalty raised to it would stay for the long steps after.
  const auto raised = [](double dt) {
    Pushed pushed;
    const Inertia inertia(GeneralizedAlpha::from(0.8), dt > 0 ? dt : 1.0, pushed.state);
    StepTerms terms{pushed.load(1e5, 0)};
    if (dt > 0) terms.inertia = &inertia;
    pushed.system->prepare(pushed.state, terms);
    EXPECT_TRUE(pushed.system->evaluate(pushed.state.u, true));
    int times = 0;
    while (times < 50 && pushed.system->stiffen(4)) ++times;
    return times;
  };
  const int at_rest = raised(0);
  EXPECT_GT(at_rest, 0);
  EXPECT_EQ(raised(1e-8), at_rest);
}

TEST(Pitfall, WhereAugmentationIsBrokenOffTheNextStepStartsInEquilibrium) {
  // Multipliers augmented once more than the forces were balanced with would apply_velocity_jump the bodies, hardest in
  // a short step.
  Block block(FrictionCoefficient::constant(0));
  SystemState state = block.system->at_rest();
  StepOptions options;
  options.max_augmentations = 1;
  options.gap_tolerance = options.slip_tolerance = 1e-15;
  const auto step = static_step(*block.system, state, block.drive(0, 1e-3, 1e-3), options);
  ASSERT_TRUE(step.converged) << step.reason;
  ASSERT_TRUE(step.capped);
  ASSERT_GT(step.gap_left, 1e-6);
  const double before = state.reports[0].force.z();
  const StepTerms same = block.drive(0, 1e-3, 1e-3);
  block.system->prepare(state, same);
  ASSERT_TRUE(block.system->evaluate(state.u, true));
  EXPECT_LT(block.system->residual().norm(), 1e-7 * before);
}

TEST(Pitfall, NoNodeOfAQuadraticFacePullsUnderPressure) {
  // The 20-node brick's corners get a negative share of a uniform pressure; 27 nodes have 1/36, 1/9 and 4/9.
  Pushed pushed;
  const Eigen::VectorXd load = pushed.load(1e5, 0);
  for (const unsigned node : pushed.space.nodes_of(Surface::top))
    EXPECT_LT(load[pushed.system->equations().of_dof[3 * node + 2]], 0);
}

/// Walls that part for an instant, a slider that still comes on: passed is a rim that has been pushed by some of its
/// own size, whatever that is. Nearer than that the contact chatters, and no rim has been passed.
TEST(Pitfall, ARimIsPassedOnlyAtADepthOfItsOwnSize) {
  const auto said = [](double thickness, double height, double depth, bool window = true) {
    const Passage passage{
        .depth = depth, .outward_speed = 0.015, .approach_speed = 0.02, .let_go = true, .may_touch = !window};
    return passes({.height = height, .thickness = thickness, .ledge = 0}, passage, 0.01).value_or("");
  };
  for (const double thickness : {1e-4, 1e-3, 0.035, 0.1})
    for (const double height : {0.005, 0.045}) {
      const double size = std::min(thickness, height);
      const std::string hardly = said(thickness, height, 0.004 * size), deep = said(thickness, height, 0.5 * size);
      EXPECT_NE(hardly.find("the contact chatters"), std::string::npos) << hardly;
      EXPECT_EQ(hardly.find("passes"), std::string::npos) << hardly;
      EXPECT_NE(deep.find("passes through or over the rim"), std::string::npos) << deep;
    }
  EXPECT_NE(said(0.035, 0.045, 1.6e-4).find("the contact chatters"), std::string::npos); // as a draft mesh had it
  EXPECT_TRUE(said(0.035, 0.045, 5e-5, false).empty());                                  // a pulse: touched again
}

} // namespace
} // namespace rimpact::fe
