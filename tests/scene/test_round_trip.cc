// What a scene or bearing writes, it reads back exactly.
#include "scene/bearing_catalogue.h"
#include "scene/scene_catalogue.h"
#include "scene/toml_writer.h"
#include "scene_text.h"
#include "temporary_folder.h"
#include <cmath>
#include <fmt/format.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

bool is_available(const std::string &name) {
  return find_builtin_scene(name)->needs.empty(); // not the user's records
}

/// A dish of 500 rows comes back from its own scene.toml, which reads on lines of bearable length.
TEST(RoundTrip, ALongTableComesBackFromItsOwnFile) {
  std::string radii = "0.0", heights = "0.0";
  for (int i = 1; i < 500; ++i) {
    const double r = 1.1 * i;
    radii += fmt::format(", {}", r),
        heights += fmt::format(", {:.9f}", 140.625 * (1 - std::sqrt(1 - r * r / (562.5 * 562.5))));
  }
  const Scene scene = scene_of("[bearing.surface]\nkind = \"table\"\nplanar_radius_mm = 520.0\nradius_mm = [" + radii +
                               "]\nheight_mm = [" + heights + "]\n");
  ASSERT_EQ(scene.bearing.surface.table_radius.size(), 500u);
  const std::string text = to_toml(scene);
  expect_same(scene, scene_of(text));
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\n', at), text.size());
    EXPECT_LT(end - at, 200u);
    at = end + 1;
  }
}

TEST(RoundTrip, EveryBuiltInRoundTripsExactly) {
  for (const auto &name : builtin_scene_names()) {
    if (!is_available(name)) continue;
    SCOPED_TRACE(name);
    const Scene scene = load_scene(name);
    EXPECT_EQ(scene.name, name);
    expect_same(scene, parse_scene(to_toml(scene), "scene.toml"));
    const bool is_static = name.starts_with("static");
    EXPECT_EQ(scene.model.rung, is_static ? Rung::rigid_dish : Rung::rim);
  }
  for (const auto &name : builtin_bearing_names()) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    EXPECT_EQ(load_bearing(folder.write("b.toml", to_toml(builtin_bearing(name)))), builtin_bearing(name));
    EXPECT_EQ(builtin_scene_text(name), to_toml(builtin_bearing(name)));
  }
}

TEST(RoundTrip, EveryOverrideRoundTripsExactly) {
  const std::vector<std::string> each{"bearing.name=fps-225",
                                      "bearing.surface.kind=sphere",
                                      "bearing.surface.kind=cone",
                                      "bearing.surface.kind=polynomial",
                                      "bearing.rim.height_mm=70.3",
                                      "bearing.slider.diameter_mm=230.1",
                                      "bearing.plate.base_mm=33.33",
                                      "bearing.rim.thickness_mm=17",
                                      "bearing.material.steel.yield_MPa=inf",
                                      "bearing.material.steel.tangent_modulus_MPa=0",
                                      "bearing.material.ertalyte.yield_MPa=90",
                                      "bearing.contact.pad_foot=frictional",
                                      "load.vertical_kN=1234.567",
                                      "load.mass_kg=1e5",
                                      "excitation.scale=1.05",
                                      "excitation.kind=cyclic",
                                      "excitation.kind=push",
                                      "excitation.kind=free",
                                      "excitation.kind=window",
                                      "excitation.direction_deg=37.5",
                                      "model.rung=full",
                                      "model.mesh=3",
                                      "model.step_ms=0.35",
                                      "model.rho_inf=1",
                                      "model.symmetry=whole",
                                      "reduced.k_i_kN_per_m=123456.789",
                                      "reduced.restitution=1.0",
                                      "reduced.friction=park-wen",
                                      "reduced.elastic_slip_mm=0.3",
                                      "reduced.mu_fast=0.1",
                                      "reduced.vertical_restitution=0.2",
                                      "reduced.finite_pad=true",
                                      "reduced.socket_friction=true",
                                      "reduced.tolerance=1e-7",
                                      "reduced.output_step_ms=1.7",
                                      "name='with \"quotes\" and \\ and \t'"};
  for (const auto &assignment : each) {
    SCOPED_TRACE(assignment);
    const Scene changed = load_scene("ricker-0.78g-1.0s", {assignment});
    EXPECT_NE(to_toml(changed), to_toml(load_scene("ricker-0.78g-1.0s")));
    expect_same(changed, parse_scene(to_toml(changed), "scene.toml"));
  }
  const Scene window = load_scene("impact-window", {"excitation.with=['weight','friction','ground']"});
  expect_same(window, parse_scene(to_toml(window), "scene.toml"));
}

} // namespace
