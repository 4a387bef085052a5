/// Elastoplastic solids on a discretisation: internal forces, tangent, energies, consistent mass. Total
/// Lagrangian; isochoric part at the full quadrature, volumetric part at the reduced one (selective reduction
/// keeps Q2 and Q1 from locking where the steel flows, and stays symmetric). Memory is trial/committed: `old`
/// in, `next` out.
#pragma once
#include "fe_contact/engine/cell_answers.h"
#include "fe_contact/engine/discretisation.h"
#include "fe_contact/engine/kept_tangents.h"
#include "fe_contact/laws/crack_measure.h"
#include "fe_contact/laws/pad_loss.h"
#include "fe_contact/solver/equations.h"
#include "fe_contact/solver/symmetric_matrix.h"
#include "scene/bearing.h"
#include <map>
#include <span>

namespace rimpact::fe {

/// States of all material points, [cell][full point].
using SolidHistory = std::vector<J2State>;

/// Of one volume.
struct SolidLaw {
  HenckyJ2 isochoric;
  HenckyVolumetric volumetric;
  CrackMeasure crack;
  double density;    ///< [kg/m^3]
  PadLoss loss = {}; ///< of a material that never yields

  IsochoricResult step(const J2State &old, const Matrix3 &F, double dt, bool with_tangent) const {
    return loss.none() ? isochoric.step(old, F, dt, with_tangent)
                       : loss.step(isochoric, volumetric, old, F, dt, with_tangent);
  }
  /// Isochoric Kirchhoff stress of a committed state: nothing flows, overstress stays, the pad's dashpot bears nothing
  /// [Pa]; `resting`: isochoric.at_rest().
  Vector6 stress_at_rest(const HenckyJ2 &resting, const J2State &state, const Matrix3 &F) const;
};

/// A cell's internal forces and tangent by its own dofs, node by node.
struct CellResponse {
  Eigen::VectorXd forces;    ///< [N]
  Eigen::MatrixXd stiffness; ///< [N/m]
};

class Solid {
public:
  /// All volumes of a bearing's mesh are steel, each that of its part, but the pad (Ertalyte).
  /// `pad_retardation`: theta of PadLoss [s].
  Solid(const Discretisation &space, const scene::Bearing &bearing, double pad_retardation = 0);
  Solid(const Discretisation &space, const std::map<meshes::Volume, scene::Material> &materials);

  SolidHistory initial_history() const { return SolidHistory(space_.n_cells * space_.full.n_points); }
  /// Coupled sets of equations, one a cell.
  Couplings couplings(const Equations &equations) const;
  /// Of the cells whose tangent is this rank's.
  Couplings own_couplings(const Equations &equations) const;

