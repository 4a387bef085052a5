/// A beam-column in the plane: corotational Euler-Bernoulli member, elastic between two inelastic end sections, with an
/// inelastic axial spring. Basic deformations past the chord: elongation, rotations of the ends (anticlockwise):
///   phi = phi_load + F M + l_p kappa,   M = M(kappa) of each end's law,   F = L / (6 E I) [2 -1; -1 2] - l_p / (E I),
/// so that the member is exactly E I before yield. Source: corotation as Crisfield (1990) and Le, Battini and Hjiaj
/// (2011); end sections of length l_p as Scott and Fenves, J. Struct. Eng. 132 (2006). SI units.
#pragma once
#include "buildings/axial_bending.h"
#include "buildings/degrading_bouc_wen.h"
#include <array>
#include <Eigen/Core>
#include <optional>

namespace rimpact::buildings {

using Vector3 = Eigen::Vector3d;
using PlaneVector = Eigen::Matrix<double, 6, 1>; ///< (x, z, rotation) of end i, then of end j
using PlaneMatrix = Eigen::Matrix<double, 6, 6>;

/// End section i: moment over curvature; end section j; axial force over strain.
using SectionPoints = std::array<DegradingBoucWen::Point, 3>;

struct PlaneBeamColumn {
  Eigen::Vector2d from, to; ///< of the ends at rest (x, z) [m]
  DegradingBoucWen bending; ///< of both end sections: M [N m] over curvature [1/m]; its stiffness is E I
  DegradingBoucWen axial;   ///< N [N] over strain [-]; its stiffness is E A
  std::optional<AxialBending> interaction = {}; ///< none: the moment does not know its axial force
  double hinge_length = 0;                      ///< l_p [m], > 0, at most L / 6
  double load = 0; ///< across the member, downwards on one that lies level [N/m]; its end shears act elsewhere

  double length() const { return (to - from).norm(); }

  struct Basic {
    Vector3 force;          ///< N, M_i, M_j
    Eigen::Matrix3d slopes; ///< by the basic deformations; symmetric but for an interaction
    SectionPoints points;
  };
  /// `base`: what a stage starts from, `guess`: where Newton over the two curvatures does; dt: time of the stage's own
  /// rate [s], read by an interaction. Forces are not numbers where
  /// it finds no solution.
  Basic basic(const Vector3 &deformation, const SectionPoints &base, const SectionPoints &guess, double dt = 0) const;

  struct Answer {
    PlaneVector force;   ///< of the nodes on the ends
    PlaneMatrix tangent; ///< by the ends' motion, symmetric but for an interaction
    Basic inner;
  };
  Answer at(const PlaneVector &motion, const SectionPoints &base, const SectionPoints &guess, double dt = 0) const;

  double stored(const SectionPoints &points) const;                           ///< [J]
  double loss(const SectionPoints &points, const SectionPoints &rates) const; ///< [W]
  /// Plastic rotation l_p (kappa - M / E I) of an end (0 or 1) [rad].
  double plastic_rotation(int end, const SectionPoints &points) const;

private:
  struct Bent {
    bool found;
    Eigen::Vector2d moment;
    Eigen::Matrix2d slopes;      ///< by the rotations
    Eigen::Vector2d by_capacity; ///< of the moments at held rotations
  };
  /// Curvatures of both ends into `points`, the law's capacity that of the axial force.
  Bent bent(const DegradingBoucWen &law, const Eigen::Vector2d &rotations, const SectionPoints &base,
            const SectionPoints &guess, SectionPoints &points) const;
  Eigen::Matrix2d interior() const; ///< F
};

} // namespace rimpact::buildings
