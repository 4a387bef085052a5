#include "buildings/frame.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace rimpact::buildings {

Section rectangle(const std::string &name, double y, double z, double E, double nu) {
  const double a = std::max(y, z), b = std::min(y, z), r = b / a;
  // Roark: within 4 % of the series for any ratio of the sides.
  const double torsion = a * b * b * b * (1. / 3 - 0.21 * r * (1 - r * r * r * r / 12));
  return {.name = name,
          .E = E,
          .G = E / (2 * (1 + nu)),
          .area = y * z,
          .Iy = y * z * z * z / 12,
          .Iz = z * y * y * y / 12,
          .torsion = torsion,
          .shear_y = 5. / 6 * y * z,
          .shear_z = 5. / 6 * y * z};
}

namespace {

[[noreturn]] void fault(FramePart part, std::size_t index, const std::string &says) {
  throw FrameFault(part, index, fmt::format("{} {} {}", word(part), index + 1, says));
}

void check_elements(const Frame &f) {
  const int n = static_cast<int>(f.nodes.size());
  for (std::size_t e = 0; e < f.elements.size(); ++e) {
    const Element &m = f.elements[e];
    for (const int end : {m.i, m.j})
      if (end < 0 || end >= n)
        fault(FramePart::element, e, fmt::format("ends at node {}; the frame has nodes 1 to {}", end + 1, n));
    if (m.section < 0 || m.section >= static_cast<int>(f.sections.size()))
      fault(FramePart::element, e, fmt::format("has section {}; the frame has {}", m.section + 1, f.sections.size()));
    const Eigen::Vector3d axis = f.nodes[m.j].at - f.nodes[m.i].at;
    if (!(axis.norm() > 0)) fault(FramePart::element, e, "has no length");
    if (!(axis.normalized().cross(m.up.normalized()).norm() > 1e-6))
      fault(FramePart::element, e, "runs along its own up direction");
  }
}

void check_diaphragms(const Frame &f) {
  if (f.diaphragms.empty()) throw InputError("the building has no diaphragm: its base is one");
  std::vector<int> owner(f.nodes.size(), -1);
  for (std::size_t d = 0; d < f.diaphragms.size(); ++d) {
    const Diaphragm &slab = f.diaphragms[d];
    if (!(slab.mass > 0))
      fault(FramePart::diaphragm, d, fmt::format("has the mass {} kg; it must be above 0", slab.mass));
    if (!(slab.inertia > 0))
      fault(FramePart::diaphragm, d,
            fmt::format("has the rotatory inertia {} kg m^2; it must be above 0", slab.inertia));
    if (slab.nodes.empty()) fault(FramePart::diaphragm, d, "has no nodes");
    for (const int node : slab.nodes) {
      if (node < 0 || node >= static_cast<int>(f.nodes.size()))
        fault(FramePart::diaphragm, d,
              fmt::format("names node {}; the frame has nodes 1 to {}", node + 1, f.nodes.size()));
      if (owner[node] >= 0)
        fault(FramePart::node, node, fmt::format("stands in diaphragms {} and {}", owner[node] + 1, d + 1));
      owner[node] = static_cast<int>(d);
    }
  }
  for (std::size_t i = 0; i < f.nodes.size(); ++i) {
    const Node &node = f.nodes[i];
    if (owner[i] < 0) fault(FramePart::node, i, "stands in no diaphragm");
    if (!(node.vertical_mass > 0))
      fault(FramePart::node, i, fmt::format("has the mass {} kg; it must be above 0", node.vertical_mass));
    if (node.supported && owner[i] != 0)
      fault(FramePart::node, i, "stands on a bearing but not in the base, diaphragm 1");
  }
}

void check_inelastic(const Frame &f) {
  for (std::size_t i = 0; i < f.nodes.size(); ++i)
    if (f.nodes[i].at.y() != 0)
      fault(FramePart::node, i,
            fmt::format("of an inelastic frame stands at y = {} m; its plane is y = 0", f.nodes[i].at.y()));
  for (std::size_t e = 0; e < f.elements.size(); ++e) {
    const auto &section = f.sections[f.elements[e].section];
    if (!section.inelastic) fault(FramePart::element, e, "is linear in an inelastic frame: give it a yield moment");
    if (section.shear_y != 0 || section.shear_z != 0)
      fault(FramePart::element, e, "has shear areas; inelastic members are rigid in shear: 0");
    const auto &s = *section.inelastic;
    const auto need = [&](bool held, const char *what, double value, const std::string &bound) {
      if (!held) fault(FramePart::element, e, fmt::format("has the {} {}; it must be {}", what, value, bound));
    };
    const double L = (f.nodes[f.elements[e].j].at - f.nodes[f.elements[e].i].at).norm();
    need(s.yield_moment > 0, "yield moment", s.yield_moment, "above 0");
    need(s.axial_yield > 0, "axial yield force", s.axial_yield, "above 0");
    need(s.hinge_length > 0 && s.hinge_length <= L / 6, "hinge length", s.hinge_length,
         fmt::format("above 0 and at most a sixth of the member, {:.6g} m", L / 6));
    need(s.post_yield >= 0 && s.post_yield <= 1, "post-yield ratio", s.post_yield, "in 0..1");
    need(s.exponent >= 1, "exponent", s.exponent, "1 or more");
    need(s.beta >= 0.5 && s.beta <= 1, "beta", s.beta, "in 0.5..1");
    need(s.strength_loss >= 0 && s.strength_loss <= 1, "strength degradation", s.strength_loss, "in 0..1");
    const double most = s.interaction == Interaction::none ? 2 : 2 / std::pow(interaction_of(s).largest(), 2);
    need(s.stiffness_loss >= 0 && s.stiffness_loss <= most, "stiffness degradation", s.stiffness_loss,
         fmt::format("in 0..{:.4g}", most)); // above, a loop could give energy
  }
}

} // namespace

bool Frame::inelastic() const {
  return std::any_of(elements.begin(), elements.end(),
                     [this](const Element &e) { return sections[e.section].inelastic.has_value(); });
}

void Frame::validate() const {
  if (!(damping_ratio >= 0 && damping_ratio <= 1))
    throw InputError(fmt::format("damping_ratio {} must be between 0 and 1", damping_ratio));
  check_elements(*this);
  check_diaphragms(*this);
  if (std::none_of(nodes.begin(), nodes.end(), [](const Node &n) { return n.supported; }))
    throw InputError("no node stands on a bearing");
  if (inelastic()) check_inelastic(*this);
}

} // namespace rimpact::buildings
