// Fractiles of a sweep apart for every combination of some keys.
#include "studies/fleets/fractiles.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::fleets;

namespace {

/// Two bearings of two frictions at two levels; three runs each, of travel level x friction x (bearing a: 1, b: 10).
Table runs() {
  Table table;
  table.columns = {"device",
                   "reduced.mu_fast",
                   "variable.pga_g",
                   "status",
                   "reason",
                   "n_impacts",
                   "peak_displacement_m",
                   "peak_lateral_force_N",
                   "peak_impact_force_N"};
  for (const double share : {0.5, 1.0, 1.5}) // runs of one group do not stand together
    for (const double pga : {0.4, 0.2})
      for (const double mu : {0.05, 0.03})
        for (const char *device : {"b", "a"})
          table.rows.push_back({std::string(device), mu, pga, std::string("done"), std::string(), 0.0,
                                share * pga * mu * (*device == 'a' ? 1 : 10), 1.0, Cell{}});
  return table;
}

double number(const Table &table, std::size_t row, const std::string &column) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i] == column) return std::get<double>(table.rows[row][i]);
  ADD_FAILURE() << column;
  return 0;
}

} // namespace

TEST(FractilesBy, OneCurveForEachCombination) {
  const Table curves = fractiles(runs(), "variable.pga_g", {"device", "reduced.mu_fast"});
  EXPECT_EQ(curves.columns[0], "device");
  EXPECT_EQ(curves.columns[1], "reduced.mu_fast");
  EXPECT_EQ(curves.columns[2], "variable.pga_g");
  ASSERT_EQ(curves.rows.size(), 8u);
  std::size_t row = 0; // growing, the last key fastest
  for (const char *device : {"a", "b"})
    for (const double mu : {0.03, 0.05})
      for (const double pga : {0.2, 0.4}) {
        EXPECT_EQ(std::get<std::string>(curves.rows[row][0]), device);
        EXPECT_EQ(number(curves, row, "reduced.mu_fast"), mu);
        EXPECT_EQ(number(curves, row, "variable.pga_g"), pga);
        EXPECT_EQ(number(curves, row, "n_runs"), 3);
        EXPECT_NEAR(number(curves, row, "p50_peak_displacement_m"), pga * mu * (*device == 'a' ? 1 : 10), 1e-15);
        ++row;
      }
}

TEST(FractilesBy, OfNoKeyIsTheWholeSweep) {
  const Table together = fractiles(runs(), "variable.pga_g"), apart = fractiles(runs(), "variable.pga_g", {"device"});
  ASSERT_EQ(together.rows.size(), 2u);
  ASSERT_EQ(apart.rows.size(), 4u);
  EXPECT_EQ(number(together, 0, "n_runs"), number(apart, 0, "n_runs") + number(apart, 2, "n_runs"));
  EXPECT_THROW(fractiles(runs(), "variable.pga_g", {"isolator"}), std::logic_error);
}
