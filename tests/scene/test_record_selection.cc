// Targets of codes, selection and scaling to them, and components turned to a fault.
#include "expect_error.h"
#include "io/records/fault_rotation.h"
#include "io/records/record_selection.h"
#include "temporary_folder.h"
#include <cmath>
#include <fmt/format.h>

using namespace rimpact;

namespace {

/// A wave that fades, of `period`, `peak_g` at its largest.
std::string wave(double peak_g, double period, double phase) {
  std::string text = "PEER\nmade up\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2001, DT= .0100 SEC\n";
  for (int i = 0; i < 2001; ++i) {
    const double t = 0.01 * i;
    text += fmt::format("{:.6e}\n", peak_g * std::exp(-t / 5) * std::sin(2 * M_PI * t / period + phase) *
                                        std::sin(2 * M_PI * t / (3.1 * period)));
  }
  return text;
}

void write_pairs(const TemporaryFolder &folder, int n) {
  for (int k = 1; k <= n; ++k) {
    folder.write(fmt::format("RSN{}_HILL{}000.AT2", k, k), wave(0.1 * k, 0.4 + 0.2 * k, 0.3));
    folder.write(fmt::format("RSN{}_HILL{}090.AT2", k, k), wave(0.12 * k, 0.5 + 0.15 * k, 0.9));
  }
}

} // namespace

TEST(TargetSpectrum, OfAsce7) {
  const TargetSpectrum target("asce7,S_DS=1.0,S_D1=0.6,T_L=8");
  EXPECT_DOUBLE_EQ(target.at(0), 0.4);
  EXPECT_DOUBLE_EQ(target.at(0.12), 1.0); // T_0
  EXPECT_DOUBLE_EQ(target.at(0.06), 0.7);
  EXPECT_DOUBLE_EQ(target.at(0.6), 1.0);
  EXPECT_DOUBLE_EQ(target.at(3), 0.2);
  EXPECT_DOUBLE_EQ(target.at(16), 0.6 * 8 / 256);
  EXPECT_TRUE(target.is_largest_direction());
  EXPECT_DOUBLE_EQ(TargetSpectrum("asce7,S_DS=1,S_D1=0.6,scale=1.5").at(3), 0.3);
}

TEST(TargetSpectrum, OfEn1998) {
  const TargetSpectrum target("en1998,a_g=0.2,ground=C"); // S 1.15, T_B 0.2, T_C 0.6, T_D 2
  EXPECT_DOUBLE_EQ(target.at(0), 0.23);
  EXPECT_DOUBLE_EQ(target.at(0.1), 0.23 * 1.75);
  EXPECT_DOUBLE_EQ(target.at(0.4), 0.575);
  EXPECT_DOUBLE_EQ(target.at(1.2), 0.2875);
  EXPECT_DOUBLE_EQ(target.at(4), 0.575 * 0.6 * 2 / 16);
  EXPECT_DOUBLE_EQ(TargetSpectrum("en1998,a_g=0.1,ground=D,type=2").at(0.2), 0.45); // S 1.8
}

TEST(TargetSpectrum, Refusals) {
  for (const auto &[text, word] : {std::pair("asce7,S_DS=1", "S_D1 is missing"),
                                   {"asce7,S_DS=0,S_D1=1", "S_DS"},
                                   {"asce7,S_DS=1,S_D1=0.6,T_L=0.1", "beyond T_L"},
                                   {"en1998,a_g=0.2", "ground is missing"},
                                   {"en1998,a_g=0.2,ground=F", "\"F\""},
                                   {"en1998,a_g=0.2,ground=A,type=3", "neither 1 nor 2"},
                                   {"asce,S_DS=1", "asce7"},
                                   {"asce7,SDS=1,S_D1=1", "S_DS"},
                                   {"asce7,S_DS", "KEY=VALUE"}})
    expect_error<InputError>([&, t = text] { TargetSpectrum{t}; }, {"--target", word});
}

