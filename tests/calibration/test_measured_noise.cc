#include "calibration/answer/calibration.h"
#include "calibration/data/contact_detector.h"
#include "calibration/data/flight_fit.h"
#include "calibration/data/measured_record.h"
#include "calibration/data/metrics.h"
#include "calibration/fit/shooting.h"
#include "io/files/error.h"
#include "measured_synthetic.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>

namespace rimpact::calibration {
namespace {
using namespace testing;

std::string record(const std::string &name) {
  return std::string(RIMPACT_RECORDS) + "/" + name;
}

FitResult fit_records(const std::vector<std::string> &names, const std::string &law,
                      const std::vector<std::string> &parameters) {
  std::vector<StoredRun> runs;
  std::vector<const StoredRun *> pointers;
  for (const auto &name : names) runs.push_back(read_run(record(name), {}));
  for (const auto &run : runs) pointers.push_back(&run);
  FitOptions options;
  options.law = law, options.parameters = parameters;
  return fit(pointers, options);
}

// 0.02 mm at 5 kHz, truth 3e5 kN/m and 0.55: by two-point differences 3.26e5 +- 0.08e5 and 0.603 +- 0.011
TEST(MeasuredNoise, OfTheDisplacementIsInTheInterval) {
  const auto result = fit_records({"r02x.toml", "r04x.toml"}, "no-tension", {"k_i", "e"});
  const auto &k = result.parameters.at("k_i"), &e = result.parameters.at("e");
  EXPECT_NEAR(k.value / 3e5, 1, 0.02);
  EXPECT_NEAR(e.value, 0.55, 0.02);
  EXPECT_LT(std::abs(k.value - 3e5), 2.5 * k.standard_error);
  EXPECT_LT(std::abs(e.value - 0.55), 2.5 * e.standard_error);
}

// without noise, force_noise 0 / 0.02 / 0.05 gave exponents of 1.50 / 1.43 / 1.39 and stiffnesses of 3.00 / 3.37
// / 3.67e5
TEST(MeasuredNoise, AThresholdFindsContactsAndAltersNoFit) {
  for (const char *share : {"n0", "", "n5"}) {
    const auto result = fit_records({fmt::format("r02{}.toml", share), fmt::format("r04{}.toml", share)},
                                    "hunt-crossley", {"k_i", "e", "exponent"});
    EXPECT_NEAR(result.parameters.at("k_i").value / 3e5, 1, 2e-3) << share;
    EXPECT_NEAR(result.parameters.at("exponent").value, 1.5, 2e-3) << share;
    EXPECT_NEAR(result.parameters.at("e").value, 0.55, 1e-3) << share;
  }
}

TEST(MeasuredNoise, IsFoundInTheRecordAndStated) {
  const Instruments with{.rate = 5000, .displacement = 0.02e-3, .force = 0.02};
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const StoredRun run = measured(window(0.3), with, seed);
    ASSERT_EQ(run.impacts.size(), 1u);
    const auto &w = run.impacts[0];
    EXPECT_NEAR(w.measurement->sigma_displacement / 0.02e-3, 1, 0.25) << seed;
    EXPECT_NEAR(w.measurement->sigma_force / w.peak, 0.02, 0.004) << seed;
    EXPECT_NEAR(w.impact.approach_speed, 0.3, 5 * w.measurement->start_factor.row(1).norm()) << seed;
    EXPECT_NE(run.notes.back().find("noise found in the record"), std::string::npos);
    EXPECT_NE(run.notes.back().find("force_noise ="), std::string::npos);
  }
}

// 2 % of noise against force_noise = 0.02 made impacts of noise, and stopped 5 to 8 of 20 sets with a sentence on signs
TEST(MeasuredNoise, MakesNoImpacts) {
  for (const double force : {0.02, 0.05})
    for (unsigned seed = 1; seed <= 40; ++seed) {
      const StoredRun run = measured(window(0.2), {.rate = 1000, .displacement = 0.02e-3, .force = force}, seed,
                                     {.force_threshold = 0.02});
      EXPECT_EQ(run.summary.impacts.size(), 1u) << force << " " << seed;
      EXPECT_EQ(run.impacts.size(), 1u) << force << " " << seed;
    }
}

TEST(MeasuredNoise, ARecordWithoutContactHoldsNone) {
  auto motion = reduced::simulate(window(0.3)).response;
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  for (double &f : motion.series("impact_x")) f = 1e4 * normal(generator);
  const StoredRun run = make_run("noise", window(0.3), motion, {.measured = true});
  EXPECT_TRUE(run.summary.impacts.empty());
}

TEST(MeasuredNoise, TheCellsZeroIsTakenOff) {
  const auto scene = window(0.3);
  auto truth = reduced::simulate(scene).response;
  auto response = sampled(scene, truth, {.rate = 5000, .displacement = 1e-6, .force = 0.01}, 3);
  for (double &f : response.series("impact_x")) f += 4e4;
  const auto found = find_contacts(response, 0);
  ASSERT_EQ(found.contacts.size(), 1u);
  EXPECT_NEAR(found.zero_x, 4e4, 3e3);
  ASSERT_EQ(found.notes.size(), 1u);
}

TEST(MeasuredNoise, FlightTellsSpeedAndItsError) {
  const auto scene = window(0.3);
  const auto truth = reduced::simulate(scene).response;
  double square = 0, stated = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const auto r = sampled(scene, truth, {.rate = 5000, .displacement = 0.05e-3}, seed);
    const auto fit = fit_flight(scene, r, 0, 45, r.series("time")[45], 0.05e-3, false);
    square += std::pow(fit.v.x() - 0.3, 2) / 60, stated += std::pow(0.05e-3, 2) * fit.shape(1, 1) / 60;
  }
  EXPECT_NEAR(std::sqrt(square / stated), 1, 0.25);
}

