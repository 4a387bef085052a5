#include "buildings/mount.h"
#include "files/error.h"
#include "reduced_models/dynamics.h"
#include <algorithm>

namespace rimpact::buildings {
namespace {

using Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;
using reduced::RimContact;

class DishMount : public Mount {
public:
  explicit DishMount(const scene::Scene &scene)
      : law_(scene), weight_(scene.load.vertical), stiffness_(scene.isolator.contact_stiffness * scene.isolator.points),
        damping_(2 * laws::damping_ratio(scene.isolator.contact_restitution) *
                 std::sqrt(stiffness_ * scene.load.mass)) {
    if (law_.socket > 0)
      throw InputError("reduced.socket_friction under a building with bearings of rigid bodies: a dish there has none; "
                       "--set reduced.socket_friction=false leaves it out");
    if (scene.reduced.friction != scene::Friction::park_wen)
      throw InputError("reduced.friction \"coulomb\" of a dish under a building, which takes \"park-wen\"");
    if (law_.has_rim() && law_.rim.law->yields)
      throw InputError("reduced.impact_law \"" + scene.reduced.impact_law->name +
                       "\": beside bearings of rigid bodies a dish's rim does not yield");
    lateral_capacity = law_.lateral_capacity, rim_stiffness = law_.rim.stiffness;
    sunk_ = weight_ / stiffness_;
  }

  double height(const Vector2d &u) const override { return law_.height.at(u[0], u[1]).z; }

  void start(double t, const NodeMotion &node, const Vector3d &) override { at_[0].evaluate(*this, node, t, 0, 0); }

  void begin_stage(const Stage &stage) override {
    stage_ = stage;
    State &to = current();
    to.z0 = at_[0].z + stage.w1 * at_[0].z_rate;
    if (stage.last()) to.z0 += stage.w2 * at_[1].z_rate;
  }
  MountForce linearise(const NodeMotion &node) override {
    MountForce m{Vector6::Zero(), Matrix6::Zero()};
    m.tangent.topLeftCorner<3, 3>() = current().evaluate(*this, node, stage_.t, stage_.own, stage_.own);
    m.force.head<3>() = current().force();
    return m;
  }
  double correct(const Vector6 &) override { return 0; }
  void end_stage() override {
    State &to = current();
    to.z_rate = (to.z - to.z0) / stage_.own;
  }
  double error(double) const override { return 0; }
  void accept() override { std::swap(at_[0], at_[2]); }
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
  MountPower power(int stage) const override {
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
    r.pendular = s.pendular, r.friction = s.friction, r.impact = s.impact, r.rim_force = s.impact.head<2>().norm();
    r.gap = law_.lateral_capacity - s.u.head<2>().norm();
    return r;
  }

private:
  struct State {
    Vector3d u = Vector3d::Zero(), v = Vector3d::Zero();
    Vector3d z = Vector3d::Zero(), z0 = Vector3d::Zero(), z_rate = Vector3d::Zero(); ///< of friction
    Vector3d pendular = Vector3d::Zero(), friction = Vector3d::Zero(), impact = Vector3d::Zero();
    double normal = 0, penetration = 0;
    Vector3d force() const { return pendular + friction + impact; }

    /// Forces at the node's motion, and their derivative by its velocity; `weight` of positions, `slip_step` of z.
    Matrix3d evaluate(const DishMount &m, const NodeMotion &node, double t, double weight, double slip_step) {
      u = node.u.head<3>(), v = node.v.head<3>();
      pendular = friction = impact = Vector3d::Zero(), normal = 0, z = slip_step > 0 ? z0 : z;
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
        rub(m, n, slip_step, B);
      }
      if (m.met_) press(m, t, weight, B);
      return B;
    }
    void rub(const DishMount &m, const Vector3d &n, double slip_step, Matrix3d &B) {
      const Matrix3d along = Matrix3d::Identity() - n * n.transpose();
      const Vector3d slide = along * v;
      const double speed = slide.norm();
      const auto mu = m.law_.friction_law.at(speed);
      Matrix3d d_velocity = Matrix3d::Zero();
      if (slip_step > 0) {
        const auto state = reduced::rigid::park_wen_step(along * z0, slide, slip_step / m.law_.elastic_slip);
        z = state.z, d_velocity = state.d_velocity;
      }
      friction = -mu.value * normal * z;
      const Eigen::RowVector3d d_normal = n.transpose() * B;
      B -= mu.value * z * d_normal + mu.value * normal * d_velocity * along;
      if (speed > 0 && mu.slope != 0) B -= normal * mu.slope / speed * z * slide.transpose();
    }
    void press(const DishMount &m, double t, double weight, Matrix3d &B) {
      const Vector2d at = u.head<2>(), speed = v.head<2>();
      const double travel = at.norm(), d = travel - m.law_.lateral_capacity;
      if (!(d > 0)) return;
      const auto push = m.law_.rim_push(m.mode_, t, at, speed);
      impact.head<2>() = -push.inwards / travel * at + push.along / travel * Vector2d(-at.y(), at.x());
      if (push.inwards == 0) return;
      const Vector2d e = at / travel;
      const auto slopes = m.law_.rim.at({d, speed.dot(e), speed.norm(), 0});
      B.topLeftCorner<2, 2>() -= (weight * slopes.d_penetration + slopes.d_rate) * e * e.transpose() +
                                 weight * push.inwards / travel * (Eigen::Matrix2d::Identity() - e * e.transpose());
    }
  };

  State &current() { return at_[stage_.last() ? 2 : 1]; }
  RimContact rim_state() const { return met_ ? RimContact::pressed : RimContact::open; }

  reduced::Dynamics law_;
  double weight_, stiffness_, damping_, sunk_;
  bool met_ = false;
  reduced::Mode mode_;
  State at_[3]; ///< start, middle, end of a step
  Stage stage_{};
};

} // namespace

std::unique_ptr<Mount> dish_mount(const scene::Scene &scene) {
  return std::make_unique<DishMount>(scene);
}

} // namespace rimpact::buildings
