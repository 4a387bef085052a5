#include "fe_contact/drive/touched_arcs.h"

#include "fe_contact/drive/state_fields.h"
#include "fe_contact/engine/solid_fields.h"
#include <algorithm>
#include <cmath>

namespace rimpact::fe {
namespace {

/// Arcs closer than this share one yielded state [rad].
constexpr double arc_width = 0.14;
constexpr double nearest_look = 1e-3; ///< a dented arc's true gap is computed within this of touch [m]
constexpr double most_arcs = 1000;

double direction_of(const Eigen::Vector3d &u) {
  return std::atan2(u.y(), u.x());
}

/// Angle between an arc's middle and a direction [rad], >= 0.
double apart(const Arc &arc, double direction) {
  return std::abs(std::remainder(direction - arc.frame.direction, 2 * M_PI));
}

} // namespace

const Arc *TouchedArcs::at(const Eigen::Vector3d &u) const {
  const double direction = direction_of(u);
  for (const auto &arc : arcs_)
    if (apart(arc, direction) < arc_width) return &arc;
  return nullptr;
}

double TouchedArcs::wall_gap(const Eigen::Vector3d &u) const {
  const double plain = bearing().lateral_capacity() - u.head<2>().norm();
  if (plain > nearest_look) return plain;
  const Arc *arc = at(u);
  return arc && arc->yielded ? arc->frame.rate_ratio() * system_.wall_gap(arc->state, arc->frame.master(u)) : plain;
}

std::optional<std::string> TouchedArcs::choose(const Eigen::Vector3d &u) {
  if (const Arc *known = at(u)) {
    current_ = static_cast<std::size_t>(known - arcs_.data());
    return {};
  }
  const double direction = direction_of(u);
  const bool near = std::ranges::any_of(arcs_, [&](const Arc &arc) { return apart(arc, direction) < 3 * arc_width; });
  arcs_.push_back(fresh(direction));
  current_ = arcs_.size() - 1;
  if (!near) return {};
  return "two touched arcs lie within " + std::to_string(int(3 * arc_width * 180 / M_PI)) +
         " degrees of one another; each was solved with its own yielded state";
}

SteelReport TouchedArcs::steel() const {
  SteelReport worst;
  for (const Arc &arc : arcs_) keep_worst(worst, steel_of(system_.model(), arc.state, arc.frame));
  return worst;
}

double TouchedArcs::largest_plastic_strain() const {
  double strain = 0;
  for (const auto &arc : arcs_) strain = std::max(strain, fe::largest_plastic_strain(arc.state.history));
  return strain;
}

void TouchedArcs::visit(StateVisitor &v) {
  v.length("arcs", arcs_, most_arcs, [&] { return fresh(0); });
  for (std::size_t k = 0; k < arcs_.size(); ++k)
    v.part("arc" + std::to_string(k), [&, &arc = arcs_[k]] {
      v.number("direction", arc.frame.direction, {-7, 7});
      v.flag("yielded", arc.yielded);
      fe::visit(v, arc.state);
    });
  v.integer("current_arc", current_, 0, std::max(0.0, static_cast<double>(arcs_.size()) - 1));
}

} // namespace rimpact::fe