TEST(MeasuredNoise, FlightFollowsTheGroundsMotion) {
  const auto scene = ricker(1.1);
  auto truth = scene;
  truth.reduced.output_step = 1e-3;
  const auto r = reduced::simulate(truth).response;
  const auto &t = r.series("time"), &v = r.series("velocity_x");
  const std::size_t first = static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), 1.0) - t.begin()),
                    last = first + 50;
  const auto fit = fit_flight(scene, r, first, last, t[last], 1e-6, false);
  EXPECT_NEAR(fit.v.x(), v[last], 1e-4 * std::abs(v[last]));
}

TEST(MeasuredNoise, ARecordThatBeginsAtTouchTakesTheStatedSpeedOrAsksForMore) {
  const auto scene = window(0.3);
  const StoredRun begun = measured(scene, {.rate = 5000, .displacement = 1e-6, .force = 0.005, .before = 0}, 1);
  ASSERT_EQ(begun.impacts.size(), 1u) << begun.notes.front();
  EXPECT_NEAR(begun.impacts[0].impact.approach_speed, 0.3, 1e-12);
  EXPECT_NEAR(begun.impacts[0].measurement->start_factor(1, 1), 0.003, 1e-9);
  auto history = scene; // not a window: nothing states its speed
  history.excitation.kind = scene::ExcitationKind::free;
  const StoredRun asked = make_run("history", history, begun.response, {.measured = true});
  ASSERT_TRUE(asked.impacts.empty());
  EXPECT_NE(asked.notes.front().find("ms before this touch"), std::string::npos) << asked.notes.front();
  EXPECT_NE(asked.notes.front().find("let it begin earlier"), std::string::npos);
}

/// Impacts whose force is doubted for coming at another time than the motion.
int doubts_of_clocks(const StoredRun &run) {
  return static_cast<int>(std::count_if(run.doubts.begin(), run.doubts.end(), [](const std::string &doubt) {
    return doubt.find("do the channels have one clock") != std::string::npos;
  }));
}

