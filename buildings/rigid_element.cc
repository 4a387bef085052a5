#include "buildings/rigid_element.h"
#include "io/files/error.h"
#include "reduced_models/rigid_body/heat_memory.h"
#include "reduced_models/rigid_body/rigid_bearing.h"
#include "reduced_models/rigid_body/wall_memory.h"
#include <algorithm>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace rimpact::buildings {
namespace {

using namespace reduced::rigid;
using Eigen::Vector2d, Eigen::Vector3d;
constexpr int most_own = 6 * (max_sets - 1); // dofs of the sliders
using OwnMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_own, most_own>;
using OwnVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_own, 1>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, most_own, 6>;

class RigidElement : public BearingElement {
public:
  explicit RigidElement(const scene::Scene &scene)
      : model_(scene), n_(6 * model_.plate), heat_(scene, model_.parts, model_.system) {
    if (scene.isolator.space != scene::Space::spatial)
      throw InputError(
          "isolator.space \"planar\" under a building, which moves in space: isolator.space = \"spatial\", "
          "with isolator.points = 4 or more");
    auto &s = model_.system;
    at_[0] = model_.state_at({0, 0}, {0, 0});
    rest_ = at_[0].poses[model_.plate].position;
    rest_height_ = model_.plate_displacement(at_[0])[2];
    auto &plate = s.bodies[model_.plate]; // the node has its mass and weight
    plate.mass = plate.weight = 0, plate.inertia.setZero();
    potential_ = model_.potential_energy(at_[0]);
    s.unmet.assign(s.contacts.size(), false);
    for (std::size_t i = 0; i < s.contacts.size(); ++i) {
      s.unmet[i] = is_wall(s.contacts[i].surface);
      if (s.unmet[i]) walls_.push_back(i);
    }
    lateral_capacity = scene.lateral_capacity(), rim_stiffness = model_.parts.stop_stiffness;
    for (auto &state : at_) state.slip.assign(s.contacts.size(), Vector3d::Zero()), state.slip_rate = state.slip;
  }

  double height(const Vector2d &u) const override {
    return model_.state_at(u, {0, 0}).poses[model_.plate].position[2] -
           model_.state_at({0, 0}, {0, 0}).poses[model_.plate].position[2];
  }

  void start(double t, const NodeMotion &node, const Vector3d &ground) override {
    auto &s = at_[0];
    if (t == 0 && node.u.head<2>().norm() + node.v.head<2>().norm() > 0) { // let go
      const auto slip = s.slip;
      s = model_.state_at(node.u.head<2>(), node.v.head<2>());
      s.slip = s.slip_rate = slip;
    }
    place(s, node);
    Vector f = model_.system.forces(s.poses, s.velocity, {0, 0, s.slip}, s.contact, nullptr);
    add_ground(f, ground);
    const Matrix M = model_.system.mass_matrix(s.poses);
    s.acceleration = Vector::Zero(model_.system.n_dofs());
    s.acceleration.head(n_) = M.topLeftCorner(n_, n_).partialPivLu().solve(f.head(n_)).eval();
    force_[0] = f.segment<6>(n_);
    power_[0] = power_of(s, ground);
  }

  void begin_stage(const Stage &stage) override {
    stage_ = stage;
    const MotionState &from = at_[0], &middle = at_[1];
    MotionState &to = current();
    const bool park_wen = model_.system.park_wen;
    slip_step_ = park_wen ? stage.own : stage.reach;
    to.slip = from.slip;
    if (park_wen)
      for (std::size_t i = 0; i < to.slip.size(); ++i)
        to.slip[i] = reduced::tr_bdf2::base(stage, from.slip[i], from.slip_rate[i], middle.slip_rate[i]);
    start_ = reduced::tr_bdf2::start<Vector>(stage, from, middle);
    to.velocity = start_.velocity, to.poses = from.poses;
  }

