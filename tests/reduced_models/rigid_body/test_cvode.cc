// The rigid-body stepper against SUNDIALS CVODE: the same forces as one plain differential equation (Park-Wen
// friction, Bouc-Wen storey), other integrator, no analytic tangent, no implicit stages of the states.
#include "reduced_models/motion/sundials.h"
#include "reduced_models/rigid_body/rigid_bearing.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <algorithm>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

using namespace rigid;
using Eigen::Vector2d, Eigen::Vector3d;

/// Motion in the plane y = 0: x, z, angle about y and their rates of each body, then the friction states,
/// then the storeys'.
class PlanarEquations {
public:
  explicit PlanarEquations(const scene::Scene &scene)
      : model_(scene), ground_(scene.excitation, scene.load.gravity), n_bodies_(model_.system.bodies.size()),
        n_contacts_(model_.system.contacts.size()), n_links_(model_.system.links.size()) {}
  int size() const { return static_cast<int>(6 * n_bodies_ + 3 * n_contacts_ + n_links_); }

  void start(double *y) const {
    const MotionState s = model_.state_at({0, 0}, {0, 0});
    std::fill_n(y, size(), 0.0);
    for (std::size_t b = 0; b < n_bodies_; ++b)
      y[6 * b] = s.poses[b].position[0], y[6 * b + 1] = s.poses[b].position[2];
  }
  /// Fills dy; returns the largest lateral force on the plate's side and its displacement by the way.
  void rates(double t, const double *y, double *dy) {
    const System &system = model_.system;
    Poses poses;
    Vector velocity = Vector::Zero(system.n_dofs());
    for (std::size_t b = 0; b < n_bodies_; ++b) {
      const double *q = y + 6 * b;
      poses[b].position = {q[0], 0, q[1]};
      poses[b].rotation = Eigen::AngleAxisd(q[2], Vector3d::UnitY()).toRotationMatrix();
      velocity[6 * b] = q[3], velocity[6 * b + 2] = q[4], velocity[6 * b + 4] = q[5];
    }
    std::vector<Vector3d> slip(n_contacts_);
    const double *z = y + 6 * n_bodies_;
    for (std::size_t i = 0; i < n_contacts_; ++i) slip[i] = Vector3d(z[3 * i], z[3 * i + 1], z[3 * i + 2]);
    std::vector<Vector2d> storey(n_links_);
    for (std::size_t i = 0; i < n_links_; ++i) storey[i] = Vector2d(z[3 * n_contacts_ + i], 0);
    Vector f = system.forces(poses, velocity, {0, 0, slip}, contact_, nullptr);
    add_links(system, poses, velocity, {0, 0, storey}, link_, f, nullptr);
    const double a = ground_.acceleration(t)[0];
    for (std::size_t b = 0; b < n_bodies_; ++b) {
      const auto &body = system.bodies[b];
      const auto free = [&](int dof) { return system.free[6 * b + dof]; };
      double *d = dy + 6 * b;
      d[0] = y[6 * b + 3], d[1] = y[6 * b + 4], d[2] = y[6 * b + 5];
      d[3] = free(0) ? f[6 * b] / body.mass - a : 0;
      d[4] = free(2) ? f[6 * b + 2] / body.mass : 0;
      d[5] = free(4) ? f[6 * b + 4] / body.inertia[1] : 0;
    }
    double *dz = dy + 6 * n_bodies_;
    for (std::size_t i = 0; i < n_contacts_; ++i) {
      const Contact &c = system.contacts[i];
      Vector3d rate = Vector3d::Zero();
      if (contact_[i].size > 0 && (c.surface == Surface::dish || c.surface == Surface::interface)) {
        const auto velocity_of = [&](int body) -> Vector3d {
          if (body == ground) return Vector3d::Zero();
          const Vector3d omega = velocity.segment<3>(6 * body + 3);
          return velocity.segment<3>(6 * body) + omega.cross(contact_[i].at - poses[body].position);
        };
        const Vector3d n = contact_[i].normal.normalized(), v = velocity_of(c.body) - velocity_of(c.master);
        const Vector3d slide = v - n * n.dot(v), state = slip[i] - n * n.dot(slip[i]);
        rate = (slide - state * std::max(0.0, state.dot(slide))) / system.elastic_slip;
      }
      for (int k = 0; k < 3; ++k) dz[3 * i + k] = rate[k];
    }
    for (std::size_t i = 0; i < n_links_; ++i) {
      const auto &l = system.links[i];
      dz[3 * n_contacts_ + i] =
          l.storey.hysteresis
              ? l.storey.hysteresis->rate(storey[i], {velocity[6 * l.above] - velocity[6 * l.below], 0})[0]
              : 0;
    }
  }
  double displacement(const double *y) const { return y[6 * model_.plate]; }
  double drift(const double *y) const { return n_links_ ? y[6 * (model_.plate + 1)] - y[6 * model_.plate] : 0; }
  /// On the plate, after `rates`.
  double force() const {
    double sum = 0;
    for (std::size_t i = 0; i < n_contacts_; ++i)
      if (model_.system.contacts[i].master == model_.plate) sum -= (contact_[i].normal + contact_[i].friction)[0];
    return sum;
  }

private:
  RigidBearing model_;
  scene::GroundMotion ground_;
  std::size_t n_bodies_, n_contacts_, n_links_;
  std::vector<ContactForce> contact_;
  std::vector<LinkForce> link_;
};