/// The record with its force `late` samples behind.
StoredRun with_lag(const StoredRun &run, int late) {
  Response r = run.response;
  auto &force = r.series("impact_x");
  const std::vector<double> before = force;
  const int n = static_cast<int>(force.size());
  for (int i = 0; i < n; ++i) force[i] = before[std::clamp(i - late, 0, n - 1)];
  r.series("force_x") = force;
  return make_run(run.folder, run.scene, std::move(r), {.measured = true});
}

TEST(MeasuredNoise, ChannelsWithTwoClocksAreDoubtedAndOneClockIsNot) {
  for (const char *law : {"no-tension", "elastoplastic"})
    for (const double speed : {0.2, 0.4, 0.6})
      for (unsigned seed = 1; seed <= 6; ++seed)
        for (const auto &with :
             {Instruments{.rate = 1000, .before = 0.03, .after = 0.03},
              {.rate = 5000, .displacement = 0.01e-3, .force = 0.005, .before = 0.03, .after = 0.03}}) {
          auto scene = window(speed);
          scene.reduced.impact_law = &laws::impact_law(law);
          const StoredRun run = measured(scene, with, seed);
          const int samples = with.rate > 1000 ? 4 : 1; // 0.8 and 1 ms
          EXPECT_EQ(doubts_of_clocks(run), 0) << law << ' ' << speed << ' ' << seed << ' ' << with.rate;
          for (const int late : {-samples, samples})
            EXPECT_EQ(doubts_of_clocks(with_lag(run, late)), 1)
                << law << ' ' << speed << ' ' << seed << ' ' << with.rate << ' ' << late;
        }
}

/// Under weight, friction that turns with the slider, and a ground that moves meanwhile. Where the impact lifts the
/// slider off the dish nothing is said.
TEST(MeasuredNoise, ClocksOfAPulseAreJudgedToo) {
  for (const char *scale : {"1.05", "1.3", "1.6"})
    for (const char *k_i : {"4.5e5", "2e6"}) {
      const auto scene = scene::load_scene(
          "ricker-0.78g-1.0s", {std::string("excitation.scale=") + scale, std::string("reduced.k_i_kN_per_m=") + k_i});
      const Instruments with{.rate = 5000, .displacement = 0.01e-3, .force = 0.005, .before = 0.05, .after = 0.05};
      const StoredRun run = measured(scene, with, 1);
      ASSERT_GE(run.impacts.size(), 1u);
      EXPECT_EQ(doubts_of_clocks(run), 0) << scale << ' ' << k_i;
      const bool stays_down = run.impacts[0].peak < 2.5e6;
      EXPECT_EQ(doubts_of_clocks(with_lag(run, 8)), stays_down ? 1 : 0) << scale << ' ' << k_i;
    }
}

TEST(MeasuredNoise, ACellThatSaturatesIsNamed) {
  const Instruments with{.rate = 5000, .displacement = 0.01e-3, .force = 0.005, .before = 0.03, .after = 0.03};
  const StoredRun run = measured(window(0.4), with, 1);
  const auto named = [](const StoredRun &one) {
    return std::count_if(one.doubts.begin(), one.doubts.end(), [](const std::string &doubt) {
      return doubt.find("does the cell saturate?") != std::string::npos;
    });
  };
  EXPECT_EQ(named(run), 0);
  Response clipped = run.response;
  for (double &force : clipped.series("impact_x")) force = std::max(force, -0.7 * run.impacts[0].peak);
  EXPECT_EQ(named(make_run("clipped", run.scene, clipped, {.measured = true})), 1);
}

