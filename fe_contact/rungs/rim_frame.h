/// Between the plate's frame and an arc's: +x' radially outwards at the arc's direction, origin of
/// displacements at the position of first touch (travel L_c, height of the surface there).
///
/// Of a slider between two like dishes one half is modelled, one dish and the slider to its middle: a half turn about
/// that middle maps it on the other half. With q the displacement of the slider's middle what is carried has moved by
/// u = 2 q, both halves do the same work, and a mass m carried is one of 2 m on q: m u'^2 / 2 = 2 (2 m q'^2 / 2).
///
/// That slider turns about the dish's centre as it goes, its edge with it. The model's bodies do not turn: they are
/// moved as the edge is, w = reach P q, reach = R / (R - H_s / 2) and P the turn in the vertical plane from the way of
/// the middle to that of the edge. Forces follow from their work: f_u . u' = 2 f_w . w'.
#pragma once
#include "scene/bearing.h"
#include <cmath>
#include <Eigen/Geometry>

namespace rimpact::fe {

struct RimFrame {
  double direction;        ///< of the arc [rad]
  double lateral_capacity; ///< L_c [m]
  double touch_height;     ///< height of the surface at L_c [m]
  int dishes = 1;          ///< u over q
  double reach = 1;        ///< length of w over q's
  double turn = 0;         ///< of P, upwards [rad]

  /// `touch_height` at L_c [m]. `level`: what is carried moves in a plane, and between two dishes the edge along its
  /// dish all the same.
  static RimFrame of(const scene::Bearing &bearing, double direction, double touch_height, bool level) {
    RimFrame frame{direction, bearing.lateral_capacity(), touch_height};
    if (!bearing.double_concave()) return frame;
    const double R = bearing.surface.R0;
    frame.dishes = bearing.dishes();
    frame.reach = R / (R - bearing.slider.height / 2);
    frame.turn = std::asin(bearing.slider.diameter / (2 * R));
    if (level) frame.turn += scene::tilt(bearing, frame.lateral_capacity);
    return frame;
  }

  Eigen::Matrix3d rotation() const {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity(), P = Eigen::Matrix3d::Identity();
    R(0, 0) = R(1, 1) = std::cos(direction);
    R(1, 0) = std::sin(direction);
    R(0, 1) = -R(1, 0);
    P(0, 0) = P(2, 2) = std::cos(turn);
    P(2, 0) = std::sin(turn);
    P(0, 2) = -P(2, 0);
    return R * P.transpose();
  }
  Eigen::Vector3d to_local(const Eigen::Vector3d &vector) const { return rotation().transpose() * vector; }
  Eigen::Vector3d to_global(const Eigen::Vector3d &vector) const { return rotation() * vector; }
  /// A place of the model in the plate's frame [m].
  Eigen::Vector3d in_plate(const Eigen::Vector3d &place) const {
    return Eigen::AngleAxisd(direction, Eigen::Vector3d::UnitZ()) * place;
  }
  double rate_ratio() const { return dishes / reach; } ///< of u' over w'
  /// Velocity or acceleration of what is carried (global) -> of the master (local), and back.
  Eigen::Vector3d master_rate(const Eigen::Vector3d &rate) const { return to_local(rate) / rate_ratio(); }
  Eigen::Vector3d rate(const Eigen::Vector3d &master) const { return rate_ratio() * to_global(master); }
  /// The same of its displacement.
  Eigen::Vector3d master(const Eigen::Vector3d &displacement) const { return master_rate(displacement - touch()); }
  Eigen::Vector3d displacement(const Eigen::Vector3d &master) const { return rate(master) + touch(); }
  /// A force on what is carried (global) as one on the master (local), and back [N].
  Eigen::Vector3d master_force(const Eigen::Vector3d &force) const { return to_local(force) / reach; }
  Eigen::Vector3d force(const Eigen::Vector3d &master) const { return reach * to_global(master); }

private:
  Eigen::Vector3d touch() const {
    return {lateral_capacity * std::cos(direction), lateral_capacity * std::sin(direction), touch_height};
  }
};

} // namespace rimpact::fe
