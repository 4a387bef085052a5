// FEMA P-695: against its own tables.
#include "studies/reliability/collapse_margin.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact::reliability;

namespace {

/// Tables 7-1a (B, C, least of D) and 7-1b (most of D): rows T = 0.5 to 1.5 s, columns mu_T.
constexpr double ductilities[] = {1, 1.1, 1.5, 2, 3, 4, 6, 8};
constexpr double low[11][8] = {
    {1.00, 1.02, 1.04, 1.06, 1.08, 1.09, 1.12, 1.14}, {1.00, 1.02, 1.05, 1.07, 1.09, 1.11, 1.13, 1.16},
    {1.00, 1.03, 1.06, 1.08, 1.10, 1.12, 1.15, 1.18}, {1.00, 1.03, 1.06, 1.08, 1.11, 1.14, 1.17, 1.20},
    {1.00, 1.03, 1.07, 1.09, 1.13, 1.15, 1.19, 1.22}, {1.00, 1.04, 1.08, 1.10, 1.14, 1.17, 1.21, 1.25},
    {1.00, 1.04, 1.08, 1.11, 1.15, 1.18, 1.23, 1.27}, {1.00, 1.04, 1.09, 1.12, 1.17, 1.20, 1.25, 1.30},
    {1.00, 1.05, 1.10, 1.13, 1.18, 1.22, 1.27, 1.32}, {1.00, 1.05, 1.10, 1.14, 1.19, 1.23, 1.30, 1.35},
    {1.00, 1.05, 1.11, 1.15, 1.21, 1.25, 1.32, 1.37}};
constexpr double high[11][8] = {
    {1.00, 1.05, 1.10, 1.13, 1.18, 1.22, 1.28, 1.33}, {1.00, 1.05, 1.11, 1.14, 1.20, 1.24, 1.30, 1.36},
    {1.00, 1.06, 1.11, 1.15, 1.21, 1.25, 1.32, 1.38}, {1.00, 1.06, 1.12, 1.16, 1.22, 1.27, 1.35, 1.41},
    {1.00, 1.06, 1.13, 1.17, 1.24, 1.29, 1.37, 1.44}, {1.00, 1.07, 1.13, 1.18, 1.25, 1.31, 1.39, 1.46},
    {1.00, 1.07, 1.14, 1.19, 1.27, 1.32, 1.41, 1.49}, {1.00, 1.07, 1.15, 1.20, 1.28, 1.34, 1.44, 1.52},
    {1.00, 1.08, 1.16, 1.21, 1.29, 1.36, 1.46, 1.55}, {1.00, 1.08, 1.16, 1.22, 1.31, 1.38, 1.49, 1.58},
    {1.00, 1.08, 1.17, 1.23, 1.32, 1.40, 1.51, 1.61}};

} // namespace

TEST(CollapseMargin, TheShapeFactorIsThatOfTheTables) {
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 8; ++j) {
      const double period = 0.5 + 0.1 * i;
      EXPECT_NEAR(spectral_shape_factor(period, ductilities[j], ShapeCategory::low), low[i][j], 0.005)
          << period << " s, " << ductilities[j];
      EXPECT_NEAR(spectral_shape_factor(period, ductilities[j], ShapeCategory::high), high[i][j], 0.005)
          << period << " s, " << ductilities[j];
    }
  EXPECT_EQ(spectral_shape_factor(0.1, 12, ShapeCategory::low), spectral_shape_factor(0.5, 8, ShapeCategory::low));
  EXPECT_EQ(spectral_shape_factor(4.0, 3, ShapeCategory::low), spectral_shape_factor(1.5, 3, ShapeCategory::low));
}

TEST(CollapseMargin, UncertaintiesAndMargins) {
  EXPECT_EQ(record_uncertainty(1), 0.2);
  EXPECT_DOUBLE_EQ(record_uncertainty(2.5), 0.35);
  EXPECT_EQ(record_uncertainty(8), 0.4);
  // sqrt(0.4^2 + 0.2^2 + 0.2^2 + 0.2^2) = 0.529; superior in all: 0.436
  EXPECT_NEAR(total_uncertainty(3, Rating::good, Rating::good, Rating::good), 0.525, 1e-12);
  EXPECT_NEAR(total_uncertainty(8, Rating::superior, Rating::superior, Rating::superior), 0.425, 1e-12);
  EXPECT_NEAR(total_uncertainty(8, Rating::poor, Rating::poor, Rating::poor), 0.95, 1e-12);
  // table 7-3
  EXPECT_NEAR(acceptable_margin(0.5, 0.10), 1.90, 0.005);
  EXPECT_NEAR(acceptable_margin(0.5, 0.20), 1.52, 0.005);
  EXPECT_NEAR(acceptable_margin(0.6, 0.10), 2.16, 0.005);
  EXPECT_NEAR(acceptable_margin(0.6, 0.20), 1.66, 0.005);
  EXPECT_NEAR(acceptable_margin(0.95, 0.10), 3.38, 0.005);
  EXPECT_EQ(acceptable_margin(0.7, 0.5), 1);
}
