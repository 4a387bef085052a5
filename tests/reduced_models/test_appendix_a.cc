// The thesis's appendix A: several amplitudes in one run, friction by the path's speed, and one dish for two.
#include "io/files/file.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace rimpact;
using namespace rimpact::reduced;

namespace {

constexpr double weight = 90e3; ///< [N]

scene::Scene tested(const std::vector<std::string> &settings) {
  std::vector<std::string> all{"bearing.name=\"shfps-appendix-a\"", "model.rung=\"rim\"", "load.vertical_kN=90",
                               "load.mass_kg=9174"};
  all.insert(all.end(), settings.begin(), settings.end());
  return scene::load_scene("static-unidirectional", all);
}

double force_at(const Response &r, double u, bool loading) {
  const auto &x = r.series("displacement_x"), &f = r.series("force_x");
  for (std::size_t i = 1; i < x.size(); ++i)
    if ((loading ? x[i - 1] <= u && u <= x[i] : x[i - 1] >= u && u >= x[i]) && x[i] != x[i - 1])
      return -(f[i - 1] + (u - x[i - 1]) / (x[i] - x[i - 1]) * (f[i] - f[i - 1]));
  return NAN;
}

} // namespace

TEST(AppendixA, ThreeAmplitudesInOneRunAreThreeRuns) {
  const auto all = simulate(tested({"excitation.amplitudes_m=[0.0225,0.045,0.09]", "excitation.cycles=3"}));
  const auto &u = all.response.series("displacement_x"), &f = all.response.series("force_x");
  EXPECT_NEAR(*std::max_element(u.begin(), u.begin() + 6001), 0.0225, 1e-12);
  EXPECT_NEAR(*std::max_element(u.begin(), u.begin() + 12001), 0.045, 1e-12);
  EXPECT_NEAR(*std::max_element(u.begin(), u.end()), 0.09, 1e-12);
  const auto last = simulate(tested({"excitation.amplitude_m=0.09", "excitation.cycles=3"}));
  const auto &alone = last.response.series("force_x");
  ASSERT_EQ(u.size(), 18001u);
  for (std::size_t i = 12001; i < u.size(); ++i) EXPECT_NEAR(f[i], alone[i - 12000], 1e-9 * weight);
}

TEST(AppendixA, APathWithTimesHasTheFrictionOfItsSpeed) {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("rimpact_speed_" + std::to_string(::getpid()) + ".csv")).string();
  // Out at 0.2 m/s, back at 1 mm/s.
  write_atomically("time_s,x_mm\n0,0\n0.45,90\n180.45,-90\n", file);
  const std::vector<std::string> settings{"excitation.kind=\"path\"", "excitation.file=\"" + file + "\"",
                                          "reduced.mu_fast=0.07", "reduced.mu_slow=0.04", "reduced.rate_s_per_m=50"};
  const auto run = simulate(tested(settings));
  std::filesystem::remove(file);
  const auto closed = [](double u, double speed, double sign) {
    const double slope = 0.0432 * u / (0.18 * 0.18 * std::sqrt(1 - u * u / (0.18 * 0.18)));
    const double along = speed * std::sqrt(1 + slope * slope), mu = 0.07 - 0.03 * std::exp(-50 * along);
    return weight * std::tan(std::atan(slope) + sign * std::atan(mu));
  };
  EXPECT_NEAR(force_at(run.response, 0.06, true), closed(0.06, 0.2, 1), 1e-5 * weight);
  EXPECT_NEAR(force_at(run.response, 0.06, false), closed(0.06, 0.001, -1), 1e-5 * weight);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
}

/// Two like dishes and a weightless slider between them, by the rigid bodies: the bearing is alike when it is turned
/// by half a turn about the slider's middle, so both dishes are at the same slope. Half the travel is one dish's but
/// for the slider's tilt: d/2 = r - (h/2) sin theta. The slider's moments put the friction's lever into the force:
/// mu R/(R - h/2) takes mu's place.
TEST(AppendixA, OneDishAtHalfTheTravelIsHalfTheBearingButForTheSlidersHeight) {
  for (const double height : {0.004, 0.085}) {
    scene::Scene two;
    two.reduced.model = scene::ModelKind::dcfp;
    two.load.vertical = weight, two.load.mass = weight / 9.81;
    two.isolator.radius = 0.75, two.isolator.capacity = 0.25;
    two.isolator.slider_diameter = 0.10, two.isolator.top_height = two.isolator.bottom_height = height / 2;
    two.isolator.slider_mass = 0.01, two.isolator.contact_stiffness = 1e10;
    two.reduced.mu_fast = two.reduced.mu_slow = 0.07;
    two.excitation.kind = scene::ExcitationKind::cyclic, two.excitation.amplitude = 0.18;
    const auto both = simulate(two);
    const double R = 0.75, sine = 0.08 / (R - height / 2); // at a travel of 160 mm
    const double theta = std::asin(sine), lever = R / (R - height / 2);
    const double one_dish = weight * std::tan(theta + std::asin(std::sin(std::atan(0.07)) * lever));
    EXPECT_NEAR(force_at(both.response, 0.16, true), one_dish, 1e-3 * weight) << height;
    // With the slider's height left out, as one dish at half the travel has it.
    const double half = weight * std::tan(std::asin(0.08 / R) + std::atan(0.07));
    EXPECT_NEAR(half, one_dish, (height < 0.01 ? 1e-3 : 2e-2) * weight) << height;
  }
}
