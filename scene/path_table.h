/// A planar path read from a file: corners with straight lines between them. SI units.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace rimpact::scene {

/// The load parameter s in 0..1 is the share of the path's length; where the path halts it takes none.
struct PathTable {
  std::vector<Eigen::Vector2d> at; ///< corners [m], the first one 0, 0
  std::vector<double> share;       ///< of the length, at each corner: from 0, growing, to 1
  std::vector<double> time;        ///< [s], at each corner, growing; empty: the file gives none

  double length() const;                        ///< [m]
  double reach() const;                         ///< largest distance from the vertex [m]
  bool stays_on_x() const;                      ///< y = 0 all along
  Eigen::Vector2d displacement(double s) const; ///< [m]
  double instant(double s) const;               ///< [s]; needs `time`
  /// Load parameters of the corners at which the way turns by more than 1 degree.
  std::vector<double> turns() const;
};

/// CSV with a header: "x_m" or "x_mm", and if wanted "y_..." alike and "time_s" or "time_ms", in any order. Comment
/// lines begin with #. Throws DataError naming file, line and value.
PathTable read_path_table(const std::string &file);

} // namespace rimpact::scene
