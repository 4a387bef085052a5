#include "calibration/fit/profile.h"
#include "calibration/laws/law_ranking.h"
#include "calibration/laws/speed_law.h"
#include "io/files/error.h"
#include "synthetic.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

scene::Scene yielding_window(double speed) {
  auto s = window(speed, 6e8);
  s.reduced.impact_law = &laws::impact_law("elastoplastic");
  s.reduced.yield_force = 0.9e6;
  s.reduced.hardening = 0.1;
  s.reduced.unloading_gain = 0.3;
  return s;
}

TEST(LawRanking, PutsTheLawThatMadeTheDataFirst) {
  std::vector<StoredRun> runs;
  for (const double v : {0.1, 0.2, 0.4, 0.8}) {
    runs.push_back(run_of(yielding_window(v)));
    runs.back().scene.reduced = {}; // nothing of the truth is left to read
  }
  std::vector<std::string> notes;
  FitOptions options;
  options.n_starts = 3;
  const auto ranking = rank_laws(pointers(runs), {"signed", "no-tension", "elastoplastic"}, options, notes);
  ASSERT_EQ(ranking.rows.size(), 3u) << (notes.empty() ? "" : notes[0]);
  const auto &best = ranking.rows[0];
  EXPECT_EQ(best.result.law, "elastoplastic");
  EXPECT_NEAR(best.result.parameters.at("k_i").value, 6e5, 60);
  EXPECT_NEAR(best.result.parameters.at("yield_force").value, 900, 0.9);
  EXPECT_NEAR(best.result.parameters.at("hardening").value, 0.1, 1e-3);
  EXPECT_NEAR(best.result.parameters.at("unloading_gain").value, 0.3, 3e-3);
  EXPECT_LT(best.unexplained, 5e-3); // the sampling's own
  EXPECT_LT(best.largest_peak_error, 2e-3);
  EXPECT_LT(best.largest_rebound_error, 2e-3);
  EXPECT_GT(ranking.rows[1].unexplained, 0.02); // a linear rim cannot follow them
  ASSERT_EQ(best.left_out.size(), 4u);
  EXPECT_LE(best.left_out_peak_error, ranking.rows[1].left_out_peak_error);
  EXPECT_NE(ranking.sentence.find("elastoplastic"), std::string::npos);
}

// what an ElasticPPGap, a multi-linear link or a bolted stop return
TEST(LawRanking, ABilinearRimIsFoundByItsOwnLaw) {
  std::vector<StoredRun> runs;
  for (const double v : {0.1, 0.2, 0.35, 0.6}) {
    auto truth = yielding_window(v);
    truth.reduced.impact_law = &laws::impact_law("bilinear");
    runs.push_back(run_of(truth));
    runs.back().scene.reduced = {};
  }
  std::vector<std::string> notes;
  const auto ranking = rank_laws(pointers(runs), {"elastoplastic", "bilinear"}, {}, notes);
  ASSERT_EQ(ranking.rows.size(), 2u);
  const auto &best = ranking.rows[0];
  EXPECT_EQ(best.result.law, "bilinear");
  EXPECT_NEAR(best.result.parameters.at("k_i").value / 6e5, 1, 1e-3);
  EXPECT_NEAR(best.result.parameters.at("yield_force").value / 900, 1, 1e-3);
  EXPECT_NEAR(best.result.parameters.at("hardening").value / 0.1, 1, 1e-2);
  EXPECT_LT(best.left_out_peak_error, 0.01);
  EXPECT_LT(best.left_out_rebound_error, 0.01);
}

TEST(LawRanking, ExponentsThatAreHeldAreSaid) {
  std::vector<StoredRun> runs = {run_of(yielding_window(0.2)), run_of(yielding_window(0.5))};
  std::vector<std::string> notes;
  const auto row = rank_laws(pointers(runs), {"elastoplastic"}, {}, notes).rows.at(0);
  EXPECT_NE(row.held.find("hardening_exponent at 0.75"), std::string::npos) << row.held;
  EXPECT_NE(row.held.find("2 impacts"), std::string::npos) << row.held;
  for (auto &run : runs) run.scene.reduced.hardening_exponent = 0.6; // a fit leaves it there
  const auto other = rank_laws(pointers(runs), {"elastoplastic"}, {}, notes).rows.at(0);
  EXPECT_NE(other.held.find("hardening_exponent at 0.6"), std::string::npos) << other.held;
}

