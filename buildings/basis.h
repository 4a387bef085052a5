/// What every way of integrating a building shares: its matrices, where its bearings stand, what a state holds. SI
/// units.
#pragma once
#include "buildings/slider.h"

namespace rimpact::buildings {

/// One bearing in a state, forces on the building [N].
struct BearingResponse {
  Eigen::Vector3d u, v; ///< of the slider past the plate [m], [m/s]
  double height = 0;    ///< u_z at which it still stands on its surface [m]
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  double normal = 0, rim_force = 0, gap = 0;
  Eigen::Vector3d pendular = Eigen::Vector3d::Zero(), friction = Eigen::Vector3d::Zero(),
                  impact = Eigen::Vector3d::Zero();
  Eigen::Vector2d eta_rate = Eigen::Vector2d::Zero();
  Eigen::Vector2d interface_slip = Eigen::Vector2d::Zero(); ///< of a slider of two bodies [m]
  Eigen::Vector2d moment = Eigen::Vector2d::Zero(); ///< on the node above it, about x and y [N m]; rigid bodies only
  Eigen::Vector3d force() const { return pendular + friction + impact; }
};

/// An inelastic end section, moments right-handed about y.
struct HingeResponse {
  double moment, plastic_rotation;      ///< [N m], [rad]
  double ductility;                     ///< curvature over that at yield without an axial force, absolute [-]
  double strength_left, stiffness_left; ///< shares that wear has left [-]
};
struct MembersResponse {
  Eigen::VectorXd forces;            ///< twelve a member, as MemberForces has them; empty: linear ones
  std::vector<HingeResponse> hinges; ///< ends i and j of each member
};

struct BuildingResponse {
  Eigen::VectorXd acceleration;               ///< q'', relative to the ground
  Eigen::Vector3d ground;                     ///< a_g
  double ground_power = 0, damping_power = 0; ///< [W]
  std::vector<BearingResponse> bearings;
  MembersResponse members; ///< of inelastic ones
};

class BuildingBasis {
public:
  BuildingBasis(const BuildingModel &model, double gravity);
  virtual ~BuildingBasis() = default;

  int n_bearings() const { return static_cast<int>(slider.size()); }
  int n_state() const { return 2 * n + 2 * n_bearings() + n_works; }
  /// Where y keeps what: q, q', two friction states of each bearing, then the works below [J]. `contact`: taken by
  /// contact springs with dashpots, what is stored in them included; of the sliders' own bodies the energies; `strain`
  /// is what implicit steps know to be stored in the structure.
  enum Work {
    external,
    damping,
    friction,
    rim,
    contact,
    hysteretic,
    sliders_kinetic,
    sliders_potential,
    strain,
    n_works
  };
  int velocity() const { return n; }
  int eta(int b) const { return 2 * n + 2 * b; }
  int work(Work w) const { return 2 * n + 2 * n_bearings() + w; }

  double kinetic_energy(const Eigen::VectorXd &y) const;
  virtual double elastic_energy(const Eigen::VectorXd &y) const; ///< 1/2 q K q
  double potential_energy(const Eigen::VectorXd &y) const;       ///< of the weights

  const BuildingModel &model;
  std::vector<Slider> slider;
  std::vector<double> capacity, rim_stiffness; ///< of each bearing [m], [N/m]
  Eigen::VectorXd reactions;                   ///< static [N]
  double gravity, total_mass, weight;
  bool rigid_bodies = false; ///< bearings give interface slip and moments
  int n;                     ///< dofs
  const Eigen::VectorXd &at_rest() const { return start_; }

protected:
  Eigen::VectorXd start_; ///< at rest under its weight
};

} // namespace rimpact::buildings
