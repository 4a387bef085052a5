#include "buildings/inelastic_frame.h"
#include "buildings/plane_beam_column.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <Eigen/LU>

namespace rimpact::buildings {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

SectionPoints along(const SectionPoints &p, double weight, const SectionPoints &rates) {
  SectionPoints r = p;
  for (int i = 0; i < 3; ++i)
    r[i].d += weight * rates[i].d, r[i].z += weight * rates[i].z, r[i].e += weight * rates[i].e;
  return r;
}
/// (to - from) / h
SectionPoints rates_between(const SectionPoints &from, const SectionPoints &to, double h) {
  SectionPoints r;
  for (int i = 0; i < 3; ++i) r[i] = {(to[i].d - from[i].d) / h, (to[i].z - from[i].z) / h, (to[i].e - from[i].e) / h};
  return r;
}

PlaneBeamColumn member_law(const Frame &frame, const Element &e) {
  const auto &section = frame.sections[e.section];
  const auto &s = *section.inelastic;
  const Eigen::Vector3d &from = frame.nodes[e.i].at, &to = frame.nodes[e.j].at;
  const Eigen::Matrix3d axes = local_axes(from, to, e.up);
  const double EI = section.E * (std::abs(axes(2, 1)) > 0.5 ? section.Iz : section.Iy), EA = section.E * section.area;
  PlaneBeamColumn m;
  m.from = {from.x(), from.z()}, m.to = {to.x(), to.z()};
  m.bending = {s.yield_moment, s.yield_moment / EI, s.post_yield,    s.exponent,
               s.beta,         s.strength_loss,     s.stiffness_loss};
  m.axial = {s.axial_yield, s.axial_yield / EA, s.post_yield, s.exponent, s.beta, s.strength_loss, s.stiffness_loss};
  if (s.interaction != Interaction::none) m.interaction = interaction_of(s);
  m.hinge_length = s.hinge_length, m.load = e.load * std::abs(to.x() - from.x()) / m.length();
  return m;
}

class InelasticFrame : public Structure {
public:
  InelasticFrame(const Frame &frame, const BuildingModel &model, double gravity)
      : model_(model), damping_(model.damping) {
    for (int dof = 0; dof < 3 * model.n_diaphragms; ++dof) // across the plane not even rounding moves it
      if (dof % 3 != 0) damping_.row(dof).setZero(), damping_.col(dof).setZero();
    std::vector<int> floor(frame.nodes.size());
    for (std::size_t d = 0; d < frame.diaphragms.size(); ++d)
      for (const int node : frame.diaphragms[d].nodes) floor[node] = static_cast<int>(d);
    const int n = model.n_dofs();
    for (const Element &e : frame.elements) {
      Member m{.law = member_law(frame, e), .dofs = {}, .axes = {}, .base = {}, .answer = {}, .at = {}, .rates = {}};
      m.axes = local_axes(frame.nodes[e.i].at, frame.nodes[e.j].at, e.up);
      for (int end = 0; end < 2; ++end) {
        const int node = end ? e.j : e.i;
        m.dofs[3 * end] = 3 * floor[node], m.dofs[3 * end + 1] = model.vertical(node), m.dofs[3 * end + 2] = n + node;
      }
      members_.push_back(m);
    }
    for (auto &turns : turns_) turns = VectorXd::Zero(model.n_nodes);
    for (auto &rate : turn_rates_) rate = turns_[0];
    mean_turn_rate_ = turn_correction_ = turns_[0];
    update_modes(gravity);
    turns_at_rest_ = turns_[0];
  }

  bool turns_nodes() const override { return true; }
  NodeTurn turn(int bearing) const override { // the plane's turn from x to z is one about -y
    const int node = model_.bearings[bearing];
    return {turns_at_rest_[node] - turns_[slot_][node],
            slot_ == 0 ? -turn_rates_[0][node] : (turns_from_[node] - turns_[slot_][node]) / stage_.own};
  }
  double turn_rate_correction(int bearing) const override {
    return -turn_correction_[model_.bearings[bearing]] / stage_.own;
  }

  Rest at_rest() const override { return rest_; }

  VectorXd start(const VectorXd &q, const VectorXd &v) override {
    slot_ = 0;
    for (auto &m : members_) m.base = m.at[0];
    evaluate(q, turns_[0], 0);
    return -force_.head(model_.n_dofs()) - damping_ * v;
  }

  void begin_stage(const Stage &stage) override {
    stage_ = stage, slot_ = stage.last ? 2 : 1;
    for (auto &m : members_) {
      m.base = along(m.at[0], stage.w1, m.rates[0]);
      if (stage.last) m.base = along(m.base, stage.w2, m.rates[1]);
      m.at[slot_] = m.at[stage.last ? 1 : 0];
    }
    turns_from_ = reduced::tr_bdf2::base(stage, turns_[0], turn_rates_[0], turn_rates_[1]);
    turns_[slot_] = turns_[0] + stage.reach * mean_turn_rate_;
  }

