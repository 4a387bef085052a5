#include "buildings/dish_element.h"
#include "reduced_models/bearings/dynamics.h"
#include <algorithm>

namespace rimpact::buildings {
namespace {

using Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;
using reduced::RimContact;

/// The socket's friction over that of a unit arm and coefficient (Dynamics::friction_per_normal), by the sliding face's
/// state z in place of its direction: |z| K^2 z / |K z|, K the curvatures along meridian and circle [1/m].
struct SocketShare {
  Vector3d value;
  Matrix3d d_state;
};
SocketShare socket_share(const scene::Curvatures &k, const reduced::TangentFrame &frame, const Vector3d &z) {
  const Matrix3d K = k.meridional * frame.meridian * frame.meridian.transpose() +
                     k.circumferential * frame.circle * frame.circle.transpose();
  const Vector3d turn = K * z;
  const double size = z.norm(), rate = turn.norm();
  if (!(rate > 0)) return {Vector3d::Zero(), K};
  const Vector3d along = K * turn / rate;
  return {size * along, along * z.transpose() / size + size / rate * (K * K - along * along.transpose())};
}

class DishElement : public BearingElement {
public:
  explicit DishElement(const scene::Scene &scene)
      : law_(scene), weight_(scene.load.vertical), stiffness_(scene.isolator.contact_stiffness * scene.isolator.points),
        damping_(2 * laws::damping_ratio(scene.isolator.contact_restitution) *
                 std::sqrt(stiffness_ * scene.load.mass)) {
    lateral_capacity = law_.lateral_capacity, rim_stiffness = law_.rim.stiffness;
    sunk_ = weight_ / stiffness_;
    temperature_ = law_.heat.at_start();
  }

  double height(const Vector2d &u) const override { return law_.height.at(u[0], u[1]).z; }

  void start(double t, const NodeMotion &node, const Vector3d &) override { at_[0].evaluate(*this, node, t, 0, 0); }

  void begin_stage(const Stage &stage) override {
    stage_ = stage;
    slip_step_ = law_.park_wen() ? stage.own : stage.reach;
    current().z0 = law_.park_wen() ? reduced::tr_bdf2::base(stage, at_[0].z, at_[0].z_rate, at_[1].z_rate) : at_[0].z;
  }
  ElementForce linearise(const NodeMotion &node, bool) override {
    ElementForce m{Vector6::Zero(), Matrix6::Zero()};
    m.tangent.topLeftCorner<3, 3>() = current().evaluate(*this, node, stage_.t, stage_.own, slip_step_);
    m.force.head<3>() = current().force();
    return m;
  }
  double correct(const Vector6 &) override { return 0; }
  void end_stage() override {
    State &to = current();
    to.z_rate = (to.z - to.z0) / slip_step_;
  }
  double error(double) const override { return 0; }
  void begin_step(double t, const Vector6 &acceleration) override {
    reduced::State rates;
    rates[reduced::iVX] = acceleration[0], rates[reduced::iVY] = acceleration[1];
    law_.begin_step(mode_, t, at_[0].of_law(), rates);
  }
  void accept() override {
    std::swap(at_[0], at_[2]);
    law_.arrive(mode_, stage_.t, at_[0].of_law());
    if (!law_.heats()) return;
    const friction::FrictionLaw &law = law_.friction_law;
    const bool covered = friction::passes_over(law.face_share * at_[0].u.head<2>().norm(), law_.contact_radius);
    const double flux = covered ? std::max(0.0, at_[0].face_power) / (law.faces * law.area) : 0.0;
    heat_ = law_.heat.after(heat_, flux, stage_.t - heated_until_);
    heated_until_ = stage_.t, temperature_ = law_.heat.temperature(heat_.data());
  }
  double wall(int stage) const override {
    if (!law_.has_rim()) return 1e300;
    const double d = at_[stage].u.head<2>().norm() - law_.lateral_capacity;
    return met_ ? d : -d;
  }
  bool change_walls() override {
    if (wall(0) > 0) return false;
    met_ = !met_, mode_.rim = rim_state();
    return true;
  }
  bool at_wall() const override { return met_; }
  ElementPower power(int stage) const override {
    const State &s = at_[stage];
    return {0, -s.friction.dot(s.v), -s.impact.dot(s.v), -s.pendular.dot(s.v)};
  }
  Vector6 force() const override {
    Vector6 f = Vector6::Zero();
    f.head<3>() = at_[0].force();
    return f;
  }
  double kinetic_energy() const override { return 0; }
  double potential_energy() const override { return 0; }
  const char *lost() const override {
    if (met_ && at_[0].u[2] > law_.lift_over_rim) return "the slider is thrown over its rim";
    return at_[0].u.head<2>().norm() < 0.98 * law_.height.limit_radius() ? nullptr : "the slider left its dish";
  }
  BearingResponse response() const override {
    const State &s = at_[0];
    BearingResponse r;
    r.u = s.u, r.v = s.v, r.height = s.u[2] - std::max(0.0, -s.penetration), r.normal = s.normal;
    r.pendular = s.pendular, r.friction = s.friction, r.impact = s.impact, r.rim_force = s.rim_force;
    r.gap = law_.lateral_capacity - s.u.head<2>().norm();
    return r;
  }

private:
  struct State {
    Vector3d u = Vector3d::Zero(), v = Vector3d::Zero();
    Vector3d z = Vector3d::Zero(), z0 = Vector3d::Zero(), z_rate = Vector3d::Zero(); ///< of friction
    Vector3d pendular = Vector3d::Zero(), friction = Vector3d::Zero(), impact = Vector3d::Zero();
    double normal = 0, penetration = 0, rim_force = 0;
    double face_power = 0; ///< taken by the sliding face [W]
    Vector3d force() const { return pendular + friction + impact; }
    reduced::State of_law() const {
      reduced::State y;
      for (int c = 0; c < 3; ++c) y[reduced::iX + c] = u[c], y[reduced::iVX + c] = v[c];
      return y;
    }

