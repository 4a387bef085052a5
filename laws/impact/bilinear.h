/// The plainest rim that yields, as handbooks of steel and most structural programs have it: k_i to the yield force
/// F_y, from there the tangent h k_i; back, and up again to the deepest penetration, along k_i. Rate-independent; dents
/// stay.
#pragma once

namespace rimpact::laws {

struct ImpactLaw;

/// Reads k_i [N/m], F_y [N] > 0 and h [-], 0..1, of the element (elastoplastic.h).
///   first loading   F = k_i d                         up to d_y = F_y / k_i
///                   F = F_y + h k_i (d - d_y)         beyond
///   back            F = F(D) - k_i (D - d)            from the deepest penetration D; lets go at F = 0
ImpactLaw bilinear_law();

} // namespace rimpact::laws
