/// Stiffness of a straight elastic beam-column of 12 dofs: at each end (u_x, u_y, u_z, r_x, r_y, r_z), global axes.
/// Source: Przemieniecki (1968), ch. 5; phi = 12 E I / (G A_s L^2) carries the shear, 0 for Euler-Bernoulli.
#pragma once
#include "buildings/frame.h"

namespace rimpact::buildings {

using ElementMatrix = Eigen::Matrix<double, 12, 12>;
ElementMatrix beam_column_stiffness(const Section &section, const Eigen::Vector3d &from, const Eigen::Vector3d &to,
                                    const Eigen::Vector3d &up);

} // namespace rimpact::buildings
