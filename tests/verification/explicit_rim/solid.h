/// Bodies of 8-node cells in explicit time: a formulation of its own, beside the program's 27-node cells in total
/// Lagrangian form. mm, N, MPa, t, s.
///
/// Rate of deformation at 8 points of the moved cell, its volume rate that of the whole cell (B-bar, Hughes 1980),
/// Jaumann's rate, radial return (J2, linear isotropic hardening, on request the rate of Cowper and Symonds), lumped
/// mass.
#pragma once
#include <array>
#include <vector>

namespace explicit_rim {

using Vec3 = std::array<double, 3>;

inline double dot(const Vec3 &a, const Vec3 &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Steel {
  double shear, bulk, yield, hardening, density; ///< [MPa], [t/mm^3]; hardening: slope over plastic strain
  double rate_D = 0, rate_q = 5;                 ///< yield times 1 + (rate / D)^(1/q), D [1/s]; 0: knows no rate
};

/// Stress, symmetric: xx yy zz xy yz zx, and the equivalent plastic strain.
struct Point {
  std::array<double, 6> stress{};
  double plastic = 0;
};

class Solid {
public:
  /// `longest_step` [s]: cells that would need a shorter one are made heavier, see added_mass().
  Solid(std::vector<Vec3> nodes, std::vector<std::array<int, 8>> cells, const Steel &steel, double longest_step);
  /// Stresses after `step` with `velocity`, at the places `x`; adds what the cells push the nodes with.
  void advance(const std::vector<Vec3> &x, const std::vector<Vec3> &velocity, double step, std::vector<Vec3> &force);
  const std::vector<double> &mass() const { return mass_; } ///< of each node [t]
  const std::vector<Vec3> &nodes() const { return nodes_; }
  double added_mass() const { return added_; }     ///< by the longest step [t]
  double plastic_work() const { return plastic_; } ///< [N mm]
  double largest_plastic_strain() const;

private:
  void cell(const std::array<int, 8> &nodes, Point *points, const std::vector<Vec3> &x, const std::vector<Vec3> &v,
            double step, std::vector<Vec3> &force);

  std::vector<Vec3> nodes_;
  std::vector<std::array<int, 8>> cells_;
  Steel steel_;
  std::vector<Point> points_; ///< 8 a cell
  std::vector<double> mass_;
  double added_ = 0, plastic_ = 0;
};

} // namespace explicit_rim
