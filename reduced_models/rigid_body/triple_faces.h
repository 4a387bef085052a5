/// What is reported of a triple pendulum's four faces: travel, and what their rims have borne.
#pragma once
#include "reduced_models/rigid_body/rigid_bearing.h"
#include <nlohmann/json.hpp>
#include <optional>

namespace rimpact::reduced::rigid {

class TripleFaces {
public:
  explicit TripleFaces(const RigidBearing &model) : model_(model), faces_(model.parts.joints.size()) {}
  /// After every step.
  void watch(const MotionState &state);
  /// Hands signal and value of each to `put`.
  template <class Put> void store(const MotionState &state, Put put) const {
    for (int j = 0; j < static_cast<int>(faces_.size()); ++j) {
      const std::string face = "face_" + std::to_string(j + 1);
      const Eigen::Vector2d travel = model_.travel(state, j);
      put(face + "_travel_x", travel[0]), put(face + "_travel_y", travel[1]);
      const RimPress rim = pressed(state, j);
      put(face + "_rim_force", rim.force), put(face + "_rim_penetration", rim.penetration);
    }
  }
  /// A row a face, from the ground up: largest travel, first touch of its rim, largest force and penetration.
  nlohmann::json summary() const;

private:
  struct RimPress {
    double force = 0, penetration = 0;
  };
  RimPress pressed(const MotionState &state, int joint) const;
  struct Face {
    double travel = 0, force = 0, penetration = 0;
    std::optional<double> touched;
  };
  const RigidBearing &model_;
  std::vector<Face> faces_;
};

} // namespace rimpact::reduced::rigid
