#include "calibration/calibration_json.h"
#include "calibration/opensees.h"
#include "reduced_models/impact_law.h"
#include "scene/error.h"
#include "synthetic.h"
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

RimSprings springs(const std::string &law) {
  return {.law = law,
          .k_i = 3e8,
          .restitution = 0.4,
          .damping = 2e6,
          .mass = 86952,
          .lateral_capacity = 0.4,
          .exponent = 1.5,
          .reference_speed = 0.5,
          .yield_force = 9e5,
          .hardening = 0.1};
}

TEST(OpenSees, HoldsTheValuesAndTheLawsMaterial) {
  for (const auto &[law, material] : {std::pair{"signed", "ViscoelasticGap\", tag, 300000000, 2000000, -0.4"},
                                      std::pair{"elastoplastic", "ElasticPPGap\", tag, 300000000, -"},
                                      std::pair{"hunt-crossley", "Hertzdamp\", tag, 9486832981,"}}) {
    const auto python = opensees_python(springs(law), 2);
    EXPECT_NE(python.find(material), std::string::npos) << python;
    EXPECT_NE(python.find("m1 = 86952"), std::string::npos);
    EXPECT_NE(opensees_tcl(springs(law), 2).find("set k_i 300000000;"), std::string::npos);
  }
  EXPECT_THROW(opensees_tcl(springs("printed"), 2), DataError);
  EXPECT_THROW(opensees_tcl(springs("signed"), 1), InputError);
  EXPECT_THROW(opensees_tcl(springs("signed"), 3), InputError);
}

TEST(OpenSees, HertzdampIsTheHuntCrossleyLawAtItsReferenceSpeed) {
  // its force (Kh + xiNorm Kh / v0 v) d^n, against ours at an approach speed of v0
  scene::ReducedSettings settings;
  settings.impact_law = "hunt-crossley", settings.k_i = 3e8, settings.restitution = 0.4;
  settings.impact_exponent = 1.5, settings.reference_speed = 0.5;
  const auto rim = reduced::rim_element(settings, 86952);
  const double Kh = 3e8 * std::pow(1e-3, -0.5), xi_norm = rim.dissipation * 0.5, d = 2e-3, v = 0.3;
  EXPECT_NEAR(rim.at({.d = d, .rate = v}).force, (Kh + xi_norm * Kh / 0.5 * v) * std::pow(d, 1.5), 1e-6);
  const auto text = opensees_python(springs("hunt-crossley"), 2);
  EXPECT_NE(text.find(fmt::format("{:.10g}, -0.4, 1.5", xi_norm)), std::string::npos) << text;
}

TEST(OpenSees, BilinearSpringStopsTheMassAsTheFittedLawDoes) {
  auto s = window(0.5, 9e8);
  s.reduced.impact_law = "elastoplastic", s.reduced.yield_force = 6e5, s.reduced.hardening = 0.2;
  const auto impact = reduced::simulate(s).summary.impacts.at(0);
  auto r = springs("elastoplastic");
  r.k_i = 9e8, r.yield_force = 6e5, r.hardening = 0.2;
  const auto [corner, hardening] = bilinear_of(r);
  const double d = impact.peak_penetration, beyond = d - corner / r.k_i,
               force = corner + hardening * r.k_i * beyond;
  EXPECT_NEAR(force / impact.peak_force, 1, 1e-3);
  EXPECT_NEAR((corner * corner / r.k_i + beyond * (corner + force)) / (r.mass * 0.25), 1,
              1e-3);   // 2 W = m v^2
  r.yield_force = 1e9; // never yields: left as it is
  EXPECT_EQ(bilinear_of(r).yield_force, 1e9);
}

TEST(OpenSees, PolygonErrorAgainstClosedForms) {
  // a square touched along its diagonal; four springs, at most two of which act
  EXPECT_NEAR(polygon_error(4, 0.4, 1e-3).gap, 0.4 * (std::sqrt(2) - 1), 1e-12);
  EXPECT_NEAR(polygon_error(4, 0.4, 1e-3).force, 1, 1e-12); // not touched at all on the diagonal
  // many springs: k sum over the arc, 2 int_0^a (u cos t - L) cos t dt / (2 pi / n)
  const double L = 0.4, d = 5e-3, u = L + d, a = std::acos(L / u);
  const int n = 3600;
  const double sum = n / (2 * M_PI) * (u * (a + std::sin(2 * a) / 2) - 2 * L * std::sin(a));
  EXPECT_NEAR(polygon_error(n, L, d).force / (sum / d - 1), 1, 1e-3);
}

TEST(OpenSees, ReadsWhatACalibrationWrites) {
  TemporaryFolder folder;
  const auto json = to_json(calibrate({folder.write(window(0.3))}));
  const auto rim = rim_springs(json);
  EXPECT_EQ(rim.law, "signed");
  EXPECT_NEAR(rim.k_i / 3e8, 1, 1e-6);
  EXPECT_NEAR(rim.damping, reduced::damping_coefficient(rim.k_i, rim.restitution, rim.mass), 1);
  EXPECT_DOUBLE_EQ(rim.lateral_capacity, 0.4);
  EXPECT_THROW(rim_springs(nlohmann::json::object()), DataError);
  const auto text = opensees_tcl(rim, 2);
  EXPECT_NE(text.find("# Fitted: k_i = "), std::string::npos) << text;
  EXPECT_NE(text.find("95 % interval"), std::string::npos) << text;
  EXPECT_NE(text.find("# Validity: "), std::string::npos) << text;
}

} // namespace
} // namespace rimpact::calibration
