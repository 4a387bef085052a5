// Whether a record is ground motion: what is odd about its numbers, and its baseline.
#include "io/records/record.h"
#include "io/records/record_doubts.h"
#include "io/records/scaled_copies.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <random>

using namespace rimpact;

namespace {

constexpr double g = 9.81;

/// Thirty seconds of noise of 1 to 10 Hz under a smooth envelope that leaves neither speed nor travel.
SampledSignal shaking(double peak_g = 0.3) {
  SampledSignal record{0.01, std::vector<double>(3001, 0.0)};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> phase(0, 2 * M_PI), hertz(1, 10);
  for (int k = 0; k < 40; ++k) {
    const double p = phase(random), f = hertz(random);
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      const double t = 0.01 * static_cast<double>(i);
      record.values[i] += std::sin(2 * M_PI * f * t + p) * std::pow(std::sin(M_PI * t / 30), 4);
    }
  }
  double largest = 0;
  for (const double a : record.values) largest = std::max(largest, std::abs(a));
  for (double &a : record.values) a *= peak_g * g / largest;
  return record;
}
SampledSignal changed(const std::function<double(double, double)> &change) {
  auto record = shaking();
  for (std::size_t i = 0; i < record.values.size(); ++i)
    record.values[i] = change(record.values[i], 0.01 * static_cast<double>(i));
  return record;
}
bool is_doubted(const SampledSignal &record, const std::string &words) {
  const auto found = record_doubts(record, g);
  return std::any_of(found.begin(), found.end(), [&](const auto &d) { return d.find(words) != std::string::npos; });
}

} // namespace

TEST(RecordDoubts, OneForEachDamageAndNoneWithout) {
  EXPECT_TRUE(record_doubts(shaking(), g).empty());
  EXPECT_TRUE(is_doubted(changed([](double a, double) { return a + 0.02 * g; }), "an offset of 0.19"));
  EXPECT_TRUE(is_doubted(changed([](double a, double t) { return a + 1e-4 * g * t; }), "it ends at"));
  EXPECT_TRUE(is_doubted(changed([](double a, double) { return std::clamp(a, -0.2 * g, 0.2 * g); }), "saturated?"));
  EXPECT_TRUE(is_doubted(changed([](double a, double) { return a * 9.81; }), "is the unit right"));
  EXPECT_TRUE(is_doubted(changed([](double a, double) { return a / 980.7; }), "are values in g taken"));
  const auto pulse = [](double t) { return std::sin(0.8 * M_PI * t) * std::pow(std::sin(M_PI * t / 30), 2); };
  EXPECT_TRUE(record_doubts(changed([&](double, double t) { return pulse(t); }), g).empty())
      << "made up, and no record";
  SampledSignal velocity = changed([&](double a, double t) { return a + 0.15 * g * pulse(t); });
  double v = 0;
  for (double &value : velocity.values) v += 0.01 * value, value = v;
  EXPECT_TRUE(is_doubted(velocity, "is it a velocity?"));
  double u = 0;
  for (double &value : velocity.values) u += 0.01 * value, value = u;
  EXPECT_TRUE(is_doubted(velocity, "is it a displacement?"));
  SampledSignal spectrum{0.04, {}};
  for (int i = 0; i < 100; ++i) spectrum.values.push_back(0.3 * g * std::exp(-0.04 * i));
  EXPECT_TRUE(is_doubted(spectrum, "have one sign"));
}

TEST(RecordDoubts, BaselineTakesAnOffsetAndAFallOfItOff) {
  const auto clean = shaking();
  auto record = changed([](double a, double t) { return a + 0.02 * g - 1e-3 * g * t; });
  EXPECT_GT(std::abs(baseline_drift(record).end_velocity), 1);
  const auto corrected = baseline_corrected(record);
  double off = 0;
  for (std::size_t i = 0; i < clean.values.size(); ++i)
    off = std::max(off, std::abs(corrected.values[i] - clean.values[i]));
  EXPECT_LT(off, 1e-3 * g) << "what the clean motion's own velocity leaves";
  EXPECT_LT(std::abs(baseline_drift(corrected).end_velocity), 0.05);
  EXPECT_TRUE(record_doubts(corrected, g).empty());
}

TEST(RecordDoubts, NoneOfPeersRecordsIsDoubted) {
  const char *named = std::getenv("RIMPACT_RECORDS");
  const std::filesystem::path folder = named ? named : RIMPACT_SHARED_RECORDS;
  if (!std::filesystem::is_directory(folder / "appendix_c")) GTEST_SKIP() << "the records of appendix C are not here";
  std::size_t n = 0;
  for (const auto &place : {folder, folder / "appendix_c"})
    for (const auto &entry : std::filesystem::directory_iterator(place)) {
      if (entry.path().extension() != ".AT2") continue;
      ++n;
      for (const auto &doubt : record_doubts(read_record(entry.path().string()), standard_gravity))
        ADD_FAILURE() << entry.path().filename() << ": " << doubt;
    }
  EXPECT_GT(n, 300u);
}

TEST(ScaledCopies, AreFoundByTheirFactor) {
  const auto one = std::make_shared<const SampledSignal>(shaking(0.3)),
             other = std::make_shared<const SampledSignal>(changed([](double a, double t) { return a * std::cos(t); }));
  auto doubled = shaking(0.3);
  for (double &a : doubled.values) a *= -2;
  const auto copies = scaled_copies({one, other, nullptr, std::make_shared<const SampledSignal>(doubled), one});
  EXPECT_FALSE(copies[0]);
  EXPECT_FALSE(copies[1]);
  ASSERT_TRUE(copies[3]);
  EXPECT_EQ(copies[3]->of, 0u);
  EXPECT_NEAR(copies[3]->factor, -2, 1e-12);
  EXPECT_EQ(copies[4]->of, 0u);
}