    /// Forces at the node's motion, and their derivative by its velocity; `weight` of positions, `slip_step` of z.
    Matrix3d evaluate(const DishElement &m, const NodeMotion &node, double t, double weight, double slip_step) {
      u = node.u.head<3>(), v = node.v.head<3>();
      pendular = friction = impact = Vector3d::Zero(), normal = rim_force = face_power = 0, z = slip_step > 0 ? z0 : z;
      Matrix3d B = Matrix3d::Zero();
      if (!(u.head<2>().norm() < m.law_.height.limit_radius())) {
        pendular.setConstant(std::nan("")); // beyond the dish: inadmissible, the step is cut
        return B;
      }
      const auto p = m.law_.height.at(u[0], u[1]);
      const double S = std::sqrt(1 + p.gradient.squaredNorm());
      const Vector3d n = Vector3d(-p.gradient[0], -p.gradient[1], 1) / S;
      penetration = (p.z - u[2]) / S + m.sunk_; // the node at rest stands at 0 and carries its weight
      const double trial = m.stiffness_ * penetration - m.damping_ * n.dot(v);
      if (penetration > 0 && trial > 0) {
        normal = trial, pendular = normal * n;
        const Matrix3d across = n * n.transpose();
        B = -(m.damping_ + weight * m.stiffness_) * across;
        Matrix3d turn = Matrix3d::Zero(); // of the normal, to first order in the slope's change
        turn.topLeftCorner<2, 2>() = p.hessian / S;
        B -= weight * normal * (Matrix3d::Identity() - across) * turn;
        rub(m, p, n, slip_step, B);
      }
      if (m.met_) press(m, t, weight, B);
      return B;
    }
    void rub(const DishElement &m, const scene::SurfacePoint &p, const Vector3d &n, double slip_step, Matrix3d &B) {
      const Matrix3d along = Matrix3d::Identity() - n * n.transpose();
      const Vector3d slide = along * v;
      const double speed = slide.norm();
      const auto mu = m.law_.friction_law.under(normal, speed, m.temperature_);
      Matrix3d d_velocity = Matrix3d::Zero();
      if (slip_step > 0) {
        const auto state =
            m.law_.park_wen()
                ? reduced::rigid::park_wen_step(along * z0, slide, slip_step / m.law_.elastic_slip)
                : reduced::rigid::coulomb_step(along * z0, slide, slip_step / reduced::rigid::coulomb_slip);
        z = state.z, d_velocity = state.d_velocity;
      }
      face_power = mu.value * normal * z.dot(slide);
      Vector3d share = mu.value * z; // of the normal force
      Matrix3d d_state = mu.value * Matrix3d::Identity();
      if (m.law_.socket > 0) {
        const auto turning = socket_share(m.law_.height.curvatures(u.head<2>().norm()), {p, u.head<2>()}, z);
        share += m.law_.socket * turning.value, d_state += m.law_.socket * turning.d_state;
      }
      friction = -normal * share;
      const Eigen::RowVector3d d_normal = n.transpose() * B;
      const double by_pressure = m.law_.friction_law.d_force(mu, normal) - mu.value;
      B -= (share + by_pressure * z) * d_normal + normal * d_state * d_velocity * along;
      if (speed > 0 && mu.d_speed != 0) B -= normal * mu.d_speed / speed * z * slide.transpose();
    }
    void press(const DishElement &m, double t, double weight, Matrix3d &B) {
      const Vector2d at = u.head<2>(), speed = v.head<2>();
      const double travel = at.norm(), d = travel - m.law_.lateral_capacity;
      if (!(d > 0)) return;
      const auto push = m.law_.rim_push(m.mode_, t, at, speed);
      impact.head<2>() = on_slider(push, at), rim_force = push.inwards;
      if (push.inwards == 0) return;
      if (m.law_.rim.law->yields) {
        B.topLeftCorner<2, 2>() += m.by_differences(t, at, speed, weight);
        return;
      }
      const Vector2d e = at / travel;
      const auto slopes = m.law_.rim.at({d, speed.dot(e), speed.norm(), 0});
      B.topLeftCorner<2, 2>() -= (weight * slopes.d_penetration + slopes.d_rate) * e * e.transpose() +
                                 weight * push.inwards / travel * (Eigen::Matrix2d::Identity() - e * e.transpose());
    }
  };

