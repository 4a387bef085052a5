// The physical model of a slider between two dishes beside the rigid-body one, which knows slider, plates and contacts.
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::reduced {
namespace {

scene::Scene on_two_dishes(const std::vector<std::string> &settings) {
  std::vector<std::string> all{"bearing.name=dcfp-155", "reduced.k_i_kN_per_m=0", "reduced.normal_force=inertia"};
  all.insert(all.end(), settings.begin(), settings.end());
  return scene::load_scene("ricker-0.78g-1.0s", all);
}

/// The same bearing for the rigid-body model.
scene::Scene rigid(scene::Scene scene) {
  scene.reduced.model = scene::ModelKind::dcfp;
  scene.isolator.radius = scene.bearing.surface.R0, scene.isolator.slider_diameter = scene.bearing.slider.diameter;
  scene.isolator.top_height = scene.isolator.bottom_height = scene.bearing.slider.height / 2;
  scene.isolator.capacity = scene.bearing.lateral_capacity();
  scene.isolator.slider_mass = 1;
  return scene;
}

TEST(TwoDishes, APulseMovesWhatIsCarriedAsTheRigidBodiesDo) {
  for (const double scale : {0.4, 0.6}) {
    const scene::Scene scene = on_two_dishes({"excitation.scale=" + std::to_string(scale)});
    const Summary physical = simulate_summary(scene), bodies = simulate_summary(rigid(scene));
    ASSERT_LT(physical.peak_displacement, scene.lateral_capacity());
    EXPECT_NEAR(physical.peak_displacement / bodies.peak_displacement, 1, 0.005) << scale;
  }
}

TEST(TwoDishes, ASlowLoopIsTheClosedForm) {
  const scene::Scene scene = on_two_dishes({"excitation.kind=cyclic", "excitation.amplitude_m=0.2"});
  const ReducedRun run = simulate(scene);
  const double R_eff = 2 * scene.bearing.surface.R0 - scene.bearing.slider.height,
               mu = 2 * scene.bearing.surface.R0 / R_eff * scene.bearing.contact.steel_ertalyte;
  const auto &u = run.response.series("displacement_x"), &F = run.response.series("force_x");
  int compared = 0;
  for (std::size_t i = 1; i < run.response.size(); ++i) {
    const double way = u[i] - u[i - 1], theta = std::asin(u[i] / R_eff);
    if (std::abs(way) < 1e-6 || std::abs(u[i]) > 0.19) continue; // where it turns friction builds up
    const double expected = scene.load.vertical * std::tan(theta + std::copysign(std::atan(mu), way));
    EXPECT_NEAR(-F[i], expected, 0.005 * scene.load.vertical * std::tan(0.2 / R_eff)) << u[i];
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

} // namespace
} // namespace rimpact::reduced