TEST(LawRanking, FindsTheExponentsOnceImpactsAreEnough) {
  std::vector<StoredRun> runs;
  for (const double v : {0.1, 0.2, 0.3, 0.45, 0.7, 1.0}) {
    auto truth = yielding_window(v);
    truth.reduced.hardening_exponent = 0.6;
    truth.reduced.unloading_exponent = 0.8;
    runs.push_back(run_of(truth));
    runs.back().scene.reduced = {};
  }
  std::vector<std::string> notes;
  FitOptions options;
  options.n_starts = 1;
  const auto ranking = rank_laws(pointers(runs), {"elastoplastic"}, options, notes);
  ASSERT_EQ(ranking.rows.size(), 1u) << (notes.empty() ? "" : notes[0]);
  const auto &found = ranking.rows[0].result.parameters;
  ASSERT_TRUE(found.count("unloading_exponent"));
  EXPECT_NEAR(found.at("unloading_exponent").value, 0.8, 0.01);
  EXPECT_NEAR(found.at("hardening_exponent").value, 0.6, 0.01);
  EXPECT_LT(ranking.rows[0].left_out_rebound_error, 0.01);
  std::vector<StoredRun> few(runs.begin(), runs.begin() + 5); // one impact short of the six parameters
  EXPECT_FALSE(rank_laws(pointers(few), {"elastoplastic"}, options, notes)
                   .rows.at(0)
                   .result.parameters.count("unloading_exponent"));
}

TEST(LawRanking, SaysWhereALawPredictsAndWhatItMissesBeyond) {
  std::vector<StoredRun> runs;
  for (const double v : {0.05, 0.1, 0.15, 1.0}) runs.push_back(run_of(yielding_window(v)));
  std::vector<std::string> notes;
  const auto ranking = rank_laws(pointers(runs), {"no-tension"}, {}, notes);
  ASSERT_EQ(ranking.rows.size(), 1u);
  const auto &row = ranking.rows[0];
  for (const auto &left : row.left_out) {
    ASSERT_EQ(left.errors.size(), 1u);
    EXPECT_EQ(left.errors[0].folder, left.what);
  }
  EXPECT_GT(row.left_out_peak_error, 0.1); // fitted to slow impacts, the fast one is overstated
  EXPECT_NE(row.sentence.find("overstated"), std::string::npos) << row.sentence;
}

TEST(LawRanking, LeavesAPulseOutWithAllItsScales) {
  std::vector<StoredRun> runs;
  for (const double scale : {1.05, 1.1}) {
    runs.push_back(run_of(ricker(scale)));
    runs.push_back(run_of(ricker(scale, 3e8, 0.4, 0.38, 1.5)));
  }
  std::vector<std::string> notes;
  const auto ranking = rank_laws(pointers(runs), {"signed"}, {}, notes);
  int pulses = 0;
  for (const auto &left : ranking.rows.at(0).left_out) pulses += left.errors.size() == 2;
  EXPECT_EQ(pulses, 2);
  EXPECT_LT(ranking.rows[0].left_out_peak_error, 1e-4); // one law made them all
}

TEST(LawRanking, HoldsWhatIsFixed) {
  const StoredRun run = run_of(window(0.3));
  FitOptions options;
  options.fixed["e"] = 0.4;
  options.parameters = {"k_i"};
  std::vector<std::string> notes;
  const auto ranking = rank_laws({&run}, {"signed"}, options, notes);
  const auto &result = ranking.rows.at(0).result;
  EXPECT_EQ(result.names, std::vector<std::string>{"k_i"});
  EXPECT_NEAR(result.parameters.at("k_i").value, 3e5, 1);
  EXPECT_TRUE(ranking.rows[0].left_out.empty()); // one run: nothing to predict it from
}

