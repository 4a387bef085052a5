/// Frictional contact of a deformable body's faces with an exact surface: Gauss points of the slave faces
/// against the signed distance. The surface may be carried by a rigid body in translation, whose three dofs
/// stand behind the nodes' ones in the equations (see Equations). Or the displacement of a deformable body's faces
/// carries it (see MasterFaces), which must not turn by large angles. Slip is measured along the surface from the
/// step's start, in the carrier's reference configuration: sliding may be as long as it likes, and friction goes
/// from face to face without being handed over.
///
/// More Gauss points than a face has room for would over-constrain it if each had a multiplier of its own: the
/// pressures oscillate (the inf-sup condition fails). Multipliers are therefore the tractions' least-squares
/// fit over a face's active points, bilinear for Q2 and constant for Q1; the penalty sees every point.
#pragma once
#include "fe_contact/engine/discretisation.h"
#include "fe_contact/engine/face_points.h"
#include "fe_contact/engine/master_faces.h"
#include "fe_contact/laws/coulomb.h"
#include "fe_contact/laws/master_surface.h"
#include "fe_contact/solver/equations.h"
#include "fe_contact/solver/tangent.h"
#include <limits>
#include <optional>

namespace rimpact::fe {

struct SurfaceContactOptions {
  CoulombContact law;
  int points = 4;       ///< Gauss points a direction and slave face
  int carrier_dof = -1; ///< first of the rigid carrier's three dofs; -1: the surface stands still
  std::optional<meshes::Surface> carrier_faces{}; ///< or: whose displacement carries the surface
  double margin = 0.01;                           ///< pairs of faces nearer than this are coupled in the matrix [m]
};

/// Per slave point; trial/committed by the caller.
struct SurfaceContactState {
  std::vector<double> multiplier;          ///< normal [Pa]
  std::vector<Eigen::Vector3d> tangential; ///< friction multiplier [Pa]
  std::vector<Eigen::Vector3d> start;      ///< position relative to the carrier at the step's start [m]
  std::vector<double> gap, pressure;       ///< at the last evaluation [m], [Pa]
  std::vector<Eigen::Vector3d> friction;   ///< [Pa]
  /// The friction by the slip as it is measured, in the carrier's reference configuration: F^T friction [Pa].
  std::vector<Eigen::Vector3d> pulled_back;
  std::vector<ContactStatus> status;
  /// Opposite the master, not past its edge; settled once a step, so that Newton does not chatter: within a step
  /// a point that crosses the edge sees the surface go on.
  std::vector<char> covered;
  std::vector<int> opposite; ///< carrier face last found opposite, -1: none
  /// Overlap with which a point came over a free edge [m], >= 0: what it bears is measured from there. It is given up
  /// along the point's path over the master, by its own width, as the area that it stands for comes over the edge.
  std::vector<double> entry;
  double stiffening = 1;        ///< factor on the stated penalties where augmentation alone was slow
  std::vector<double> change{}; ///< of the pressures over the last step [Pa]; empty: none yet
  void note_change(const std::vector<double> &pressures_before);
};

/// What the normal multipliers are for the next step: none (a penalty's conservative spring), those of the next
/// augmentation, or those the step was solved with: where augmentation was broken off the next ones would be a jolt.
enum class NextMultipliers { none, augmented, same };

struct Renewal {
  NextMultipliers normal = NextMultipliers::augmented;
  double share = 1; ///< of the way to the augmented multipliers, in a step too short for the whole
};

struct SurfaceContactReport {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();               ///< on the body [N]
  Eigen::Vector3d friction = Eigen::Vector3d::Zero();            ///< its tangential tractions' part [N]
  double smallest_gap = std::numeric_limits<double>::infinity(); ///< [m]
  double penetration = 0;                                        ///< largest, pointwise [m]
  double largest_pressure = 0;                                   ///< [Pa]
  int stick = 0, slip = 0;                                       ///< points
  int lost = 0; ///< points opposite the master at the step's start and still on its surface for which no face is found:
                ///< what they bear is missing
  double normal_work = 0, friction_work = 0;   ///< taken up since the step's start, trapezoidal [J]
  bool pattern_holds = true;                   ///< false: a pair of faces is not in the matrix's pattern
  void add(const SurfaceContactReport &other); ///< of other points, all but the works
};

class SurfaceContact {
public:
  SurfaceContact(const Discretisation &space, meshes::Surface slave, MasterSurface master,
                 const SurfaceContactOptions &options);