/// A record may begin long before its touch: the model's whole run is laid over it from there.
TEST(MeasuredNoise, AHistoryIsOnTheRecordsClock) {
  const Instruments with{.rate = 5000, .before = 0.4, .after = 0.03};
  const StoredRun run = measured(window(0.3), with, 1);
  ASSERT_EQ(run.impacts.size(), 1u);
  const auto metrics = compare(run.response, history_of(run, run.scene), run.scene.bearing.lateral_capacity());
  EXPECT_LT(metrics.nrmse_force.value(), 0.03);
  EXPECT_LT(metrics.nrmse_displacement.value(), 1e-3);
  EXPECT_LT(std::abs(metrics.touch_time_difference.value()), 5e-4);
}

TEST(MeasuredNoise, AGainThatIsOffIsSaidAndFoundWhereItsErrorIsStated) {
  const auto scene = window(0.3);
  auto motion = reduced::simulate(scene).response;
  for (double &f : motion.series("impact_x")) f *= 1.05;
  const auto r = sampled(scene, motion, {.rate = 5000, .displacement = 0.005e-3, .force = 0.005, .before = 0.02}, 2);
  StoredRun run = make_run("gain", scene, r, {.measured = true});
  ASSERT_EQ(run.impacts.size(), 1u);
  bool said = false;
  for (const auto &note : run.doubts) said = said || note.find("times the change of momentum") != std::string::npos;
  EXPECT_TRUE(said);
  FitOptions options;
  options.counting = SampleWeighting::curve;
  const double truth = scene.reduced.k_i / 1e3; // [kN/m]
  const auto without = fit({&run}, options);
  EXPECT_GT(without.parameters.at("k_i").value, 1.03 * truth);
  EXPECT_FALSE(without.gain);
  run.uncertainty = Uncertainty{.gain = 0.05};
  const auto result = fit({&run}, options);
  ASSERT_TRUE(result.gain);
  EXPECT_NEAR(result.gain->factor, 1.05, 0.005); // by the motion of the mass
  EXPECT_LT(result.gain->standard_error, 0.01);
  const auto &k = result.parameters.at("k_i");
  EXPECT_NEAR(k.value, truth, 0.01 * truth);
  EXPECT_LE(k.interval_low, truth);
  EXPECT_GE(k.interval_high, truth);
}

// 3 % off where 2 % is stated, the rim one that yields: found from the motion of the mass, with and without the noise
// of single samples
TEST(MeasuredNoise, AGainOffByMoreThanIsStatedLeavesTheTruthInItsInterval) {
  std::vector<scene::Scene> scenes{window(0.2), window(0.4)};
  for (const double factor : {0.97, 1.03})
    for (const SampleWeighting counting : {SampleWeighting::automatic, SampleWeighting::curve}) {
      std::vector<StoredRun> runs;
      for (auto &scene : scenes) {
        scene.reduced.impact_law = &laws::impact_law("bilinear");
        scene.reduced.k_i = 9e8, scene.reduced.yield_force = 0.65e6, scene.reduced.hardening = 0.15;
        auto motion = reduced::simulate(scene).response;
        for (double &f : motion.series("impact_x")) f *= factor;
        const auto seed = static_cast<unsigned>(1 + runs.size());
        const auto r =
            sampled(scene, motion, {.rate = 5000, .displacement = 0.005e-3, .force = 0.005, .before = 0.02}, seed);
        runs.push_back(make_run(scene.name, scene, r, {.measured = true}));
        runs.back().uncertainty = Uncertainty{.gain = 0.02};
      }
      FitOptions options;
      options.law = "bilinear", options.parameters = laws::impact_law("bilinear").parameters;
      options.counting = counting;
      const auto result = fit({&runs[0], &runs[1]}, options);
      ASSERT_TRUE(result.gain) << factor;
      EXPECT_NEAR(result.gain->factor, factor, 0.005);
      for (const auto &[name, truth] : {std::pair{"k_i", 9e5}, {"yield_force", 650.0}, {"hardening", 0.15}}) {
        const Estimate &e = result.parameters.at(name);
        EXPECT_LE(e.interval_low, truth) << name << " at " << factor;
        EXPECT_GE(e.interval_high, truth) << name << " at " << factor;
        EXPECT_LT(e.interval_high / e.interval_low, 1.2) << name << ": the interval must say something";
      }
    }
}

