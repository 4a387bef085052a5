/// Frictional contact of a deformable body's faces with an exact surface: Gauss points of the slave faces
/// against the signed distance. The surface may be carried by a rigid body in translation, whose three dofs
/// stand behind the nodes' ones in the equations (see Equations). Or the displacement of a deformable body's faces
/// carries it (see MasterFaces), which must not turn by large angles. Slip is measured along the surface from the
/// step's start, in the carrier's reference configuration: sliding may be as long as it likes, and friction goes
/// from face to face without being handed over.
#pragma once
#include "fe_contact/engine/augmentation.h"
#include "fe_contact/engine/contact_search.h"
#include "fe_contact/engine/face_pair.h"
#include "fe_contact/engine/surface_contact_report.h"
#include "fe_contact/engine/surface_contact_state.h"
#include "fe_contact/solver/tangent.h"
#include <utility>

namespace rimpact::fe {

class SurfaceContact {
public:
  SurfaceContact(const Discretisation &space, meshes::Surface slave, MasterSurface master,
                 const SurfaceContactOptions &options)
      : law_(options.law), degree_(space.degree), search_(space, slave, std::move(master), options) {}

  SurfaceContactState open(const Eigen::VectorXd &u) const;
  /// With the multipliers that the same points had on another mesh, where they are opposite this one's master at u;
  /// what they bear follows with the next solution. Throws std::invalid_argument where they are not as many.
  SurfaceContactState carried(const SurfaceContactState &other, const Eigen::VectorXd &u) const;
  /// See ContactSearch::couplings.
  Couplings couplings(const Equations &equations, const Eigen::VectorXd &u, const std::vector<int> &opposite) {
    return search_.couplings(equations, u, opposite);
  }
  /// Adds (internal-sign) contact forces and the tangent at dof displacements u; fills `state`'s results. With several
  /// ranks forces and tangent are those of this rank's faces, to be summed up; state and report are whole.
  SurfaceContactReport assemble(const Eigen::VectorXd &u, SurfaceContactState &state, double dt,
                                const Equations &equations, Eigen::VectorXd &forces, Tangent *tangent) const;
  Augmentation augmentation(const SurfaceContactState &state) const {
    return fe::augmentation(search_, law_, degree_, state);
  }
  /// Where a point is at a step's end.
  struct Place {
    Eigen::Vector3d y; ///< relative to the carrier [m]
    bool settled;      ///< within the carrier's face that it was last found opposite
  };
  std::vector<Place> places(const Eigen::VectorXd &u, const SurfaceContactState &state) const;
  /// Work of the step from `before` to `after`, both evaluated; places of `after`.
  void add_work(const SurfaceContactState &before, const SurfaceContactState &after, const std::vector<Place> &places,
                SurfaceContactReport &report) const;
  /// Ends a step at u: friction becomes the multiplier, the state's places the next step's start.
  void commit(const Eigen::VectorXd &u, const std::vector<Place> &places, SurfaceContactState &state,
              const Renewal &renewal) const;

  const ContactSearch &search() const { return search_; }
  /// One entry a point: where it is and what acts there.
  struct Sample {
    Eigen::Vector3d position, friction;
    double area, pressure, gap;
  };
  std::vector<Sample> samples(const Eigen::VectorXd &u, const SurfaceContactState &state) const;
  /// Pressure [Pa] and gap [m] averaged to the slave faces' nodes, for pictures; other nodes are left alone.
  void nodal_fields(const SurfaceContactState &state, std::vector<double> &pressure, std::vector<double> &gap) const {
    average_to_nodes(search_.points(), search_.faces(), state.pressure, pressure);
    average_to_nodes(search_.points(), search_.faces(), state.gap, gap);
  }
  CoulombContact &law() { return law_; }
  const CoulombContact &law() const { return law_; }

private:
  /// Of one slave face: faces are independent of one another, and are assembled by several threads.
  struct FaceResult {
    SurfaceContactReport report;
    std::vector<FacePair> pairs;
  };
  FaceResult assemble_face(std::size_t f, const CoulombContact &law, const Eigen::VectorXd &u,
                           SurfaceContactState &state, double dt, bool with_stiffness) const;
  /// Of the faces: where each rank's begin, so that all have as much to do. Before the state is written over.
  std::vector<std::size_t> shares_of_ranks(const SurfaceContactState &state) const;
  void all_gather(std::vector<std::size_t> offsets, SurfaceContactState &state) const;
  void update_active(std::size_t k, const Eigen::VectorXd &u, SurfaceContactState &state) const;

  CoulombContact law_;
  int degree_; ///< of the shape functions
  ContactSearch search_;
};

} // namespace rimpact::fe