  SurfaceContactState open(const Eigen::VectorXd &u) const;
  /// With the multipliers that the same points had on another mesh, where they are opposite this one's master at u;
  /// what they bear follows with the next solution. Throws std::invalid_argument where they are not as many.
  SurfaceContactState carried(const SurfaceContactState &other, const Eigen::VectorXd &u) const;
  /// Equations coupled by each slave face and what is opposite or near it at dof displacements u; the pairs are
  /// remembered as those the pattern holds. `opposite`: the state's, where the search begins.
  std::vector<std::vector<int>> couplings(const Equations &equations, const Eigen::VectorXd &u,
                                          const std::vector<int> &opposite);
  /// Adds (internal-sign) contact forces and the tangent at dof displacements u; fills `state`'s results. With several
  /// ranks forces and tangent are those of this rank's faces, to be summed up; state and report are whole.
  SurfaceContactReport assemble(const Eigen::VectorXd &u, SurfaceContactState &state, double dt,
                                const Equations &equations, Eigen::VectorXd &forces, Tangent *tangent) const;
  /// lambda <- lambda + times * the pressure's last change, not below 0, where a point bears. The gap left is then the
  /// pressure's second difference over the penalty and not its first, which would give back the integral of (dp)^2 /
  /// eps over an impact: energy from nothing, in proportion to the step.
  static void expect(SurfaceContactState &state, double times);
  /// Multipliers of the next augmentation, and how far they are from the present ones over the penalty: the
  /// gap and the stick's slip, in the multipliers' sense, that are left [m].
  struct Augmentation {
    std::vector<double> multiplier;
    std::vector<Eigen::Vector3d> tangential;
    double gap_left = 0, slip_left = 0;
  };
  Augmentation augmentation(const SurfaceContactState &state) const;
  /// Work of the step from `before` to `after`, both evaluated.
  void add_work(const SurfaceContactState &before, const SurfaceContactState &after, const Eigen::VectorXd &u,
                SurfaceContactReport &report) const;
  /// Ends a step at u: friction becomes the multiplier, positions the next step's start.
  void commit(const Eigen::VectorXd &u, SurfaceContactState &state, const Renewal &renewal) const;

  /// Mean stiffness of the faces' nodes over their area [Pa/m], from the diagonal of the solid's stiffness (of this
  /// rank).
  double stiffness_per_area(const Equations &equations, const Eigen::VectorXd &diagonal) const;
  /// Shortest time until an open point touches at dof velocities v [s]; infinity when none closes.
  double time_to_touch(const Eigen::VectorXd &u, const Eigen::VectorXd &v, const std::vector<int> &opposite) const;