  void linearise(const VectorXd &q, const VectorXd &v, const std::vector<NodeMoment> &moments, VectorXd &force,
                 MatrixXd &tangent) override {
    evaluate(q, turns_[slot_], slot_);
    const int n = model_.n_dofs(), m = model_.n_nodes;
    // Of the turns: what is out of balance, its derivative by the velocity, by the turns; and of the dofs by the turns.
    VectorXd moment = -force_.tail(m);
    MatrixXd by_velocity = stage_.own * stiffness_.bottomLeftCorner(m, n), by_turn = stiffness_.bottomRightCorner(m, m),
             across = stiffness_.topRightCorner(n, m);
    for (std::size_t b = 0; b < moments.size(); ++b) { // a turn is one about -y
      const int node = model_.bearings[b];
      const NodeMoment &on = moments[b];
      moment[node] -= on.moment;
      by_velocity.row(node) += on.by_velocity.transpose();
      by_turn(node, node) -= on.by_rate / stage_.own;
      across.col(node) += on.force_by_rate / stage_.own;
    }
    const Eigen::PartialPivLU<MatrixXd> lu(by_turn);
    follows_ = -lu.solve(by_velocity), own_ = lu.solve(moment);
    force -= force_.head(n) + across * own_ + damping_ * v;
    tangent += stage_.own * stiffness_.topLeftCorner(n, n) + across * follows_ + damping_;
  }

  double correct(const VectorXd &velocity) override {
    turn_correction_ = own_ + follows_ * velocity;
    turns_[slot_] += turn_correction_;
    return turn_correction_.lpNorm<Eigen::Infinity>() / stage_.own;
  }

  void end_stage() override {
    turn_rates_[slot_] = (turns_[slot_] - turns_from_) / stage_.own;
    for (auto &m : members_) m.rates[slot_] = rates_between(m.base, m.at[slot_], stage_.own);
  }

  void accept() override {
    for (auto &m : members_) m.at[0] = m.at[2], m.rates[0] = m.rates[2];
    mean_turn_rate_ = (turns_[2] - turns_[0]) / stage_.reach;
    turns_[0] = turns_[2], turn_rates_[0] = turn_rates_[2], slot_ = 0;
  }

  Power power(int stage, const VectorXd &v) const override {
    Power p{v.dot(damping_ * v), 0};
    for (const auto &m : members_) p.hysteretic += m.law.loss(m.at[stage], m.rates[stage]);
    return p;
  }

  double stored(const VectorXd &) const override {
    double sum = 0;
    for (const auto &m : members_) sum += m.law.stored(m.at[0]);
    return sum;
  }

  MembersResponse members(const VectorXd &q) const override {
    MembersResponse r;
    r.forces.resize(12 * members_.size());
    for (std::size_t e = 0; e < members_.size(); ++e) {
      const Member &m = members_[e];
      const auto answer = m.law.at(motion(m, q, turns_[0]), m.at[0], m.at[0]);
      for (int end = 0; end < 2; ++end) {
        const Vector3 f = answer.force.segment<3>(3 * end);
        const double carried = m.law.load * m.law.length() / 2; // its weight, which stands at the nodes
        r.forces.segment<3>(12 * e + 6 * end) = m.axes * Vector3(f[0], 0, f[1] + carried);
        r.forces.segment<3>(12 * e + 6 * end + 3) = m.axes * Vector3(0, -f[2], 0);
        const auto &p = m.at[0][end];
        r.hinges.push_back({-f[2], -m.law.plastic_rotation(end, m.at[0]),
                            std::abs(p.d) / m.law.bending.yield_deformation, m.law.bending.strength_left(p),
                            m.law.bending.stiffness_left(p)});
      }
    }
    return r;
  }

private:
  struct Member {
    PlaneBeamColumn law;
    std::array<int, 6> dofs; ///< (u_x, u_z, turn) of both ends; turns behind the building's dofs
    Eigen::Matrix3d axes;
    SectionPoints base; ///< that the stage starts from
    PlaneBeamColumn::Answer answer;
    SectionPoints at[3], rates[3]; ///< at start, middle, end of a step
  };

  PlaneVector motion(const Member &m, const VectorXd &q, const VectorXd &turns) const {
    const int n = model_.n_dofs();
    PlaneVector u;
    for (int c = 0; c < 6; ++c) u[c] = c % 3 == 2 ? turns[m.dofs[c] - n] : q[m.dofs[c]];
    return u;
  }

  /// Forces on dofs and turns with their stiffness; the sections' points are those of `slot`.
  void evaluate(const VectorXd &q, const VectorXd &turns, int slot) {
    const int all = model_.n_dofs() + model_.n_nodes;
    force_ = VectorXd::Zero(all), stiffness_ = MatrixXd::Zero(all, all);
    for (auto &m : members_) {
      m.answer = m.law.at(motion(m, q, turns), m.base, m.at[slot], slot == 0 ? 0 : stage_.own);
      m.at[slot] = m.answer.inner.points;
      for (int a = 0; a < 6; ++a) {
        force_[m.dofs[a]] += m.answer.force[a];
        for (int b = 0; b < 6; ++b) stiffness_(m.dofs[a], m.dofs[b]) += m.answer.tangent(a, b);
      }
    }
  }