  static Vector2d on_slider(const reduced::RimPush &push, const Vector2d &at) {
    return (-push.inwards * at + push.along * Vector2d(-at.y(), at.x())) / at.norm();
  }
  /// Of a rim that yields, by the velocity, positions following with `weight`: a mean over the touch of what the path
  /// has left has no derivative in closed form.
  Eigen::Matrix2d by_differences(double t, const Vector2d &u, const Vector2d &v, double weight) const {
    constexpr double apart = 1e-6; // [m/s]
    const auto force = [&](const Vector2d &change) {
      const Vector2d at = u + weight * change;
      return on_slider(law_.rim_push(mode_, t, at, v + change), at);
    };
    const Vector2d here = force(Vector2d::Zero());
    Eigen::Matrix2d slope;
    for (int c = 0; c < 2; ++c) slope.col(c) = (force(apart * Vector2d::Unit(c)) - here) / apart;
    return slope;
  }
  State &current() { return at_[stage_.last ? 2 : 1]; }
  RimContact rim_state() const { return met_ ? RimContact::pressed : RimContact::open; }

  reduced::Dynamics law_;
  double weight_, stiffness_, damping_, sunk_, slip_step_ = 0;
  friction::HeatModes heat_{};
  double heated_until_ = 0, temperature_; ///< of the last step's end: held through the next
  bool met_ = false;
  reduced::Mode mode_;
  State at_[3]; ///< start, middle, end of a step
  Stage stage_{};
};

} // namespace

std::unique_ptr<BearingElement> dish_element(const scene::Scene &scene) {
  return std::make_unique<DishElement>(scene);
}

} // namespace rimpact::buildings