  /// One entry a point: where it is and what acts there.
  struct Sample {
    Eigen::Vector3d position, friction;
    double area, pressure, gap;
  };
  std::vector<Sample> samples(const Eigen::VectorXd &u, const SurfaceContactState &state) const;
  /// Pressure [Pa] and gap [m] averaged to the slave faces' nodes, for pictures; other nodes are left alone.
  void nodal_fields(const SurfaceContactState &state, std::vector<double> &pressure, std::vector<double> &gap) const {
    average_to_nodes(points_, faces_, state.pressure, pressure);
    average_to_nodes(points_, faces_, state.gap, gap);
  }
  SurfaceContactOptions &options() { return options_; }
  const SurfaceContactOptions &options() const { return options_; }

private:
  /// How far past a free edge a point that crosses it within the step still sees the surface [half widths of a face].
  static constexpr double reach_past_edges = 0.5;
  /// The nodes a point couples, with the derivatives of their weights by (xi, eta) of the carrier's face.
  struct Coupling {
    static constexpr int most = 2 * FaceShapes::max_nodes;
    Eigen::Vector3d y;                                                     ///< relative position [m]
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();                 ///< dy/dw, w = sum of N u
    Eigen::Matrix<double, 2, 3> dxi = Eigen::Matrix<double, 2, 3>::Zero(); ///< d(xi, eta)/dw
    Eigen::Vector3d second[3]; ///< of the carrier's displacement by (xi, eta), see Opposite
    int n = 0, carrier_face = -1;
    int dofs[most];
    double N[most], dN[most][2];
    bool inside = true;
    void add(int dof, double value, double by_xi = 0, double by_eta = 0) {
      dofs[n] = dof;
      N[n] = value;
      dN[n][0] = by_xi;
      dN[n++][1] = by_eta;
    }
  };
  /// Of the faces: where each rank's begin, so that all have as much to do. Before the state is written over.
  std::vector<std::size_t> shares_of_ranks(const SurfaceContactState &state) const;
  void all_gather(std::vector<std::size_t> offsets, SurfaceContactState &state, SurfaceContactReport &report) const;
  Eigen::Vector3d position(const FacePoint &point, const Eigen::VectorXd &u) const;
  /// Empty where nothing is opposite.
  std::optional<Coupling> couple(std::size_t k, const Eigen::VectorXd &u, int guess, double beyond) const;
  /// Relative position by the present opposite, else by the carrier's rough displacement.
  Eigen::Vector3d relative_position(std::size_t k, const Eigen::VectorXd &u, const SurfaceContactState &state) const;
  void update_active(const Eigen::VectorXd &u, SurfaceContactState &state) const;
  /// Whether a point for which no face is found may be on the master's surface, judged by the face last opposite.
  bool is_candidate(std::size_t k, const Eigen::VectorXd &u, int opposite) const;
  /// The master's distance where a point is, on the deformed carrier. The gap's gradient by w, nu, has the length
  /// `stretch`; it changes with w and, w held, with the carrier's own strain.
  struct Carried {
    double gap;                       ///< [m]
    Eigen::Vector3d normal, gradient; ///< unit; d gap / d w
    Eigen::Matrix3d curvature;        ///< d normal / d w [1/m]
    Eigen::Vector3d nu = Eigen::Vector3d::Zero();
    double stretch = 1;
  };
  Carried pushed_forward(const Coupling &coupling) const;
  /// Tangents of a traction by w and by nu.
  struct Tangents {
    Eigen::Matrix3d by_w, by_nu = Eigen::Matrix3d::Zero();
  };
  template <int n>
  static CoulombContact::Result<double> differentiate(const CoulombContact &law, const Carried &d,
                                                      const Eigen::Vector3d &slip, const Eigen::Matrix3d &pull_back,
                                                      double multiplier, const Eigen::Vector3d &tangential, double dt,
                                                      Tangents &tangents);
  /// Forces and stiffness of a pair of faces by their nodes: the points of a pair are summed up before any of them
  /// looks for its place in the matrix, which is what assembling contact costs.
  struct Pair {
    int carrier_face = -1;
    std::vector<int> dofs{}; ///< first of each node's three; empty: nothing summed up
    Eigen::VectorXd forces{};
    Eigen::MatrixXd stiffness{};
  };
  /// Of one slave face: faces are independent of one another, and are assembled by several threads.
  struct FaceResult {
    SurfaceContactReport report;
    std::vector<Pair> pairs;
  };
  FaceResult assemble_face(std::size_t f, const CoulombContact &law, const Eigen::VectorXd &u,
                           SurfaceContactState &state, double dt, bool with_stiffness) const;
  static void add_to(Pair &pair, const Coupling &coupling, double area, const Eigen::Vector3d &traction,
                     const Tangents &D, const Eigen::Vector3d &nu, bool with_stiffness);
  static void flush(const Pair &pair, const Equations &equations, Eigen::VectorXd &forces, Tangent *tangent);

  const Discretisation &space_;
  MasterSurface master_;
  SurfaceContactOptions options_;
  std::vector<const Face *> faces_;
  std::vector<FacePoint> points_;
  std::optional<MasterFaces> carrier_;
  std::vector<std::vector<int>> pairs_; ///< carrier faces in the pattern, by slave face, sorted
};

} // namespace rimpact::fe
