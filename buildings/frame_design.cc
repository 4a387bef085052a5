#include "buildings/frame_design.h"
#include "buildings/inelastic_frame.h"
#include "buildings/members.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>

namespace rimpact::buildings {

using Eigen::VectorXd;

namespace {

/// Displacements under V over the floors as w h^k, base held.
VectorXd under_lateral_forces(const Frame &frame, const BuildingModel &model, const FrameDesign &design,
                              double gravity) {
  const auto height = [&](int d) { return frame.nodes[frame.diaphragms[d].nodes[0]].at.z(); };
  VectorXd forces = VectorXd::Zero(model.n_dofs()), q = forces;
  double weight = gravity * frame.diaphragms[0].mass;
  for (int d = 1; d < model.n_diaphragms; ++d) {
    weight += gravity * frame.diaphragms[d].mass;
    forces[3 * d] = frame.diaphragms[d].mass * std::pow(height(d) - height(0), design.height_exponent);
  }
  forces *= design.shear * weight / forces.sum();
  const auto free = model.above_base();
  const VectorXd moved = Eigen::MatrixXd(model.stiffness(free, free)).ldlt().solve(VectorXd(forces(free)));
  q(free) = moved;
  return q;
}

/// About y, of a member's end.
double bending_moment(const Element &e, const Frame &frame, const VectorXd &forces, int end) {
  const Eigen::Matrix3d axes = local_axes(frame.nodes[e.i].at, frame.nodes[e.j].at, e.up);
  return axes.col(1).dot(forces.segment<3>(6 * end + 3));
}

} // namespace

void design_yield_moments(Frame &frame, const FrameDesign &design, double gravity) {
  const auto lacks = [](const Section &s) { return s.inelastic && !(s.inelastic->yield_moment > 0); };
  if (std::none_of(frame.sections.begin(), frame.sections.end(), lacks)) return;
  Frame elastic = frame;
  for (auto &s : elastic.sections)
    s.inelastic->post_yield = 1, s.inelastic->yield_moment = 1, s.inelastic->interaction = Interaction::none;
  const BuildingModel model = assemble(elastic);
  const auto structure = inelastic_structure(elastic, model, gravity);
  const VectorXd of_weights = structure->members(structure->at_rest().q).forces,
                 of_forces = MemberForces(elastic, model).at(under_lateral_forces(elastic, model, design, gravity));
  std::vector<double> largest(frame.sections.size(), 0);
  for (std::size_t e = 0; e < frame.elements.size(); ++e) {
    const Element &m = frame.elements[e];
    for (int end = 0; end < 2; ++end) {
      const auto moment = [&](const VectorXd &all) {
        return std::abs(bending_moment(m, frame, all.segment<12>(12 * e), end));
      };
      largest[m.section] = std::max(largest[m.section], moment(of_weights) + moment(of_forces));
    }
  }
  for (std::size_t s = 0; s < frame.sections.size(); ++s)
    if (lacks(frame.sections[s])) frame.sections[s].inelastic->yield_moment = design.overstrength * largest[s];
}

} // namespace rimpact::buildings
