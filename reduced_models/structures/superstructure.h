/// A building on an isolated base (thesis Figs. 2-33, 4-3): a chain of floors joined by storeys, each a
/// lateral spring (linear, or Bouc-Wen) with a dashpot and an axial spring with its own. Displacements are
/// relative to the ground, vertical ones from the statically compressed building, so that axial forces here
/// are changes from the dead load. Every isolator model carries the same chain. SI units.
#pragma once
#include "reduced_models/motion/state.h"
#include "reduced_models/structures/bouc_wen.h"
#include "scene/scene.h"
#include <optional>
#include <vector>

namespace rimpact::reduced {

struct Storey {
  double mass;               ///< of the floor above it [kg]
  double stiffness, damping; ///< lateral, elastic k and c [N/m], [N s/m]
  double axial_stiffness, axial_damping;
  std::optional<BoucWen> hysteresis; ///< absent: linear

  /// What the storey does to the floor above it [N]; the opposite acts below. `drift`, `rate`: of the floor
  /// above relative to the one below.
  Eigen::Vector3d force(const Eigen::Vector3d &drift, const Eigen::Vector3d &rate, const Eigen::Vector2d &z) const;
  double elastic_energy(const Eigen::Vector3d &drift, const Eigen::Vector2d &z) const;
  double damping_power(const Eigen::Vector3d &rate) const;
  /// Of the hysteretic part alone; what of it is not in elastic_energy is lost.
  double hysteretic_power(const Eigen::Vector3d &rate, const Eigen::Vector2d &z) const;
  double hysteretic_energy(const Eigen::Vector2d &z) const; ///< recoverable part, in elastic_energy too
};

/// Where a body is and how it moves, vertical part as above.
struct FloorMotion {
  Eigen::Vector3d position, velocity;
};

class Superstructure {
public:
  explicit Superstructure(const scene::Scene &scene);

  std::vector<Storey> storeys; ///< from the base up; empty: none
  bool any() const { return !storeys.empty(); }
  int n_floors() const { return static_cast<int>(storeys.size()); }
  double mass() const; ///< of all floors [kg]
  double collapse_drift = std::numeric_limits<double>::infinity();

  FloorMotion floor(const State &y, int i) const;
  static Eigen::Vector2d hysteresis(const State &y, int i);
  /// What the first storey does to the base [N].
  Eigen::Vector3d force_on_base(const State &y, const FloorMotion &base) const;
  /// Fills the floors' and works' part of dy; the base moves as given, the ground with a_g.
  void rates(const State &y, const FloorMotion &base, const Eigen::Vector3d &a_g, State &dy) const;
  /// Floors ride along with the base, no storey strained.
  void follow(const FloorMotion &base, State &y) const;

  double kinetic_energy(const State &y) const;
  double elastic_energy(const State &y, const Eigen::Vector3d &base) const;
  double plastic_energy(const State &y) const;                             ///< lost in hysteresis [J]
  double largest_drift(const State &y, const Eigen::Vector3d &base) const; ///< lateral, of all storeys [m]
  Eigen::Vector3d drift(const State &y, const Eigen::Vector3d &base, int i) const;
};

} // namespace rimpact::reduced