  ElementForce linearise(const NodeMotion &node, bool renew) override {
    MotionState &to = current();
    place(to, node);
    const Vector motion = start_.moved + stage_.own * to.velocity;
    for (int b = 0; b < model_.plate; ++b) to.poses[b] = moved_by(at_[0].poses[b], motion, b);
    Vector f = model_.system.forces(to.poses, to.velocity, {stage_.own, slip_step_, to.slip}, to.contact,
                                    renew ? &tangent_ : nullptr);
    add_ground(f, stage_.ground);
    const OwnMatrix M = own_mass(to);
    to.acceleration = (to.velocity - start_.base) / stage_.own;
    if (renew) {
      own_tangent_.compute(M / stage_.own - tangent_.topLeftCorner(n_, n_));
      follows_ = own_tangent_.solve(Columns(tangent_.block(0, n_, n_, 6)));
    }
    own_ = own_tangent_.solve(OwnVector(f.head(n_) - M * to.acceleration.head(n_)));
    const auto back = tangent_.block(n_, 0, 6, n_);
    return {f.segment<6>(n_) + back * own_, tangent_.block<6, 6>(n_, n_) + back * follows_};
  }

  double correct(const Vector6 &node_velocity) override {
    const OwnVector correction = own_ + follows_ * node_velocity;
    current().velocity.head(n_) += correction;
    return correction.lpNorm<Eigen::Infinity>();
  }

  void end_stage() override {
    MotionState &to = current();
    to.acceleration = (to.velocity - start_.base) / stage_.own;
    for (std::size_t i = 0; i < to.slip.size(); ++i) {
      to.slip_rate[i] = (to.contact[i].slip - to.slip[i]) / slip_step_;
      to.slip[i] = to.contact[i].slip;
    }
    Vector6 f = Vector6::Zero();
    for (std::size_t i = 0; i < to.contact.size(); ++i)
      if (model_.system.contacts[i].master == model_.plate) {
        const Vector3d on_plate = -(to.contact[i].normal + to.contact[i].friction);
        f.head<3>() += on_plate, f.tail<3>() += (to.contact[i].at - to.poses[model_.plate].position).cross(on_plate);
      }
    force_[stage_.last ? 2 : 1] = f;
    power_[stage_.last ? 2 : 1] = power_of(to, stage_.ground);
  }

  double error(double h) const override {
    const auto velocity = [&](int stage, int body) { return Vector3d(at_[stage].velocity.segment<3>(6 * body)); };
    double largest = 0;
    for (int b = 0; b < model_.plate; ++b)
      largest = std::max(largest, reduced::tr_bdf2::error(h, velocity(0, b), velocity(1, b), velocity(2, b)).norm());
    return largest;
  }

  void accept() override {
    std::swap(at_[0], at_[2]);
    power_[0] = power_[2], force_[0] = force_[2];
    wall_memory_.press(model_.system, at_[0]);
    heat_.pass(model_.system, at_[0], stage_.t);
  }

  double wall(int stage) const override {
    double least = 1e300;
    for (const auto i : walls_) {
      const double d = at_[stage].contact[i].penetration;
      least = std::min(least, model_.system.unmet[i] ? -d : d);
    }
    return least;
  }
  bool change_walls() override {
    bool changed = false;
    for (const auto i : walls_) {
      const double d = at_[0].contact[i].penetration;
      if ((model_.system.unmet[i] ? -d : d) > 0) continue;
      model_.system.unmet[i] = !model_.system.unmet[i], changed = true;
    }
    return changed;
  }

  bool at_wall() const override {
    return std::any_of(walls_.begin(), walls_.end(), [&](std::size_t i) { return !model_.system.unmet[i]; });
  }
  ElementPower power(int stage) const override { return power_[stage]; }
  Vector6 force() const override { return force_[0]; }
  double kinetic_energy() const override { return model_.system.kinetic_energy(at_[0].poses, at_[0].velocity); }
  double potential_energy() const override { return model_.potential_energy(at_[0]) - potential_; }
  const char *lost() const override { return model_.lost(at_[0]); }