TEST(RecordSelection, RecordsThatAreTheTargetScaledFitIt) {
  const TemporaryFolder folder;
  write_pairs(folder, 6);
  const SelectionRules rules{.count = 3, .period = 1.5, .largest_scale = 100};
  const auto selection =
      select_records(read_record_folder(folder.path()), TargetSpectrum("asce7,S_DS=1,S_D1=0.6"), rules);
  ASSERT_EQ(selection.recordings.size(), 3u);
  EXPECT_EQ(selection.n_candidates, 6u);
  EXPECT_NEAR(selection.periods.front(), 0.3, 1e-12);
  EXPECT_NEAR(selection.periods.back(), 2.25, 1e-12);
  double least = 1e9;
  for (std::size_t i = 0; i < selection.mean.size(); ++i) {
    double sum = 0;
    for (const auto &r : selection.recordings) sum += r.spectrum[i];
    EXPECT_NEAR(selection.mean[i], sum / 3, 1e-12);
    least = std::min(least, selection.mean[i] / selection.target[i]);
  }
  EXPECT_GE(least, 0.9 - 1e-12);
  if (selection.common > 1) {
    EXPECT_NEAR(least, 0.9, 1e-12);
  }
  for (std::size_t k = 1; k < 3; ++k) EXPECT_LE(selection.recordings[k - 1].misfit, selection.recordings[k].misfit);
  for (const auto &r : selection.recordings) { // its own factor leaves no mean difference
    double off = 0;
    for (std::size_t i = 0; i < selection.target.size(); ++i)
      off += std::log(selection.target[i] * selection.common / r.spectrum[i]);
    EXPECT_NEAR(off, 0, 1e-9);
  }
}

TEST(RecordSelection, FactorsFollowTheTargetAndCopiesAreNotTaken) {
  const TemporaryFolder folder;
  write_pairs(folder, 4);
  const SelectionRules rules{.count = 4, .period = 1, .largest_scale = 1000};
  const auto once = select_records(read_record_folder(folder.path()), TargetSpectrum("en1998,a_g=0.2,ground=B"), rules);
  const auto twice =
      select_records(read_record_folder(folder.path()), TargetSpectrum("en1998,a_g=0.4,ground=B"), rules);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(once.recordings[k].station, twice.recordings[k].station);
    EXPECT_NEAR(twice.recordings[k].factor / once.recordings[k].factor, 2, 1e-9);
  }
  folder.write("RSN9_COPY000.AT2", wave(0.2, 0.6, 0.3)); // RSN1's, twice
  folder.write("RSN9_COPY090.AT2", wave(0.24, 0.65, 0.9));
  const auto copied =
      select_records(read_record_folder(folder.path()), TargetSpectrum("en1998,a_g=0.2,ground=B"), rules);
  EXPECT_EQ(copied.n_candidates, 4u);
  ASSERT_EQ(copied.doubts.size(), 1u);
  expect_error<InputError>(
      [&] {
        select_records(read_record_folder(folder.path()), TargetSpectrum("en1998,a_g=0.2,ground=B"),
                       {.count = 5, .period = 1, .largest_scale = 1000});
      },
      {"4 of 4 recordings", "5 are asked for"});
}

TEST(FaultRotation, ResolvesAnObliqueMotion) {
  // A motion along strike 30 alone, seen by instruments at 75 and 165 degrees.
  SampledSignal motion{0.01, {0, 1, -2, 0.5}}, first = motion, second = motion;
  for (std::size_t i = 0; i < 4; ++i)
    first.values[i] *= std::cos(45 * M_PI / 180), second.values[i] *= std::cos(135 * M_PI / 180);
  const auto turned = fault_components(first, direction_written("75"), second, direction_written("165"), 30);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(turned.parallel.values[i], motion.values[i], 1e-12);
    EXPECT_NEAR(turned.normal.values[i], 0, 1e-12);
  }
  // strike north: parallel is the north component, normal the east one
  const auto plain = fault_components(first, direction_written("N"), second, direction_written("E"), 0);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(plain.parallel.values[i], first.values[i], 1e-12);
    EXPECT_NEAR(plain.normal.values[i], second.values[i], 1e-12);
  }
  expect_error<DataError>([&] { fault_components(first, direction_written("L"), second, direction_written("T"), 0); },
                          {"azimuth", "\"L\""});
  expect_error<DataError>([&] { fault_components(first, direction_written("10"), second, direction_written("20"), 0); },
                          {"10 and 20 degrees"});
}
