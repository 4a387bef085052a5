#include "scene/case_description.h"
#include "scene/doubts.h"
#include "scene/new_case.h"
#include "scene/scene.h"
#include "scene/scene_catalogue.h"
#include "scene/toml_writer.h"
#include "temporary_folder.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

/// The text with the comment signs of keys taken away, but not those of sentences.
std::string uncommented(const std::string &text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    const auto equals = line.find(" = ");
    if (line.starts_with("# ") && equals != std::string::npos && line.find(' ', 2) == equals) line = line.substr(2);
    result += line + "\n";
    at = end + 1;
  }
  return result;
}

TEST(NewCase, EveryBuiltInSceneCanBeMadeRead) {
  for (const auto &name : builtin_scene_names()) {
    if (!find_builtin_scene(name)->needs.empty()) continue; // the user's records
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    const auto files = new_case("acme-r3", "shfps-225", name);
    const Scene original = load_scene(name);
    EXPECT_EQ(files.bearing.empty(), original.rigid_bodies());
    EXPECT_EQ(files.scene.find("bearing.toml") == std::string::npos, original.rigid_bodies());
    if (!files.bearing.empty()) folder.write("bearing.toml", files.bearing);
    const Scene made = load_scene(folder.write("scene.toml", files.scene));
    EXPECT_EQ(made.bearing_name(), original.rigid_bodies() ? original.bearing_name() : "acme-r3");
    EXPECT_NE(files.scene.find("[load]"), std::string::npos);
    EXPECT_NEAR(made.load.mass / original.load.mass, 1, 1e-4);
    EXPECT_EQ(made.load.vertical, original.load.vertical);
    Scene heavier =
        load_scene(folder / "scene.toml", {fmt::format("load.vertical_kN={}", 2e-3 * original.load.vertical)});
    EXPECT_NEAR(heavier.load.mass / original.load.mass, 2, 1e-3) << "no mass is forgotten";
    EXPECT_EQ(made.bearing.assumed.keys.count("rim.height_mm"), 1u) << "marks are the catalogue's";
    EXPECT_EQ(made.bearing.assumed.keys.count("slider.diameter_mm"), 0u);
    const std::string all = uncommented(files.scene);
    for (const char *key : {"k_i_kN_per_m", "restitution", "impact_exponent", "yield_force_kN", "unloading_gain",
                            "mu_fast", "tolerance", "calibration"})
      EXPECT_NE(all.find(std::string("\n") + key + " = "), std::string::npos) << key;
    EXPECT_EQ(all.find("fitted_from"), std::string::npos);
  }
}

TEST(NewCase, CommentedKeysAreTheDefaults) {
  const auto files = new_case("acme", "fps-225", "impact-window");
  EXPECT_NE(files.scene.find("# duration_s = 0.2"), std::string::npos) << files.scene;
  const TemporaryFolder folder;
  folder.write("bearing.toml", files.bearing);
  std::string all = uncommented(files.scene);
  for (const char *line : {"calibration = \"\"\n", "calibration = \"\" "})
    if (const auto at = all.find(std::string("\n") + line); at != std::string::npos)
      all.erase(at, all.find('\n', at + 1) - at);
  const Scene made = load_scene(folder.write("scene.toml", files.scene)),
              spelt = load_scene(folder.write("all.toml", all));
  Scene same = spelt;
  same.name = made.name;
  EXPECT_EQ(to_toml(same), to_toml(made));
}

TEST(CaseDescription, SaysWhatIsRunAndWhereItsNumbersComeFrom) {
  const std::string text = describe_case(load_scene("ricker-0.78g-1.0s", {"excitation.scale=1.05"}));
  for (const char *words : {"bearing: shfps-225, L_c = 400.0 mm", "W = 853 kN, m = 86952 kg",
                            "motion: ricker, scale 1.05, amplitude_g 0.78", "period_s 1",
                            "impact element: signed, k_i = 450000 kN/m, e = 0.65 (the thesis's pair for shfps-225)"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  const auto own =
      case_json(load_scene("impact-window", {"reduced.impact_law=elastoplastic", "reduced.yield_force_kN=814"}));
  EXPECT_EQ(own["impact_element"]["source"], "the scene");
  EXPECT_TRUE(own["impact_element"]["e"].is_null());
  EXPECT_EQ(own["motion"]["kind"], "window");
  EXPECT_EQ(own["motion"]["speed_m_per_s"], 0.1);
  EXPECT_EQ(own["load"]["mass_kg"], 86952);
}

} // namespace
