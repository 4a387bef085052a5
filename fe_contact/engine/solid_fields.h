/// What pictures and summaries show of a solid's state, by cell.
#pragma once
#include "fe_contact/engine/solid.h"
#include <array>

namespace rimpact::fe {

/// Cell averages for pictures.
struct SolidFields {
  std::vector<double> plastic_strain;        ///< [-] largest over the cell's points
  std::vector<double> damage;                ///< the same
  std::array<std::vector<double>, 6> stress; ///< Cauchy, mean over the points: xx, yy, zz, xy, yz, zx [Pa]
  std::vector<double> von_mises;             ///< of that mean stress [Pa]: below that of the cell's hardest point
};
SolidFields fields_of(const Solid &solid, const Discretisation &space, const Eigen::VectorXd &u,
                      const SolidHistory &history);
double largest_plastic_strain(const SolidHistory &history); ///< equivalent [-]

} // namespace rimpact::fe