/// Alters a force channel [N] of such a peak.
using Change = std::function<void(std::vector<double> &force, double peak, unsigned seed)>;

/// A window's record on a rim that cannot pull, 3e5 kN/m, its force channel changed.
StoredRun altered(const Instruments &with, unsigned seed, const Change &change) {
  auto scene = window(0.3);
  scene.reduced.impact_law = &laws::impact_law("no-tension"), scene.reduced.output_step = 1e-3;
  auto r = sampled(scene, reduced::simulate(scene).response, with, seed);
  auto &force = r.series("impact_x");
  change(force, -*std::min_element(force.begin(), force.end()), seed);
  return make_run(fmt::format("altered-{}", seed), scene, r, {.measured = true});
}

/// Adds errors of `sigma`, averaged over `length` neighbours as a filter does.
void add_averaged(std::vector<double> &force, double sigma, int length, unsigned seed) {
  std::mt19937 generator(seed + 100);
  std::normal_distribution<double> normal;
  std::vector<double> noise(force.size() + length);
  for (double &v : noise) v = sigma * normal(generator);
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] += std::accumulate(noise.begin() + i, noise.begin() + i + length, 0.0) / length;
}

/// Of so many records, those whose interval holds the stiffness; each has one impact, whose errors hang together or
/// not.
int held(const Instruments &with, unsigned records, bool together, const Change &change) {
  int n = 0;
  for (unsigned seed = 1; seed <= records; ++seed) {
    const StoredRun run = altered(with, seed, change);
    EXPECT_EQ(run.impacts.size(), 1u) << seed;
    if (run.impacts.size() != 1) continue;
    EXPECT_EQ(run.impacts[0].measurement->inflation_force > 2, together) << seed;
    const auto k = fit({&run}, {}).parameters.at("k_i");
    n += k.interval_low <= 3e5 && 3e5 <= k.interval_high;
  }
  return n;
}

// errors that hang together, or that are rounding, make no contact before the touch, and intervals hold the truth
TEST(MeasuredNoise, OfAFilterOrOfDigitsIsKnown) {
  const Instruments with{.rate = 2000, .displacement = 0.005e-3, .before = 0.03, .after = 0.03};
  const auto averaged = [](auto &force, double peak, unsigned seed) { add_averaged(force, 0.02 * peak, 8, seed); };
  const auto rounded = [](auto &force, double peak, unsigned) {
    for (double &f : force) f = peak / 50 * std::round(50 * f / peak);
  };
  EXPECT_GE(held(with, 12, true, averaged), 9); // 95 % intervals hold fewer once in 5000
  EXPECT_GE(held(with, 12, false, rounded), 9);
}

// 1 % of the peak at 5 kHz, averaged over 25 samples, or the mains' hum: errors much smoother than neighbours tell
TEST(MeasuredNoise, OfALowFilterOrOfHumIsKnown) {
  const Instruments with{.rate = 5000, .displacement = 0.005e-3, .before = 0.03, .after = 0.05};
  const auto averaged = [](auto &force, double peak, unsigned seed) { add_averaged(force, 0.05 * peak, 25, seed); };
  const auto hum = [](auto &force, double peak, unsigned seed) {
    add_averaged(force, 0.0025 * peak, 1, seed);
    for (std::size_t i = 0; i < force.size(); ++i)
      force[i] += 0.01 * peak * std::sin(2 * M_PI * 50 * static_cast<double>(i) / 5000 + seed);
  };
  EXPECT_GE(held(with, 8, true, averaged), 6); // 95 % intervals hold fewer once in 170
  EXPECT_GE(held(with, 8, true, hum), 6);
}

