#include "plain_cvode.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/motion/sundials.h"
#include <cmath>
#include <Eigen/LU>
#include <stdexcept>

namespace rimpact::buildings {
namespace {

using Eigen::MatrixXd, Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;

class PlainEquations {
public:
  PlainEquations(const BuildingModel &model, const scene::Scene &scene)
      : m_(model), ground_(scene.excitation, scene.load.gravity), g_(scene.load.gravity), mu_(scene.reduced.mu_fast),
        slip_(scene.reduced.elastic_slip), R0_(scene.bearing.surface.R0), a_(scene.bearing.surface.a),
        capacity_(scene.bearing.lateral_capacity()), n_(model.n_dofs()) {
    const auto &r = scene.reduced;
    if (r.impact_law != &laws::impact_law("hunt-crossley") || r.mu_fast != r.mu_slow ||
        scene.bearing.surface.kind != scene::SurfaceKind::ellipse)
      throw std::logic_error("the plain equations know Hunt-Crossley, one friction and ellipses");
    chi_ = laws::hunt_crossley_dissipation(r.restitution, r.reference_speed), exponent_ = r.impact_exponent;
    K_ = r.k_i * std::pow(1e-3, 1 - exponent_);
    for (const auto &W : m_.slider) W_.push_back(W);
  }
  int size() const { return 2 * n_ + 2 * n_bearings(); }
  int n_bearings() const { return static_cast<int>(W_.size()); }

  bool rates(double t, const double *y, double *dy) {
    const Eigen::Map<const VectorXd> q(y, n_), v(y + n_, n_);
    const int B = n_bearings();
    VectorXd F = -(m_.stiffness * q) - m_.damping * v;
    const Vector3d ag = ground_.acceleration(t);
    for (int d = 0; d < m_.n_diaphragms; ++d) F.segment<2>(3 * d) -= m_.mass[3 * d] * ag.head<2>();
    F.tail(m_.n_nodes) -= (g_ + ag[2]) * m_.mass.tail(m_.n_nodes);
    MatrixXd G(B, n_), P(n_, B); // constraint's rows; generalised force a unit of N
    VectorXd target(B);
    rim_force = 0, travel = 0;
    Vector2d horizontal = Vector2d::Zero();
    std::vector<Vector3d> unit(B);
    for (int b = 0; b < B; ++b) {
      const Vector3d x = W_[b] * q, w = W_[b] * v;
      const Vector2d u = x.head<2>(), s = w.head<2>();
      const double r2 = u.squaredNorm(), r = std::sqrt(r2), c = std::sqrt(1 - r2 / (a_ * a_));
      if (!(r2 < a_ * a_)) return false;
      const double height = a_ * a_ / R0_ * (1 - c);
      const Vector2d slope = u / (R0_ * c);
      const double bend = s.squaredNorm() / (R0_ * c) + std::pow(u.dot(s), 2) / (R0_ * a_ * a_ * c * c * c);
      const Eigen::Map<const Vector2d> eta(y + 2 * n_ + 2 * b);
      Eigen::Map<Vector2d> rate(dy + 2 * n_ + 2 * b);
      rate = (s - std::max(0.0, eta.dot(s)) * eta) / slip_;
      const Vector3d normal = Vector3d(-slope[0], -slope[1], 1) / std::sqrt(1 + slope.squaredNorm());
      const Vector3d along(eta[0], eta[1], slope.dot(eta));
      unit[b] = normal;
      if (along.norm() > 0) unit[b] -= mu_ * eta.norm() / along.norm() * along;
      P.col(b) = W_[b].transpose() * unit[b];
      G.row(b) = W_[b].row(2) - slope.transpose() * W_[b].topRows(2);
      const double off = x[2] - height, off_rate = w[2] - slope.dot(s);
      target[b] = bend - 200 * off_rate - 1e4 * off; // the last two vanish on the dish: they hold it there
      travel = std::max(travel, r);
      const double d = r - capacity_;
      if (d > 0) {
        const double push = std::max(0.0, K_ * std::pow(d, exponent_) * (1 + chi_ * u.dot(s) / r));
        const Vector3d force(-push * u[0] / r, -push * u[1] / r, 0);
        F += W_[b].transpose() * force, horizontal += force.head<2>();
        rim_force = std::max(rim_force, push);
      }
    }
    const MatrixXd over = m_.mass.cwiseInverse().asDiagonal() * P;
    const VectorXd free = F.cwiseQuotient(m_.mass), N = (G * over).partialPivLu().solve(VectorXd(target - G * free));
    for (int b = 0; b < B; ++b) horizontal += N[b] * unit[b].head<2>();
    base_shear = horizontal.norm(), smallest_normal = N.minCoeff();
    Eigen::Map<VectorXd>(dy, n_) = v;
    Eigen::Map<VectorXd>(dy + n_, n_) = free + over * N;
    return true;
  }

