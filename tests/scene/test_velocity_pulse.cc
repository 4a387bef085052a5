// Pulses, and accelerations in every direction.
#include "io/files/table.h"
#include "io/files/table_csv.h"
#include "io/records/daubechies.h"
#include "io/records/near_fault_pulse.h"
#include "io/records/record.h"
#include "io/records/rotated_spectrum.h"
#include "io/records/spectral_acceleration.h"
#include "io/records/velocity_pulse.h"
#include "io/records/wavelet_candidates.h"
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>

using namespace rimpact;

TEST(Daubechies, HasUnitEnergyAndFourVanishingMoments) {
  for (const int steps : {4, 10}) {
    const auto psi = daubechies_wavelet(steps);
    ASSERT_EQ(psi.size(), (7u << steps) + 1);
    const double h = std::ldexp(1.0, -steps);
    double square = 0, moments[4] = {0, 0, 0, 0};
    for (std::size_t i = 0; i < psi.size(); ++i) {
      square += h * psi[i] * psi[i];
      for (int k = 0; k < 4; ++k) moments[k] += h * psi[i] * std::pow(h * static_cast<double>(i), k);
    }
    EXPECT_NEAR(square, 1, 1e-9);
    for (const double moment : moments) EXPECT_NEAR(moment, 0, 1e-9);
    EXPECT_EQ(psi.front(), 0);
    EXPECT_EQ(psi.back(), 0);
  }
}

TEST(WaveletTransform, IsTheSumOfSamplesTimesWeights) {
  PlaneSignal v(157);
  for (std::size_t i = 0; i < v.size(); ++i)
    v[i] = {std::sin(0.21 * static_cast<double>(i * i % 97)), 0.01 * static_cast<double>(i)};
  const WaveletTransform transform(v.size(), 40);
  const WaveletCandidates candidates(v, {.shortest = 7, .step = 11, .count = 4});
  for (const long scale : {7L, 18L, 40L}) {
    const auto heights = transform.heights(v, scale);
    ASSERT_EQ(heights.size(), v.size());
    for (const std::size_t place : {0u, 3u, 80u, 156u}) {
      const auto wanted = candidates.height({scale, place});
      EXPECT_NEAR(heights[place].real(), wanted.real(), 1e-12) << scale << " " << place;
      EXPECT_NEAR(heights[place].imag(), wanted.imag(), 1e-12) << scale << " " << place;
    }
  }
}

TEST(WaveletTransform, OfAWaveletIsItsHeight) {
  PlaneSignal v(4001);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = {2 * wavelet_value(static_cast<long>(i) - 2000, 300), 0};
  const auto heights = WaveletTransform(v.size(), 300).heights(v, 300);
  EXPECT_NEAR(heights[2000].real(), 2, 0.03) << "it is drawn by four cascades, and sought by ten";
  for (const auto &height : heights) EXPECT_LT(std::abs(height.real()), 2.03);
}

TEST(VelocityPulse, OfThePulsesBuiltIn) {
  const auto pulse = velocity_pulse(builtin_record("builtin:near-fault-x"), builtin_record("builtin:near-fault-y"));
  ASSERT_TRUE(pulse);
  ASSERT_TRUE(pulse->period);
  EXPECT_NEAR(*pulse->period, 2, 0.5); // of half a hertz
  EXPECT_LT(std::abs(std::sin(pulse->direction_deg * M_PI / 180)), 0.4) << "fault normal";
  EXPECT_FALSE(velocity_pulse({0.01, {0, 0, 0}}, {0.01, {0, 0}}));
  EXPECT_FALSE(velocity_pulse({0.01, {0, 1, 0}}, {0.02, {0, 1}}));
}

/// pulses.csv: what the authors' program, written again in NumPy (pulse_classification.py), finds in 127 pairs.
TEST(VelocityPulse, OfRealRecordsAsTheAuthorsProgramHasThem) {
  const char *named = std::getenv("RIMPACT_RECORDS");
  const std::filesystem::path folder = named ? named : RIMPACT_SHARED_RECORDS;
  const auto in = [&](const std::string &name) {
    const auto beside = folder / (name + ".AT2");
    return std::filesystem::exists(beside) ? beside.string() : (folder / "appendix_c" / (name + ".AT2")).string();
  };
  const Table table = read_table(RIMPACT_PULSES);
  ASSERT_EQ(table.rows.size(), 127u);
  std::size_t read = 0, found = 0;
  for (const auto &row : table.rows) {
    const std::string first = std::get<std::string>(row[0]), second = std::get<std::string>(row[1]);
    if (!std::filesystem::exists(in(first)) || !std::filesystem::exists(in(second))) continue;
    ++read;
    const auto pulse = velocity_pulse(read_record(in(first)), read_record(in(second)));
    ASSERT_TRUE(pulse) << first;
    const auto *period = std::get_if<double>(&row[2]);
    EXPECT_EQ(pulse->period.has_value(), period != nullptr) << first << ", indicator " << pulse->indicator;
    if (!pulse->period || !period) continue;
    EXPECT_NEAR(*pulse->period, *period, 1e-4) << first;
    ++found;
  }
  if (read == 0) GTEST_SKIP() << "no records in " << folder << " (set RIMPACT_RECORDS)";
  std::cout << read << " pairs, " << found << " pulses\n";
}

TEST(RotatedAcceleration, OfOneMotionIsItsShareInEveryDirection) {
  const auto x = builtin_record("builtin:near-fault-x");
  SampledSignal rest{x.dt, {0, 0}}, turned = x, across = x;
  const double sa = spectral_acceleration(x, 1.0);
  const auto alone = rotated_acceleration(x, rest, 1.0);
  EXPECT_NEAR(alone.rotd100 / sa, 1, 1e-12);
  EXPECT_NEAR(alone.rotd50 / sa, std::sqrt(0.5), 0.01); // the median of |cos|
  for (std::size_t i = 0; i < x.values.size(); ++i) turned.values[i] *= 0.6, across.values[i] *= 0.8;
  const auto oblique = rotated_acceleration(turned, across, 1.0); // the same motion, seen along other axes
  EXPECT_NEAR(oblique.rotd100 / sa, 1, 2e-4);
  EXPECT_NEAR(oblique.rotd50 / alone.rotd50, 1, 0.01);
}
