/// Nonlinear elimination (Lanzkron, Rose and Wilkes 1996; Cai and Li 2011): a few cells of an edge that turn from
/// loading to unloading keep Newton's residual up, and shortening the step of the whole mesh for them wastes it. Their
/// equations are solved by themselves first, all others held. In them the solids are as they are; what else acts there,
/// contact, masses and springs, goes on along the whole tangent.
#pragma once
#include "fe_contact/engine/solid.h"
#include "fe_contact/solver/tangent.h"

namespace rimpact::fe {

class NonlinearElimination {
public:
  /// Keeps references.
  NonlinearElimination(const Solid &solid, const Equations &equations);

  /// A solution under way, evaluated with its tangent.
  struct Stand {
    const Eigen::VectorXd &residual; ///< [N]
    const Tangent &tangent;
    const SolidHistory &old;      ///< at the step's start
    double dt;                    ///< of the step [s]
    const std::vector<int> &held; ///< equations that are left as they are
  };
  /// Moves u, by equation, where the residual is largest, until little of it is left there. False, u as it was: the
  /// residual is spread too far, or it did not fall.
  bool solve(Eigen::VectorXd &u, const Stand &stand) const;

private:
  struct Block; ///< the equations and the cells that have a part in them
  Block block(const Stand &stand) const;
  bool assemble(const Block &block, const Eigen::VectorXd &u, const Stand &stand, Eigen::VectorXd &forces,
                Eigen::MatrixXd &stiffness) const;

  const Solid &solid_;
  const Equations &equations_;
  std::vector<std::vector<int>> equations_of_cell_;
  mutable SolidHistory scratch_; ///< of the cells' points at the step's end, which nobody asks for
};

} // namespace rimpact::fe