  double rim_force = 0, travel = 0, base_shear = 0, smallest_normal = 0; ///< of the last call
private:
  const BuildingModel &m_;
  scene::GroundMotion ground_;
  double g_, mu_, slip_, R0_, a_, capacity_, K_ = 0, chi_ = 0, exponent_ = 1.5;
  int n_;
  std::vector<MatrixXd> W_;
};

int rhs(double t, N_Vector y, N_Vector dy, void *self) {
  return static_cast<PlainEquations *>(self)->rates(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy)) ? 0 : 1;
}

} // namespace

PlainAnswer plain_cvode(const BuildingModel &model, const scene::Scene &scene, double tolerance) {
  PlainEquations equations(model, scene);
  const int size = equations.size(), n = model.n_dofs();
  SUNContext context = reduced::sundials_context();
  N_Vector y = N_VNew_Serial(size, context), scale = N_VNew_Serial(size, context), dy = N_VNew_Serial(size, context);
  N_VConst(0, y);
  const VectorXd start = static_displacements(model, scene.load.gravity);
  for (int i = 0; i < size; ++i)
    NV_Ith_S(scale, i) = tolerance * (i < n ? 0.4 : i < 2 * n ? 2.0 : 1.0), NV_Ith_S(y, i) = i < n ? start[i] : 0;
  SUNMatrix matrix = SUNDenseMatrix(size, size, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  void *memory = CVodeCreate(CV_BDF, context);
  CVodeInit(memory, rhs, 0, y);
  CVodeSetUserData(memory, &equations);
  CVodeSVtolerances(memory, tolerance, scale);
  CVodeSetLinearSolver(memory, solver, matrix);
  CVodeSetMaxNumSteps(memory, 10'000'000);
  CVodeSetMaxStep(memory, 0.02);
  CVodeSetStopTime(memory, scene.excitation.duration);
  PlainAnswer answer;
  double t = 0;
  while (t < scene.excitation.duration) {
    if (CVode(memory, scene.excitation.duration, y, &t, CV_ONE_STEP) < 0)
      throw std::runtime_error("CVODE gave up on the plain equations");
    ++answer.n_steps;
    equations.rates(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
    answer.travel = std::max(answer.travel, equations.travel);
    answer.base_shear = std::max(answer.base_shear, equations.base_shear);
    answer.rim_force = std::max(answer.rim_force, equations.rim_force);
    answer.smallest_normal = std::min(answer.smallest_normal, equations.smallest_normal);
    const double *q = N_VGetArrayPointer(y);
    if (model.n_diaphragms > 1) answer.drift = std::max(answer.drift, std::hypot(q[3] - q[0], q[4] - q[1]));
  }
  answer.final = Eigen::Map<VectorXd>(N_VGetArrayPointer(y), n);
  CVodeFree(&memory);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  for (N_Vector v : {y, scale, dy}) N_VDestroy(v);
  SUNContext_Free(&context);
  return answer;
}

} // namespace rimpact::buildings
