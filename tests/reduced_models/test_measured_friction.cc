// Friction by pressure, temperature and table, in the models that slide by it.
#include "../scene/temporary_folder.h"
#include "io/files/error.h"
#include "reduced_models/simulate.h"
#include "scene/bearing_catalogue.h"
#include "scene/toml_writer.h"
#include "scenes.h"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

namespace {

/// A strong pulse that keeps the slider near the vertex for a while, without a rim.
scene::Scene warm() {
  scene::Scene s = ricker(0.6, 5);
  s.reduced.k_i = 0;
  s.reduced.measured.by_temperature = true, s.reduced.measured.contact_radius = 0.3;
  return s;
}
std::string refusal(scene::Scene s) {
  try {
    s.validate();
  } catch (const InputError &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(MeasuredFriction, ByPressureIsOfTheNormalForce) {
  scene::Scene s = ricker();
  s.reduced.measured.reference_pressure = 20e6;
  for (const auto reading : {scene::NormalForce::inertia, scene::NormalForce::statics, scene::NormalForce::constant}) {
    s.reduced.normal_force = reading;
    const PhysicalModel model(s);
    BearingState state;
    state.u = {0.3, 0.2, model.height(0.3, 0.2).z}, state.v = {0.4, -0.5, 0};
    state.v[2] = model.height(0.3, 0.2).gradient.dot(state.v.head<2>());
    const auto forces = model.forces(state);
    const double mu = scene::sliding_law(s).under(forces.normal, state.v.norm(), 20).value;
    EXPECT_NEAR(forces.friction.norm() / forces.normal, mu, 1e-12) << word(reading);
    EXPECT_LT(forces.friction.dot(state.v), 0);
    EXPECT_NE(mu, s.reduced.mu_fast);
  }
}

TEST(MeasuredFriction, AtTheReferencePressureNothingChanges) {
  scene::Scene s = ricker(1.05);
  s.reduced.normal_force = scene::NormalForce::constant;
  const auto plain = simulate(s).summary;
  const double radius = scene::contact_radius(s);
  s.reduced.measured.reference_pressure = s.load.vertical / (std::numbers::pi * radius * radius);
  const auto by_pressure = simulate(s).summary;
  EXPECT_EQ(by_pressure.peak_displacement, plain.peak_displacement);
  EXPECT_EQ(by_pressure.impacts.size(), plain.impacts.size());
}

TEST(MeasuredFriction, ScaleMultipliesIt) {
  scene::Scene s = ricker(1.05), twice = s;
  twice.reduced.measured.scale = 2;
  set_friction(s, 2 * s.reduced.mu_fast);
  EXPECT_NEAR(simulate(twice).summary.peak_displacement, simulate(s).summary.peak_displacement, 1e-12);
}

namespace {

/// The signal against the convolution itself, by the rectangle rule with the kernel integrated over each interval.
/// Between two dishes each face takes half of it, over the way of a face.
void expect_heat_of_friction(const scene::Scene &s, double radius, double face_share) {
  const auto run = simulate(s);
  const auto &r = run.response;
  const auto &t = r.series("time"), &T = r.series("temperature"), &u = r.series("displacement_x");
  const auto power = [&](std::size_t i) {
    double sum = 0;
    for (const char *axis : {"x", "y"})
      sum -= r.series(std::string("friction_") + axis)[i] * r.series(std::string("velocity_") + axis)[i];
    return sum;
  };
  const friction::HeatSink sink;
  const double area = s.bearing.dishes() * std::numbers::pi * radius * radius,
               c = std::sqrt(sink.diffusivity / std::numbers::pi) / sink.conductivity;
  double warmest = 0;
  for (std::size_t end : {t.size() / 2, t.size() - 1}) {
    double rise = 0;
    for (std::size_t i = 0; i < end; ++i) {
      const double middle = (u[i] + u[i + 1]) / 2, flux = (power(i) + power(i + 1)) / 2 / area;
      if (!friction::passes_over(face_share * std::abs(middle), radius)) continue;
      rise += 2 * c * flux * (std::sqrt(t[end] - t[i]) - std::sqrt(t[end] - t[i + 1]));
    }
    EXPECT_NEAR(T[end] - 20, rise, 0.02 * rise + 0.02) << t[end];
    warmest = std::max(warmest, rise);
  }
  EXPECT_GT(warmest, 3);
  EXPECT_GE(run.summary.extra.at("friction").at("peak_temperature_C").get<double>(), 20 + warmest - 0.5);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-6);
}

} // namespace

TEST(MeasuredFriction, TheSteelTakesTheHeatOfTheFrictionThatActed) {
  expect_heat_of_friction(warm(), 0.3, 1);
  scene::Scene two = warm();
  two.bearing = scene::builtin_bearing("dcfp-155");
  expect_heat_of_friction(two, 0.3, two.bearing.surface.R0 / two.bearing.ridden_surface().R0);
}

TEST(MeasuredFriction, WarmSteelRubsLess) {
  scene::Scene cold = free_motion({0.3, 0}, {0, 0}, 2), s = cold; // let go: it swings to the other side
  s.reduced.measured.by_temperature = true, s.reduced.measured.heat.at_start = 200;
  const auto far_side = [](const scene::Scene &scene) {
    const auto run = simulate(scene);
    const auto &u = run.response.series("displacement_x");
    return -*std::min_element(u.begin(), u.end());
  };
  EXPECT_GT(far_side(s), 1.02 * far_side(cold));
}

TEST(MeasuredFriction, CvodeAgrees) {
  scene::Scene s = warm();
  s.reduced.measured.reference_pressure = 20e6;
  s.reduced.mu_slow = 0.03, s.reduced.rate = 30;
  const auto own = simulate(s), other = simulate_with_cvode(s);
  EXPECT_NEAR(own.summary.peak_displacement, other.summary.peak_displacement, 2e-5 * own.summary.peak_displacement);
  EXPECT_NEAR(own.summary.residual_displacement, other.summary.residual_displacement, 1e-4);
  EXPECT_NEAR(own.summary.extra.at("friction").at("peak_temperature_C").get<double>(),
              other.summary.extra.at("friction").at("peak_temperature_C").get<double>(), 0.05);
}

/// Friction over speed is the faces', which go R / R_eff as fast as what is carried; each has half the heat.
TEST(MeasuredFriction, BetweenTwoDishesTheSpeedIsThatOfAFace) {
  const auto law_of = [](const std::string &bearing) {
    return scene::sliding_law(scene::load_scene(
        "ricker-0.78g-1.0s", {"bearing.name=" + bearing, "reduced.mu_slow=0.03", "reduced.rate_s_per_m=20"}));
  };
  const friction::FrictionLaw one = law_of("fps-225"), two = law_of("dcfp-155");
  const double R = 1.55, effective = 2 * R - 0.1, speed = 0.04;
  EXPECT_EQ(one.faces, 1);
  EXPECT_EQ(two.faces, 2);
  const double of_a_face = 0.05 - 0.02 * std::exp(-20 * speed * R / effective);
  EXPECT_NEAR(two.at({.speed = speed}).value, 2 * R / effective * of_a_face, 1e-12);
  EXPECT_NEAR(one.at({.speed = speed}).value, 0.07 - 0.04 * std::exp(-20 * speed), 1e-12);
  const double h = 1e-6, slope = (two.at({.speed = speed + h}).value - two.at({.speed = speed - h}).value) / (2 * h);
  EXPECT_NEAR(two.at({.speed = speed}).d_speed, slope, 1e-8);
}

TEST(MeasuredFriction, AFlightCarriesItsHeatOn) {
  scene::Scene s = warm();
  const PhysicalModel model(s);
  Response response;
  EnergyLedger ledger;
  const auto half = model.fly(model.initial_state(), 2.2, {}, response, ledger).state;
  const auto whole = simulate(s).summary, rest = simulate_from(s, half, 5).summary;
  EXPECT_NEAR(whole.residual_displacement, rest.residual_displacement, 1e-5);
  EXPECT_NEAR(whole.extra.at("friction").at("final_temperature_C").get<double>(),
              rest.extra.at("friction").at("final_temperature_C").get<double>(), 0.05);
}

TEST(MeasuredFriction, ATableIsRead) {
  const TemporaryFolder folder;
  const std::string file = folder.write("table_of_friction.csv", "speed_m_per_s,mu\n0,0.07\n1,0.07\n");
  const auto set = "reduced.mu_table=\"" + file + "\"";
  const auto s = scene::load_scene("ricker-0.78g-1.0s", {set});
  ASSERT_TRUE(s.reduced.measured.table);
  EXPECT_NEAR(simulate(s).summary.peak_displacement,
              simulate(scene::load_scene("ricker-0.78g-1.0s", {"reduced.mu_fast=0.07", "reduced.mu_slow=0.07"}))
                  .summary.peak_displacement,
              1e-12);
  const auto again = scene::parse_scene(to_toml(s), "again");
  EXPECT_EQ(again.reduced.measured.table_file, s.reduced.measured.table_file);
  EXPECT_TRUE(again.reduced.measured.table);
}

TEST(MeasuredFriction, WhatContradictsIsRefused) {
  scene::Scene s = ricker();
  s.reduced.measured.by_temperature = true;
  s.excitation.kind = ExcitationKind::cyclic, s.excitation.amplitude = 0.1;
  EXPECT_NE(refusal(s).find("reduced.mu_by_temperature needs a motion in time"), std::string::npos);
  s.reduced.measured.by_temperature = false;
  s.reduced.measured.reference_pressure = 1e6;
  s.reduced.measured.table = std::make_shared<const friction::FrictionTable>(
      std::vector<double>{0}, std::vector<double>{1e6, 2e6}, std::vector<double>{0.1, 0.1});
  EXPECT_NE(refusal(s).find("reduced.mu_reference_pressure_MPa 1 stands beside"), std::string::npos);
  s.reduced.measured = {};
  EXPECT_EQ(refusal(s), "");
}

TEST(Bounds, TheEuropeanProductTakesItsFourFactorsAndRefusesToGuessThem) {
  const auto bounds = [](std::vector<std::string> more) {
    more.insert(more.begin(), "bounds.standard=en-15129");
    return scene::load_scene("ricker-0.78g-1.0s", more).bounds;
  };
  try {
    bounds({"bounds.lambda_ageing=1.2", "bounds.lambda_travel=1"});
    FAIL() << "factors that the standard prints and nobody gave";
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("needs lambda_temperature, lambda_contamination:"), std::string::npos)
        << error.what();
  }
  const std::vector<std::string> given{"bounds.lambda_ageing=1.2",        "bounds.lambda_temperature=1.5",
                                       "bounds.lambda_contamination=1.1", "bounds.lambda_travel=1.0",
                                       "bounds.lambda_spec_max=1.1",      "bounds.lambda_spec_min=0.9"};
  const auto all = bounds(given);
  EXPECT_NEAR(all.factor(scene::Bound::upper), 1.2 * 1.5 * 1.1 * 1.1, 1e-12);
  EXPECT_EQ(all.factor(scene::Bound::lower), 0.9);
  EXPECT_FALSE(all.assumed());
  auto some = given;
  some.push_back("bounds.lambda_combination=0.5");
  EXPECT_NEAR(bounds(some).factor(scene::Bound::upper), 1.1 * 1.25 * 1.05 * 1.1, 1e-12);
  scene::Scene s = ricker();
  s.bounds = bounds(some);
  EXPECT_TRUE(scene::parse_scene(to_toml(s), "again").bounds == s.bounds);
}

TEST(Bounds, FactorsAreThePublishedProducts) {
  scene::FrictionBounds b;
  EXPECT_NEAR(b.factor(scene::Bound::upper), 2.12, 0.01);
  EXPECT_NEAR(b.factor(scene::Bound::lower), 0.60, 0.01);
  EXPECT_EQ(b.factor(scene::Bound::nominal), 1);
  EXPECT_TRUE(b.assumed());
  b.lambda_max = 1.5;
  EXPECT_EQ(b.factor(scene::Bound::upper), 1.5);
  b.lambda_max = 0.5;
  EXPECT_THROW(b.validate(), InputError);
  scene::Scene s = ricker();
  s.bounds.lambda_max = 1.4;
  const auto upper = at_bound(s, scene::Bound::upper);
  EXPECT_DOUBLE_EQ(scene::sliding_law(upper).at({}).value, 1.4 * s.reduced.mu_fast);
  const auto again = scene::parse_scene(to_toml(upper), "again");
  EXPECT_DOUBLE_EQ(again.reduced.measured.scale, 1.4);
  EXPECT_TRUE(again.bounds == s.bounds);
}
