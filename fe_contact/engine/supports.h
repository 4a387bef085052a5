/// Says which dofs of a discretisation are held, tied together, or belong to rigid bodies in translation, and
/// numbers the equations.
#pragma once
#include "fe_contact/engine/discretisation.h"
#include "fe_contact/solver/equations.h"
#include <functional>

namespace rimpact::fe {

class Supports {
public:
  explicit Supports(const Discretisation &space)
      : space_(space), of_dof_(space.n_dofs(), unnumbered), weight_(space.n_dofs(), 1.0) {}

  /// Holds one component (0, 1, 2) of a group's nodes, or of all nodes where `where` is true.
  void fix(meshes::Surface group, int component);
  void fix(int component, const std::function<bool(const Eigen::Vector3d &)> &where);
  void fix(meshes::Volume volume); ///< all of a body
  /// One displacement for a group's nodes: a remote displacement's component. Returns its equation.
  int tie(meshes::Surface group, int component);
  int tie(int component, const std::function<bool(const Eigen::Vector3d &)> &where);
  /// Cuts of a sector, radial ones and one about the axis, move within themselves: no displacement along the cut's
  /// normal. After all that is fixed or tied there.
  void slide_on(meshes::Surface cuts);
  /// Adds a rigid body; returns the first of its three dofs.
  int add_body();
  void fix_dof(int dof) { of_dof_[dof] = -1; }
  /// Numbers what is left; may be called once.
  Equations number();

private:
  static constexpr int unnumbered = -2;
  const Discretisation &space_;
  std::vector<int> of_dof_;
  std::vector<double> weight_;
  int n_ = 0;
};

} // namespace rimpact::fe