  BearingResponse response() const override {
    const MotionState &s = at_[0];
    BearingResponse r;
    r.u = model_.plate_displacement(s) - Vector3d(0, 0, rest_height_), r.v = s.velocity.segment<3>(n_);
    std::array<double, max_sets> apart;
    apart.fill(1e300);
    for (std::size_t i = 0; i < s.contact.size(); ++i) {
      const auto &c = model_.system.contacts[i];
      if (c.surface == Surface::dish) apart[c.set] = std::min(apart[c.set], -s.contact[i].penetration);
      if (c.master != model_.plate) continue;
      (c.surface == Surface::rim ? r.impact : r.pendular) -= s.contact[i].normal;
      r.friction -= s.contact[i].friction;
      if (c.surface == Surface::dish) r.normal += s.contact[i].size;
    }
    for (const auto i : walls_)
      if (model_.system.contacts[i].surface == Surface::rim) r.rim_force = std::max(r.rim_force, s.contact[i].size);
    r.height = r.u[2];
    for (const double opening : apart)
      if (opening < 1e300) r.height = std::min(r.height, r.u[2] - opening);
    r.gap = model_.gap(s), r.moment = force_[0].segment<2>(3);
    r.interface_slip = model_.interface_slip(s).head<2>();
    return r;
  }

private:
  MotionState &current() { return at_[stage_.last ? 2 : 1]; }
  void place(MotionState &s, const NodeMotion &node) const {
    const Vector3d turn = node.u.tail<3>();
    const double angle = turn.norm();
    auto &pose = s.poses[model_.plate];
    pose.position = rest_ + node.u.head<3>();
    pose.rotation = angle > 0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
    s.velocity.segment<6>(n_) = node.v;
  }
  void add_ground(Vector &f, const Vector3d &ground) const {
    for (int b = 0; b < model_.plate; ++b) f.segment<3>(6 * b) -= model_.system.bodies[b].mass * ground;
  }
  OwnMatrix own_mass(const MotionState &s) const {
    OwnMatrix M = OwnMatrix::Zero(n_, n_);
    for (int b = 0; b < model_.plate; ++b) {
      const auto &body = model_.system.bodies[b];
      M.block<3, 3>(6 * b, 6 * b).diagonal().setConstant(body.mass);
      M.block<3, 3>(6 * b + 3, 6 * b + 3) =
          s.poses[b].rotation * body.inertia.asDiagonal() * s.poses[b].rotation.transpose();
    }
    return M;
  }
  ElementPower power_of(const MotionState &s, const Vector3d &ground) const {
    ElementPower p;
    for (std::size_t i = 0; i < s.contact.size(); ++i)
      (is_wall(model_.system.contacts[i].surface) ? p.rim : p.contact) += s.contact[i].normal_power,
          p.friction += s.contact[i].slip_power;
    for (int b = 0; b < model_.plate; ++b)
      p.external -= model_.system.bodies[b].mass * ground.dot(s.velocity.segment<3>(6 * b));
    return p;
  }

  RigidBearing model_;
  int n_;             ///< own dofs, in front of the plate's six
  MotionState at_[3]; ///< start, middle, end of a step
  Vector6 force_[3];
  ElementPower power_[3];
  Vector3d rest_;
  double rest_height_ = 0, potential_ = 0, slip_step_ = 0;
  std::vector<std::size_t> walls_;
  WallMemory wall_memory_;
  HeatMemory heat_;
  Stage stage_{};
  reduced::StageStart<Vector> start_;
  Matrix tangent_;
  Eigen::PartialPivLU<OwnMatrix> own_tangent_;
  Columns follows_;
  OwnVector own_;
};

} // namespace

std::unique_ptr<BearingElement> rigid_element(const scene::Scene &scene) {
  return std::make_unique<RigidElement>(scene);
}

} // namespace rimpact::buildings