// the rim does not follow the slider inwards: what the cell reads on there is its own, and is said
TEST(MeasuredNoise, ACellThatDriftsIsNotTakenForTheRim) {
  const Instruments with{.rate = 5000, .displacement = 0.005e-3, .force = 0.005, .before = 0.03, .after = 0.08};
  for (const double drift : {0.04, 0.12}) {
    const StoredRun run = altered(with, 2, [&](auto &force, double peak, unsigned) {
      for (std::size_t i = 0; i < force.size(); ++i)
        force[i] -= drift * peak * static_cast<double>(i) / static_cast<double>(force.size());
    });
    ASSERT_EQ(run.impacts.size(), 1u) << drift;
    EXPECT_NEAR(fit({&run}, {}).parameters.at("k_i").value / 3e5, 1, 0.03) << drift;
    const bool said = std::any_of(run.doubts.begin(), run.doubts.end(), [](const std::string &doubt) {
      return doubt.find("does the cell drift") != std::string::npos;
    });
    EXPECT_TRUE(said || drift < 0.1) << fmt::format("{}", fmt::join(run.doubts, "; "));
  }
}

TEST(MeasuredNoise, WithoutNoiseTheTruthIsFound) {
  auto scene = window(0.3);
  for (const char *law : {"no-tension", "hunt-crossley", "signed"}) {
    scene.reduced.impact_law = &laws::impact_law(law);
    StoredRun run = measured(scene, {.rate = 5000}, 1);
    ASSERT_EQ(run.impacts.size(), 1u) << law;
    run.scene.reduced.k_i = 4.5e8, run.scene.reduced.restitution = 0.65;
    const auto result = fit({&run}, {});
    EXPECT_NEAR(result.parameters.at("k_i").value / 3e5, 1, 1e-3) << law;
    EXPECT_NEAR(result.parameters.at("e").value, 0.4, 1e-3) << law;
  }
}

// what stands on curves without noise stays: values of the fit before measured records had an estimator of their own
TEST(MeasuredNoise, ReferencesWithoutNoiseAreFittedAsBefore) {
  std::vector<StoredRun> runs;
  for (const char *speed : {"0.07", "0.20", "0.50"})
    runs.push_back(read_run(std::string(RIMPACT_REFERENCES) + "/window-" + speed, {}));
  FitOptions options;
  options.law = "elastoplastic", options.parameters = {"k_i", "yield_force", "hardening", "unloading_gain"};
  options.n_starts = 2;
  const auto result = fit({&runs[0], &runs[1], &runs[2]}, options);
  EXPECT_NEAR(result.parameters.at("k_i").value / 991333.16, 1, 1e-3);
  EXPECT_NEAR(result.parameters.at("yield_force").value / 714.8116, 1, 1e-3);
  EXPECT_NEAR(result.parameters.at("hardening").value / 0.1397028, 1, 1e-3);
  EXPECT_NEAR(result.parameters.at("unloading_gain").value / 0.4862087, 1, 1e-3);
  EXPECT_NEAR(result.parameters.at("k_i").standard_error / 18331.24, 1, 2e-2);
}

TEST(MeasuredNoise, ARunNamedTwiceIsRefused) {
  EXPECT_THROW(calibrate({record("r02n0.toml"), record("r02n0.toml")}), InputError);
}

TEST(MeasuredNoise, ASummaryThatWasChangedIsADataError) {
  TemporaryFolder folder;
  const auto path = folder.write(window(0.3));
  for (const char *status : {"3", "null"}) {
    std::ofstream(path + "/summary.json") << "{\"status\": " << status << "}";
    EXPECT_THROW(read_run(path, {}), DataError) << status;
  }
}

TEST(MeasuredNoise, StartsAreBounded) {
  FitOptions options;
  options.n_starts = 2147483647;
  EXPECT_THROW(options.validate(), InputError);
}

} // namespace
} // namespace rimpact::calibration
