/// A piece of the path of a slider that presses the rim: penetration and place along the wall over one step of time.
///
/// Quartic in time, through the first instant's place, rate and acceleration and the last one's place and rate: within
/// O(h^5) of the path. It is the same function while its step is being taken (its last instant is then the present) and
/// afterwards.
#pragma once
#include <array>
#include <Eigen/Core>

namespace rimpact::reduced {

/// Where a slider touches the wall, and how that moves.
struct WallPoint {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< outward unit vector
  double d = 0, rate = 0, acceleration = 0;             ///< penetration beyond L_c, > 0 pressed [m], [m/s], [m/s^2]
  double along_rate = 0, along_acceleration = 0;        ///< along the wall, counter-clockwise [m/s], [m/s^2]
};
/// Of a slider at u (any length > 0 beyond or before `capacity`) with planar velocity v and acceleration a; `wall` [m]
/// the radius of the rim's wall, round which it goes.
WallPoint wall_point(const Eigen::Vector2d &u, const Eigen::Vector2d &v, const Eigen::Vector2d &a, double capacity,
                     double wall);
/// From `direction` to where a slider at u touches, along the wall, counter-clockwise [m].
double along_wall(const Eigen::Vector2d &direction, const Eigen::Vector2d &u, double wall);

class WallStroke {
public:
  /// `duration` [s] > 0; of `to` the accelerations are not read.
  WallStroke(const WallPoint &from, const WallPoint &to, double duration, double wall);
  /// Largest over the stroke of D - (s^2 + 2 tau s) / (2 flank): what a slider that touches at `from_start` along the
  /// wall from the stroke's first place meets at tau from its touch (dented_rim.h) [m]. Returns `above` where that is
  /// no less.
  double seen(double from_start, double tau, double flank, double above) const;
  const Eigen::Vector2d &direction() const { return direction_; } ///< of its first place
  double deepest() const { return deepest_; }                     ///< no less than any penetration in it [m]
  double low() const { return low_; }                             ///< bounds of its places from its first one [m]
  double high() const { return high_; }
  double end_place() const { return end_place_; } ///< from its first one [m]
  double end_depth() const { return end_depth_; } ///< [m]

private:
  struct Quartic {
    std::array<double, 5> c{}; ///< powers of the share of the duration
    Quartic() = default;
    Quartic(double p0, double m0, double k0, double p1, double m1);
    double at(double x) const { return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4]))); }
    double slope(double x) const { return c[1] + x * (2 * c[2] + x * (3 * c[3] + x * 4 * c[4])); }
    double bend(double x) const { return 2 * c[2] + x * (6 * c[3] + x * 12 * c[4]); }
    double bulge() const; ///< how far it leaves its chord at most
  };
  Eigen::Vector2d direction_;
  Quartic depth_, place_;
  double end_depth_, end_place_, deepest_, low_, high_;
};

} // namespace rimpact::reduced
