#include "calibration/laws/windows_table.h"
#include "laws/impact/catalogue.h"
#include "synthetic.h"
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

TEST(KelvinVoigt, PeakFactorAgainstTheThesisNotes) {
  EXPECT_NEAR(laws::kelvin_voigt_peak(0.65), 0.853, 5e-4);
  EXPECT_DOUBLE_EQ(laws::kelvin_voigt_peak(1.0), 1.0);
  EXPECT_LT(laws::kelvin_voigt_peak(0.42), laws::kelvin_voigt_peak(0.32)); // minimum near 0.42 (notes, 7)
  EXPECT_LT(laws::kelvin_voigt_peak(0.42), laws::kelvin_voigt_peak(0.52));
}

TEST(WindowsTable, FindsTheRangeOfAConstantPair) {
  // a rim that softens with speed, as yielding ones do
  std::vector<StoredRun> runs;
  for (const double v : {0.5, 0.05, 0.1, 0.2, 1.0})
    runs.push_back(run_of(window(v, 3e8 * std::pow(v / 0.2, -0.4), 0.5)));
  std::vector<const StoredRun *> all;
  for (const auto &run : runs) all.push_back(&run);
  FitResult pair;
  pair.parameters["k_i"].value = 3e5;
  pair.parameters["e"].value = 0.5;
  const auto table = windows_table(all, pair, {}, 0.10);
  ASSERT_EQ(table.rows.size(), 5u);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto &row = table.rows[i];
    if (i > 0) {
      EXPECT_GT(row.speed, table.rows[i - 1].speed);
    }
    const double k = 3e8 * std::pow(row.speed / 0.2, -0.4);
    EXPECT_NEAR(row.own.parameters.at("k_i").value * 1e3 / k, 1, 1e-5);
    EXPECT_NEAR(row.own.parameters.at("e").value, 0.5, 1e-5);
    EXPECT_NEAR(*row.k_from_peak / k, 1, 2e-3); // independent closed forms
    EXPECT_NEAR(*row.k_from_contact_time / k, 1, 1e-4);
    EXPECT_NEAR(row.normalised_force, laws::kelvin_voigt_peak(0.5) * std::sqrt(k / 3e8), 2e-3);
    EXPECT_NEAR(row.pair_force_error, std::sqrt(3e8 / k) - 1, 1e-3);
  }
  EXPECT_NEAR(table.valid_from.value(), 0.2, 1e-6);
  EXPECT_NEAR(table.valid_to.value(), 0.2, 1e-6);
  EXPECT_EQ(table.sentence, "The constant pair k_i = 3e+05 kN/m, e = 0.5 of law signed, for a supported mass of 86952 "
                            "kg, meets the peak force of the windows within "
                            "0.1 % at 0.2 m/s only, its rebound there off by up to 0.1 % of the approach speed; at "
                            "0.05 m/s it understates the peak force by 25 %; at 1 m/s it "
                            "overstates the peak force by 38 %.");
}

/// The fitted law is no pair: nothing of the kind is said, and the bound is the one measured.
TEST(WindowsTable, SpeaksOfALawThatIsNoPairByItsOwnNumbers) {
  std::vector<StoredRun> runs;
  for (const double v : {0.1, 0.3}) {
    auto truth = window(v, 6e8);
    truth.reduced.impact_law = &laws::impact_law("elastoplastic");
    runs.push_back(run_of(truth));
  }
  FitResult law;
  law.law = "elastoplastic";
  law.names = {"k_i", "yield_force", "hardening", "unloading_gain"};
  law.parameters["k_i"].value = 6e5, law.parameters["yield_force"].value = 800;
  law.parameters["hardening"].value = 0.08, law.parameters["unloading_gain"].value = 0.3;
  FitOptions options;
  options.law = "elastoplastic", options.parameters = law.names, options.n_starts = 1;
  const auto table = windows_table({&runs[0], &runs[1]}, law, options, 0.10);
  EXPECT_EQ(table.sentence.find("pair"), std::string::npos) << table.sentence;
  EXPECT_NE(table.sentence.find("The law elastoplastic (k_i = 6e+05 kN/m, yield_force = 800 kN, hardening = 0.08"),
            std::string::npos)
      << table.sentence;
  EXPECT_EQ(table.sentence.find("within 10 %"), std::string::npos) << table.sentence;
}

} // namespace
} // namespace rimpact::calibration