  /// Sections follow the weight by BDF2. Twice the steps until the forces stay where they are.
  void update_modes(double gravity) {
    constexpr int fewest = 20, most = 640;
    constexpr double close = 1e-4; // of the largest force: the finer of two is four times nearer
    const int n = model_.n_dofs(), nn = model_.n_nodes;
    VectorXd weight = VectorXd::Zero(n + nn);
    weight.segment(3 * model_.n_diaphragms, nn) = gravity * model_.mass.tail(nn);
    put_on(weight, fewest);
    VectorXd coarse = end_forces();
    for (int steps = 2 * fewest; steps <= most; steps *= 2) {
      put_on(weight, steps);
      const VectorXd fine = end_forces();
      const double moved = (fine - coarse).lpNorm<Eigen::Infinity>();
      coarse = fine;
      if (moved < close * fine.lpNorm<Eigen::Infinity>()) break;
    }
    rest_.reactions.resize(model_.bearings.size());
    for (std::size_t b = 0; b < model_.bearings.size(); ++b) {
      const int dof = model_.vertical(model_.bearings[b]);
      rest_.reactions[b] = force_[dof] + weight[dof];
    }
    for (auto &m : members_)
      for (auto &p : m.at[0]) p.e = 0;
  }

  VectorXd end_forces() const {
    VectorXd all(6 * members_.size());
    for (std::size_t e = 0; e < members_.size(); ++e) all.segment<6>(6 * e) = members_[e].answer.force;
    return all;
  }

  /// The weight in `n_steps` equal steps from the unloaded frame, base nodes held.
  void put_on(const VectorXd &weight, int n_steps) {
    const int n = model_.n_dofs(), nn = model_.n_nodes;
    std::vector<double> loads;
    std::vector<SectionPoints> before(members_.size());
    for (auto &m : members_) m.at[0] = {}, loads.push_back(m.law.load);
    const auto free = free_at_rest();
    VectorXd u = VectorXd::Zero(n + nn);
    for (int step = 1; step <= n_steps; ++step) {
      const double share = static_cast<double>(step) / n_steps;
      for (std::size_t e = 0; e < members_.size(); ++e) {
        Member &m = members_[e]; // from rest the first step is one of Euler's
        m.base = step == 1 ? m.at[0] : along(m.at[0], 1.0 / 3, rates_between(before[e], m.at[0], 1));
        before[e] = m.at[0], m.law.load = share * loads[e];
      }
      balance(share * weight, free, u);
    }
    rest_.q = u.head(n), turns_[0] = u.tail(nn);
  }

  /// What moves while base nodes are held: floors along x, nodes up and down, turns of all nodes.
  std::vector<int> free_at_rest() const {
    std::vector<int> free;
    for (const int dof : model_.above_base())
      if (dof >= 3 * model_.n_diaphragms || dof % 3 == 0) free.push_back(dof);
    for (int i = 0; i < model_.n_nodes; ++i) free.push_back(model_.n_dofs() + i);
    return free;
  }

  /// Newton over the dofs of `free`.
  void balance(const VectorXd &weight, const std::vector<int> &free, VectorXd &u) {
    constexpr int most = 50;
    const int n = model_.n_dofs(), nn = model_.n_nodes;
    double largest = 1;
    for (int i = 0; i < most && largest > 1e-13; ++i) {
      evaluate(u.head(n), u.tail(nn), 0);
      const VectorXd pull = -(force_ + weight)(free);
      const VectorXd correction = MatrixXd(stiffness_(free, free)).partialPivLu().solve(pull).eval();
      largest = correction.allFinite() ? correction.lpNorm<Eigen::Infinity>() : 1;
      u(free) += correction;
    }
    if (!(largest < 1e-10)) throw InputError("the inelastic frame cannot carry its weight at rest");
  }

  const BuildingModel &model_;
  MatrixXd damping_;
  std::vector<Member> members_;
  /// Of every node, from x to z [rad], [rad/s]: at start, middle, end of a step.
  VectorXd turns_[3], turn_rates_[3];
  VectorXd turns_at_rest_, turns_from_, mean_turn_rate_, turn_correction_;
  int slot_ = 0; ///< of the iterate
  VectorXd force_, own_;
  MatrixXd stiffness_, follows_;
  Rest rest_;
  Stage stage_{};
};

} // namespace

std::unique_ptr<Structure> inelastic_structure(const Frame &frame, const BuildingModel &model, double gravity) {
  return std::make_unique<InelasticFrame>(frame, model, gravity);
}

} // namespace rimpact::buildings