struct Peaks {
  double displacement = 0, force = 0, drift = 0;
};

Peaks by_cvode(const scene::Scene &scene) {
  PlanarEquations equations(scene);
  SUNContext context = sundials_context();
  const int n = equations.size();
  N_Vector y = N_VNew_Serial(n, context), dy = N_VNew_Serial(n, context);
  equations.start(N_VGetArrayPointer(y));
  SUNMatrix matrix = SUNDenseMatrix(n, n, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  void *memory = CVodeCreate(CV_BDF, context);
  const auto rhs = [](double t, N_Vector at, N_Vector rates, void *self) {
    static_cast<PlanarEquations *>(self)->rates(t, N_VGetArrayPointer(at), N_VGetArrayPointer(rates));
    return 0;
  };
  EXPECT_EQ(CVodeInit(memory, rhs, 0, y), 0);
  CVodeSetUserData(memory, &equations);
  CVodeSStolerances(memory, 1e-7, 1e-10);
  CVodeSetLinearSolver(memory, solver, matrix);
  CVodeSetMaxNumSteps(memory, 10'000'000);
  CVodeSetMaxStep(memory, 2e-3);
  Peaks peaks;
  double t = 0;
  while (t < scene.excitation.duration) {
    const int flag = CVode(memory, scene.excitation.duration, y, &t, CV_ONE_STEP);
    if (flag < 0) {
      ADD_FAILURE() << "CVODE gave up at t = " << t << " with " << flag;
      break;
    }
    equations.rates(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
    peaks.displacement = std::max(peaks.displacement, std::abs(equations.displacement(N_VGetArrayPointer(y))));
    peaks.force = std::max(peaks.force, std::abs(equations.force()));
    peaks.drift = std::max(peaks.drift, std::abs(equations.drift(N_VGetArrayPointer(y))));
  }
  CVodeFree(&memory);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(y), N_VDestroy(dy);
  SUNContext_Free(&context);
  return peaks;
}

scene::Scene struck(scene::ModelKind model) {
  scene::Scene s;
  s.reduced.model = model;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.05;
  s.reduced.friction = scene::Friction::park_wen, s.reduced.elastic_slip = 5e-4;
  s.reduced.impact_law = &laws::impact_law("hunt-crossley"), s.reduced.impact_exponent = 1;
  s.reduced.k_i = 4e7;
  s.load.mass = 2e5, s.load.vertical = s.load.mass * s.load.gravity;
  s.isolator.step_tolerance = 1e-6;
  s.excitation.amplitude_g = 0.5, s.excitation.period = 1.5, s.excitation.centre = 2, s.excitation.duration = 4;
  return s;
}

void expect_same(const scene::Scene &scene) {
  const auto own = simulate(scene);
  const Peaks other = by_cvode(scene);
  ASSERT_EQ(own.summary.status, RunStatus::done) << own.summary.reason;
  EXPECT_GE(own.summary.impacts.size(), 1u);
  EXPECT_NEAR(own.summary.peak_displacement / other.displacement, 1, 1e-4);
  EXPECT_NEAR(own.summary.peak_lateral_force / other.force, 1, 1e-3);
  if (scene.superstructure.any()) {
    EXPECT_NEAR(own.summary.extra["peak_drift_m"].get<double>() / other.drift, 1, 1e-3);
  }
}

TEST(RigidBodyCvode, DoubleConcave) {
  expect_same(struck(scene::ModelKind::dcfp));
}
TEST(RigidBodyCvode, ImpactResilient) {
  expect_same(struck(scene::ModelKind::lir_dcfp));
}
TEST(RigidBodyCvode, WithAnInelasticFrame) {
  auto scene = struck(scene::ModelKind::lir_dcfp);
  scene.superstructure.kind = scene::StructureKind::bouc_wen, scene.superstructure.mass_ratio = 0.7;
  expect_same(scene);
}

} // namespace
} // namespace rimpact::reduced::testing
