/// Whether a joint at the rim's foot bears what the solids carry through it. EN 1993-1-8:2005, static design values.
///
/// Fillet welds on both faces of a wall of thickness t (4.5.3.3, the simplified method): each takes half of the normal
/// force and of the shears, and the moment as a couple over t; nothing is pressed past them,
///   f = sqrt((|N| / 2 + |M| / t)^2 + (V / 2)^2 + (T / 2)^2),   use = f / (a f_u / (sqrt(3) beta_w gamma_M2)).
/// Bolts (table 3.4), pitch s, the wall tipping about the edge it is pressed on, at a distance z from the bolts:
///   F_t = s max(0, |M| + N t / 2) / z,   F_v = s sqrt(V^2 + T^2),
///   use = max(F_t / F_tRd, F_v / F_vRd + F_t / (1.4 F_tRd)),  F_tRd = 0.9 f_ub A_s / gamma_M2,
///   F_vRd = alpha_v f_ub A_s / gamma_M2 (the thread in the shear plane).
/// Left out: prying, friction of what is pressed together, bearing of the bolts' holes, fatigue, the steel's rate.
/// SI units; a joint goes at a use of 1.
#pragma once
#include "scene/bearing.h"
#include <optional>

namespace rimpact {

/// What the wall does to the plate per length of the foot, about the middle of the wall's thickness.
struct FootLine {
  double normal = 0; ///< [N/m], > 0 lifts the wall
  double shear = 0;  ///< radial [N/m], > 0 outwards
  double along = 0;  ///< along the rim [N/m]
  double moment = 0; ///< [N], > 0 tips the wall outwards
};

/// Largest force of one of two fillet welds per length [N/m].
double weld_force(const FootLine &line, double thickness);
/// What a fillet of throat 1 bears per length [Pa].
double weld_strength(const scene::RimConnection &connection);
/// Of the bearing's joint [-]; none: the rim is one piece with its plate.
std::optional<double> foot_use(const scene::Bearing &bearing, const FootLine &line);
/// Length of the foot that one piece of the joint works over [m]: a bolt's pitch, else the wall's thickness, over which
/// a weld that yields spreads its peak (an assumption).
double foot_reach(const scene::Bearing &bearing);

} // namespace rimpact
