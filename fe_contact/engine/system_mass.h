/// Masses of a system by equation: of its cells, and of the rigid bodies on it.
#pragma once
#include "fe_contact/engine/solid.h"
#include <optional>
#include <utility>
#include <vector>

namespace rimpact::fe {

class SystemMass {
public:
  /// `bodies`: first of three dofs, mass [kg].
  SystemMass(const Solid &solid, const Equations &equations, const std::vector<std::pair<int, double>> &bodies);
  /// [kg]
  const SymmetricMatrix &whole() const { return whole_; }
  /// Of this rank's share, which the tangents hold: its own cells', and on the first rank the bodies'.
  double own_diagonal(int equation) const { return own().diagonal(equation); }
  /// Finds the entries of a tangent that masses fall on, which must be among its own. Throws std::logic_error.
  void find_places(const SymmetricMatrix &tangent);
  /// Sets those entries of the tangent that was last looked at to `factor` times this rank's share.
  void put(double factor, SymmetricMatrix &tangent) const;

private:
  const SymmetricMatrix &own() const { return own_ ? *own_ : whole_; }
  SymmetricMatrix whole_;
  std::optional<SymmetricMatrix> own_; ///< none: one rank, the whole is its own
  std::vector<int> places_;            ///< of own()'s entries in the tangent
};

} // namespace rimpact::fe
