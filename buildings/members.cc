#include "buildings/members.h"
#include "buildings/beam_column.h"
#include "io/files/file.h"
#include <fmt/format.h>

namespace rimpact::buildings {

using Eigen::MatrixXd, Eigen::VectorXd;

MemberForces::MemberForces(const Frame &frame, const BuildingModel &model)
    : over_q_(MatrixXd::Zero(n_components * frame.elements.size(), model.n_dofs())) {
  for (std::size_t e = 0; e < frame.elements.size(); ++e) {
    const Element &member = frame.elements[e];
    const auto &from = frame.nodes[member.i].at, &to = frame.nodes[member.j].at;
    MatrixXd ends(12, model.n_dofs());
    ends << model.nodal.middleRows(6 * member.i, 6), model.nodal.middleRows(6 * member.j, 6);
    MatrixXd forces = beam_column_stiffness(frame.sections[member.section], from, to, member.up) * ends;
    const Eigen::Matrix3d axes = local_axes(from, to, member.up);
    for (int b = 0; b < 4; ++b) over_q_.middleRows(n_components * e + 3 * b, 3) = axes * forces.middleRows(3 * b, 3);
  }
}

void MemberEnvelope::widen(const VectorXd &forces) {
  if (least.size() == 0) {
    least = largest = at_rest = forces;
    return;
  }
  least = least.cwiseMin(forces), largest = largest.cwiseMax(forces);
}

void write_members(const Frame &frame, const MemberEnvelope &envelope, const std::string &path) {
  constexpr std::array names{"N_x_N", "V_y_N", "V_z_N", "T_N_m", "M_y_N_m", "M_z_N_m"};
  std::string text = "element,node,end";
  for (const char *what : {"least", "largest", "at_rest"})
    for (const char *name : names) text += fmt::format(",{}_{}", what, name);
  text += "\n";
  for (std::size_t e = 0; e < frame.elements.size(); ++e)
    for (int end = 0; end < 2; ++end) {
      const auto &member = frame.elements[e];
      text += fmt::format("{},{},{}", e + 1, (end ? member.j : member.i) + 1, end ? "j" : "i");
      for (const auto *values : {&envelope.least, &envelope.largest, &envelope.at_rest})
        for (int c = 0; c < 6; ++c)
          text += fmt::format(",{:.6g}", (*values)[MemberForces::n_components * e + 6 * end + c]);
      text += "\n";
    }
  write_atomically(text, path);
}

} // namespace rimpact::buildings