  /// Adds internal forces at dof displacements u to `forces` (equations) and, when given, the tangent. dt: from old to
  /// next [s]; 0: infinitely slow.
  /// False when a point is inadmissible (inverted): the step must be cut. A cell whose dofs are all held has no
  /// part in it: its history is kept, its energy not counted. With several ranks the tangent and the history are those
  /// of this rank's cells alone; all else is whole. `answers`: of the same step, its `old`, its `dt` and its `next`,
  /// which then has to be as it was left.
  bool assemble(const Eigen::VectorXd &u, const SolidHistory &old, SolidHistory &next, const Equations &equations,
                Eigen::VectorXd &forces, SymmetricMatrix *tangent, SolidEnergies &energies, double dt = 0,
                CellAnswers *answers = nullptr) const;
  /// The history of each rank's cells goes to all the others: once a step, where the trial becomes the state.
  void all_gather(SolidHistory &history, const Equations &equations) const;
  /// Of one cell by itself at dof displacements u; writes its points of `next`. False: a point is inadmissible.
  bool assemble_cell(std::size_t cell, const Eigen::VectorXd &u, const SolidHistory &old, SolidHistory &next, double dt,
                     CellResponse &response) const;
  /// What a cell's dof has of its equation, see Equations.
  double weight_of(std::size_t cell, std::size_t dof, const Equations &equations) const {
    return equations.weight[3 * space_.cell_nodes[cell * space_.nodes_per_cell + dof / 3] + dof % 3];
  }
  /// Of all cells, or of those whose tangent is this rank's.
  SymmetricMatrix mass(const Equations &equations) const;
  SymmetricMatrix own_mass(const Equations &equations) const;
  /// Mass of one volume [kg].
  double mass_of(meshes::Volume volume) const;
  /// Makes every cell's tangent anew at the next assembly.
  void forget_tangents() const { kept_.forget(); }
  const SolidLaw &law_of(std::size_t cell) const { return laws_.at(space_.volumes[cell]); }

private:
  /// What a cell's points answer with.
  struct Answer {
    bool admissible = false, flows = false;
    SolidEnergies energies;
  };
  /// Into the kernel, at the deformation gradients of the cell's full points, which have the kernel's displacements.
  template <int n>
  Answer answer(std::size_t cell, const std::array<Matrix3, n> &F, const SolidHistory &old, SolidHistory &next,
                double dt, CellKernel<n> &kernel, bool with_tangent) const;
  template <int n> void set_displacements(std::size_t cell, const Eigen::VectorXd &u, CellKernel<n> &kernel) const;
  /// Deformation gradients of the cell's full points, as many as it has nodes.
  template <int n> std::array<Matrix3, n> deformation_gradients(std::size_t cell, const CellKernel<n> &kernel) const;
  template <int n>
  bool assemble_one(std::size_t cell, const Eigen::VectorXd &u, const SolidHistory &old, SolidHistory &next, double dt,
                    CellResponse &response) const;
  /// Plastic work of a cell's points that the hardening curve does not know [J].
  double work_beside_the_curve(std::size_t cell, const SolidHistory &history) const;
  /// Adds what the step did to the steel of a cell that flows; `mises`, `mean`: Kirchhoff stresses at its full points
  /// and at its reduced ones [Pa].
  void remember(std::size_t cell, const SolidHistory &old, SolidHistory &next, const double *mises,
                const double *mean) const;
  template <int n>
  bool assemble_cells(const unsigned *begin, const unsigned *end, const Eigen::VectorXd &u, const SolidHistory &old,
                      SolidHistory &next, double dt, const Equations &equations, Eigen::VectorXd &forces,
                      const std::vector<int> *places, double *tangent, SolidEnergies &energies,
                      CellAnswers &answers) const;
  /// The cell's answer at the kernel's displacements, kept or made now; its tangent is then among the kept ones. Null:
  /// inadmissible.
  template <int n>
  const CellAnswers::Cell *recall_or_make(std::size_t cell, const SolidHistory &old, SolidHistory &next, double dt,
                                          CellKernel<n> &kernel, bool with_tangent, CellAnswers &answers) const;
  std::vector<int> equations_of(std::size_t cell, const Equations &equations) const; ///< by its dofs, -1: held
  std::vector<unsigned> moving_cells(const Equations &equations) const;              ///< with a dof that is not held
  std::vector<unsigned> own_cells(const Equations &equations) const;                 ///< this rank's share of them
  SymmetricMatrix mass(std::span<const unsigned> cells, const Equations &equations) const;
  const std::vector<int> &places_in(const SymmetricMatrix &matrix, const Equations &equations) const;

  const Discretisation &space_;
  std::map<meshes::Volume, SolidLaw> laws_;
  // Assembly keeps what the next one can use, so that one solid is assembled by one caller at a time.
  /// Where each local pair (i <= j) of each cell goes in the matrix; made once per pattern.
  mutable std::vector<int> places_;
  mutable std::vector<char> plain_; ///< cells whose dofs are equations each of their own, weight 1, or interpolated
  mutable long places_of_ = 0;      ///< pattern_id
  mutable KeptTangents kept_;
  mutable std::vector<std::vector<double>>
      part_values_; ///< of the tangent, by thread; kept, for making them anew costs as much as filling them
};

} // namespace rimpact::fe
