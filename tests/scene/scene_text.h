/// Scenes from text, and whether two of them say the same.
#pragma once
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include <gtest/gtest.h>

namespace rimpact::scene {

inline Scene scene_of(const std::string &text, const std::vector<std::string> &overrides = {}) {
  return parse_scene(text, "my.toml", overrides);
}

/// Everything a scene says, compared field by field where it has an ==, by text for the settings.
inline void expect_same(const Scene &a, const Scene &b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.bearing, b.bearing);
  EXPECT_EQ(a.load.vertical, b.load.vertical);
  EXPECT_EQ(a.load.mass, b.load.mass);
  EXPECT_EQ(a.excitation.x, b.excitation.x);
  EXPECT_EQ(a.excitation.travel, b.excitation.travel);
  EXPECT_EQ(a.reduced.elastic_slip, b.reduced.elastic_slip);
  EXPECT_EQ(a.reduced.k_i, b.reduced.k_i);
  EXPECT_EQ(to_toml(a), to_toml(b));
}

} // namespace rimpact::scene
