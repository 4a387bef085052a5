/// Correlation of the dimensions of a Latin hypercube.
#pragma once
#include <vector>

namespace rimpact::fleets {

/// Reorders each dimension of `points` ([sample][dimension], in (0, 1), no two equal in a dimension) so that
/// its normal scores have nearly `correlation` (Iman and Conover, Communications in Statistics B11, 1982).
/// The values of a dimension stay the same set, so every strip keeps its one point. Throws InputError where
/// the matrix is not square of the points' dimension, not symmetric with ones on the diagonal or not positive
/// definite. So it does where there are not more samples than dimensions.
std::vector<std::vector<double>> correlated(std::vector<std::vector<double>> points,
                                            const std::vector<std::vector<double>> &correlation);

} // namespace rimpact::fleets
