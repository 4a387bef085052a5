/// Frictionless augmented-Lagrangian contact between two deformable walls: Gauss points of the slave faces
/// against the closest points of the master faces. Both are quadratic faces with their nodes on the exact
/// surfaces, so undeformed cylinders are exact to about 1e-9 m. Pairing is found anew at every evaluation.
#pragma once
#include "fe_contact/laws/normal_contact.h"
#include "fe_contact/model/discretisation.h"
#include "fe_contact/model/face_points.h"
#include "fe_contact/solver/equations.h"
#include "fe_contact/solver/symmetric_matrix.h"

namespace rimpact::fe {

struct ContactOptions {
  NormalContact law{4e13};     ///< penalty [Pa/m]; see default_penalty
  double gap_tolerance = 1e-6; ///< penetration left after augmentation [m]
  int points = 4;              ///< Gauss points a direction and slave face
  double margin = 0.006;       ///< pairs nearer than this are coupled in the pattern [m]
};
/// Penalty from the softer side: E / h, h the size of the wall's cells [Pa/m].
double default_penalty(double softer_E, double cell_size);

/// Per slave point. `multiplier` is trial/committed by the caller; gap and pressure are those of the last
/// evaluation.
struct ContactState {
  std::vector<double> multiplier; ///< [Pa]
  std::vector<double> gap;        ///< [m]; `no_gap` where nothing is opposite
  std::vector<double> pressure;   ///< [Pa]
  /// Opposite the master wall, not past its free edge. Settled once a step: a point that crosses the edge
  /// within a step sees the extended face until the step ends, so that Newton does not chatter between two
  /// states.
  std::vector<char> on_wall;
};
constexpr double no_gap = 1.0;

struct ContactReport {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< on the slave [N]
  double smallest_gap = no_gap;                    ///< over all points [m]
  double largest_pressure = 0;                     ///< [Pa]
  double penetration = 0;                          ///< largest |g| where p > 0 [m]
  int active = 0;                                  ///< points in contact
  bool pattern_holds = true; ///< false: a pair is outside the matrix pattern, rebuild it
};

class WallContact {
public:
  WallContact(const Discretisation &space, meshes::Surface slave, meshes::Surface master,
              const ContactOptions &options);

  ContactState open() const;
  /// Cliques of every pair of faces within the margin at displacements u.
  std::vector<std::vector<int>> cliques(const Eigen::VectorXd &u, const Equations &equations) const;

  /// Adds contact forces (and tangent) at u; fills gap and pressure of `state`.
  ContactReport assemble(const Eigen::VectorXd &u, ContactState &state, const Equations &equations,
                         Eigen::VectorXd *forces, SymmetricMatrix *tangent) const;
  /// Decides anew which points are opposite the wall.
  void settle_edges(const Eigen::VectorXd &u, ContactState &state) const;
  /// lambda <- p at every point.
  static void augment(ContactState &state) { state.multiplier = state.pressure; }
  /// lambda <- lambda + change, not below 0, where a point bears; an empty `change` leaves them. With the change of the step
  /// before, the gap left is the pressure's second difference over the penalty and not its first. The first would give back
  /// the integral of (dp)^2 / epsilon over an impact: energy from nothing, in proportion to the step.
  static void expect(ContactState &state, const std::vector<double> &change);
  /// Energy taken up by the contact between two states, trapezoidal in -p dg [J].
  double work(const ContactState &before, const ContactState &after) const;
  /// Pressure averaged to the slave faces' nodes, and the gap, for pictures [Pa], [m].
  void nodal_fields(const ContactState &state, std::vector<double> &pressure, std::vector<double> &gap) const;
  const ContactOptions &options() const { return options_; }

private:
  struct MasterFace {
    const Face *face;
    bool open_edge[4]; ///< xi = -1, xi = +1, eta = -1, eta = +1 border no other master face
  };
  struct Pair {
    const MasterFace *master = nullptr;
    Projection projection;
  };
  FaceNodes nodes_at(const Face &face, const Eigen::VectorXd &u) const;
  Pair find(const Eigen::Vector3d &x, const std::vector<const MasterFace *> &near,
            const std::vector<FaceNodes> &nodes, double beyond_edges) const;
  std::vector<FaceNodes> master_nodes(const Eigen::VectorXd &u) const;
  Eigen::Vector3d position(const FacePoint &point, const FaceNodes &nodes) const;
  std::vector<std::vector<const MasterFace *>> near_faces(const Eigen::VectorXd &u, double margin) const;
  bool add_point(const FacePoint &point, const Face &slave, const Pair &pair, const Eigen::Vector3d &normal,
                 double gap, const NormalContact::Result &law, const Equations &equations,
                 Eigen::VectorXd &forces, SymmetricMatrix *tangent) const;

  const Discretisation &space_;
  ContactOptions options_;
  std::vector<const Face *> slaves_;
  std::vector<MasterFace> masters_;
  std::vector<FacePoint> points_;
};

} // namespace rimpact::fe