TEST(Fit, RefusesAParameterOfAnotherLaw) {
  const StoredRun run = run_of(window(0.3));
  FitOptions options;
  options.parameters = {"k_i", "yield_force"};
  try {
    fit({&run}, options);
    ADD_FAILURE() << "accepted";
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("not read by the law signed"), std::string::npos) << error.what();
  }
  options.parameters = {"k_i", "e"};
  options.fixed["e"] = 0.5;
  EXPECT_THROW(fit({&run}, options), InputError);
}

TEST(Fit, FindsWhereTheRimBegins) {
  auto truth = ricker(1.1);
  truth.reduced.capacity_offset = 0.8e-3;
  WindowOptions window;
  window.touch = TouchReference::gap;
  window.lead = 6e-3;
  StoredRun run = run_of(truth, window);
  run.scene.reduced.capacity_offset = 0;
  FitOptions options;
  options.parameters = {"k_i", "capacity_offset"};
  const auto result = fit({&run}, options);
  EXPECT_NEAR(result.parameters.at("capacity_offset").value, 0.8, 1e-3);
  EXPECT_NEAR(result.parameters.at("k_i").value / 3e5, 1, 1e-3);
}

TEST(Fit, FollowsAClockThatIsLate) {
  StoredRun run = run_of(window(0.3)), late = run;
  for (auto &w : late.impacts) // the force and displacement gauges lag 2 ms
    for (auto *series : {&w.force, &w.displacement}) {
      auto shifted = *series;
      for (std::size_t i = 0; i < w.times.size(); ++i) {
        const double t = w.times[i] - 2e-3;
        const auto j = std::upper_bound(w.times.begin(), w.times.end(), t) - w.times.begin();
        shifted[i] = j == 0 ? (*series)[0]
                            : (*series)[j - 1] + ((*series)[j] - (*series)[j - 1]) * (t - w.times[j - 1]) /
                                                     (w.times[j] - w.times[j - 1]);
      }
      *series = shifted;
    }
  FitOptions options;
  options.weights = {.force = 1, .displacement = 1, .rebound = 0, .peak = 0};
  const double blind = std::abs(fit({&late}, options).parameters.at("k_i").value / 3e5 - 1);
  options.uncertainty.time = 5e-3;
  const double seeing = std::abs(fit({&late}, options).parameters.at("k_i").value / 3e5 - 1);
  EXPECT_LT(seeing, 0.2 * blind);
}

TEST(Profile, CrossesWhereTheNormalIntervalEnds) {
  const StoredRun run = run_of(window(0.3));
  const auto best = fit({&run}, {});
  const auto p = profile_of({&run}, {}, best, "k_i");
  const double error = best.parameters.at("k_i").stated_error;
  ASSERT_TRUE(p.low && p.high);
  EXPECT_NEAR(best.parameters.at("k_i").value - *p.low, 1.96 * error, 0.15 * 1.96 * error);
  EXPECT_NEAR(*p.high - best.parameters.at("k_i").value, 1.96 * error, 0.15 * 1.96 * error);
  for (const double cost : p.costs) EXPECT_GT(cost, -1e-6);
}

TEST(SpeedLaws, RecoverAPowerOfTheSpeed) {
  std::vector<StoredRun> runs;
  for (const double v : {0.1, 0.2, 0.5, 1.0}) runs.push_back(run_of(window(v, 3e8 * std::pow(v, -0.4), 0.5)));
  FitResult pair;
  pair.parameters["k_i"].value = 3e5, pair.parameters["e"].value = 0.5;
  const auto laws = speed_laws(windows_table(pointers(runs), pair, {}, 0.10));
  ASSERT_EQ(laws.size(), 2u);
  EXPECT_NEAR(laws[0].coefficient, 3e5, 30);
  EXPECT_NEAR(laws[0].exponent, -0.4, 1e-4);
  EXPECT_NEAR(laws[1].coefficient, 0.5, 1e-4);
  EXPECT_NEAR(laws[1].exponent, 0, 1e-4);
  EXPECT_LT(laws[0].largest_error, 1e-4);
  EXPECT_NEAR(laws[0].to, 1.0, 1e-9);
}

} // namespace
} // namespace rimpact::calibration
