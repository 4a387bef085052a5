// Pulses, and accelerations in every direction.
#include "records/daubechies.h"
#include "records/record.h"
#include "records/rotated_spectrum.h"
#include "records/spectral_acceleration.h"
#include "records/velocity_pulse.h"
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

using namespace rimpact;

TEST(Daubechies, HasUnitEnergyAndFourVanishingMoments) {
  const double h = 1e-4;
  double square = 0, moments[4] = {0, 0, 0, 0};
  for (double x = 0; x < daubechies_support; x += h) {
    const double psi = daubechies_wavelet(x);
    square += h * psi * psi;
    for (int k = 0; k < 4; ++k) moments[k] += h * psi * std::pow(x / daubechies_support, k);
  }
  EXPECT_NEAR(square, 1, 1e-3);
  for (const double moment : moments) EXPECT_NEAR(moment, 0, 1e-6);
  EXPECT_EQ(daubechies_wavelet(-0.1), 0);
  EXPECT_EQ(daubechies_wavelet(7.1), 0);
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

/// T_p that the authors' program (github.com/shreyshahi/PulseClassification), written again step by step in NumPy,
/// gives for these records; none: it finds no pulse.
struct Pulse {
  const char *first, *second;
  std::optional<double> period;
};

TEST(VelocityPulse, OfRealRecordsAsTheAuthorsProgramHasThem) {
  const char *named = std::getenv("RIMPACT_RECORDS");
  const std::string folder = named ? named : RIMPACT_SHARED_RECORDS;
  for (const auto &[first, second, period] : {Pulse{"RSN1063_NORTHR_RRS228", "RSN1063_NORTHR_RRS318", 1.246},
                                              {"RSN1086_NORTHR_SYL090", "RSN1086_NORTHR_SYL360", 2.436},
                                              {"RSN1044_NORTHR_NWH090", "RSN1044_NORTHR_NWH360", 1.372},
                                              {"RSN982_NORTHR_JEN022", "RSN982_NORTHR_JEN292", 3.157},
                                              {"RSN179_IMPVALL.H_H-E04140", "RSN179_IMPVALL.H_H-E04230", 4.788},
                                              {"RSN180_IMPVALL.H_H-E05140", "RSN180_IMPVALL.H_H-E05230", 4.130},
                                              {"RSN182_IMPVALL.H_H-E07140", "RSN182_IMPVALL.H_H-E07230", 4.375},
                                              {"RSN879_LANDERS_LCN260", "RSN879_LANDERS_LCN345", 5.124},
                                              {"RSN828_CAPEMEND_PET000", "RSN828_CAPEMEND_PET090", 2.996},
                                              {"RSN183_IMPVALL.H_H-E08140", "RSN183_IMPVALL.H_H-E08230", 5.859},
                                              {"RSN185_IMPVALL.H_H-HVP225", "RSN185_IMPVALL.H_H-HVP315", 4.823},
                                              {"RSN187_IMPVALL.H_H-PTS225", "RSN187_IMPVALL.H_H-PTS315", {}},
                                              {"RSN776_LOMAP_HSP000", "RSN776_LOMAP_HSP090", {}},
                                              {"RSN1087_NORTHR_TAR090", "RSN1087_NORTHR_TAR360", {}},
                                              {"RSN6_IMPVALL.I_I-ELC180", "RSN6_IMPVALL.I_I-ELC270", {}},
                                              {"RSN68_SFERN_PEL090", "RSN68_SFERN_PEL180", {}}}) {
    const std::string one = folder + "/" + first + ".AT2", two = folder + "/" + second + ".AT2";
    if (!std::filesystem::exists(one)) GTEST_SKIP() << "no records in " << folder << " (set RIMPACT_RECORDS)";
    const auto pulse = velocity_pulse(read_record(one), read_record(two));
    ASSERT_TRUE(pulse) << first;
    EXPECT_EQ(pulse->period.has_value(), period.has_value()) << first;
    if (pulse->period && period) {
      EXPECT_NEAR(*pulse->period / *period, 1, 0.025) << first;
    }
  }
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
