/// The arcs of a rim that a slider has touched: each keeps its own yielded state.
#pragma once
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/state_visitor.h"

namespace rimpact::fe {

struct Arc {
  RimFrame frame;
  SystemState state;
  bool yielded = false;
};

class TouchedArcs {
public:
  /// `touch_height` of the surface at L_c [m]; `level`: windows hold what is carried at its height.
  TouchedArcs(BearingSystem &system, double touch_height, bool level)
      : system_(system), touch_height_(touch_height), level_(level) {}
  TouchedArcs(const TouchedArcs &) = delete;

  bool empty() const { return arcs_.empty(); }
  Arc &current() { return arcs_[current_]; } ///< the one chosen last
  const Arc &current() const { return arcs_[current_]; }
  /// The arc that is touched at a slider displacement [m] becomes the current one: a known one, or a fresh one. A
  /// sentence where two of them lie near one another.
  std::optional<std::string> choose(const Eigen::Vector3d &u);
  /// Distance of the walls at a slider displacement [m]: exact for fresh arcs, by projection for dented ones.
  double wall_gap(const Eigen::Vector3d &u) const;
  SteelReport steel() const;             ///< the worst of all
  double largest_plastic_strain() const; ///< of all
  void visit(StateVisitor &v);

private:
  const scene::Bearing &bearing() const { return system_.model().bearing; }
  Arc fresh(double direction) const {
    return {RimFrame::of(bearing(), direction, touch_height_, level_), system_.at_rest(), false};
  }
  const Arc *at(const Eigen::Vector3d &u) const; ///< null: none is known there

  BearingSystem &system_;
  double touch_height_;
  bool level_;
  std::vector<Arc> arcs_;
  std::size_t current_ = 0;
};

} // namespace rimpact::fe
