/// Follows an impact of the walls from touch to release: its instants, its speeds, its peaks.
#pragma once
#include "fe_contact/drive/state_visitor.h"
#include "responses/summary.h"

namespace rimpact::fe {

class ImpactFollower {
public:
  /// The slider comes to the rim at a displacement u from rest on the vertex, at a radial speed [m], [m/s].
  void begin(double t, const Eigen::Vector3d &u, double approach_speed);
  /// At the end of a step: the walls' force, how far the slider is beyond L_c, its outward speed. [N], [m], [m/s].
  void follow(double t, double force, double penetration, double outward_speed);
  void touch() { touched_ = true; }
  bool touched() const { return touched_; }
  /// True once an impact: at its first step at which the slider, the walls having touched, does not go outwards.
  bool turns(double outward_speed);
  void forget() { touched_ = turned_ = false; }
  void set_rebound(double speed) { impact_.rebound_speed = speed; } ///< [m/s]
  const Impact &impact() const { return impact_; }
  void visit(StateVisitor &v);

private:
  Impact impact_{};
  bool touched_ = false, turned_ = false;
};

} // namespace rimpact::fe
