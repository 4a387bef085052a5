// The steel's law of the strain rate in files: its keys, what is refused, what it changes and what it leaves alone.
#include "expect_error.h"
#include "scene/rim_identity.h"
#include "scene/toml_writer.h"
#include "scene_text.h"
#include <algorithm>

namespace rimpact::scene {
namespace {

const std::string steel = "[load]\nvertical_kN = 853\n[excitation]\nkind = \"window\"\n[bearing.material.steel]\n";

TEST(SteelRate, IsReadWithItsConstantsAndWrittenBack) {
  const Scene mild = scene_of(steel + "rate = \"cowper-symonds\"\n");
  EXPECT_EQ(mild.bearing.steel.rate, (StrainRate{.model = RateModel::cowper_symonds, .D = 40, .q = 5}));
  EXPECT_EQ(in_words(mild.bearing.steel.rate), "cowper-symonds, D = 40 1/s, q = 5");
  const Scene tensile = scene_of(steel + "rate = \"cowper-symonds\"\nrate_D_per_s = 3200\nrate_q = 4.5\n");
  EXPECT_EQ(in_words(tensile.bearing.steel.rate), "cowper-symonds, D = 3200 1/s, q = 4.5");
  const Scene cook = scene_of(steel + "rate = \"johnson-cook\"\nrate_C = 0.014\nrate_reference_per_s = 0.5\n");
  EXPECT_EQ(in_words(cook.bearing.steel.rate), "johnson-cook, C = 0.014, reference 0.5 1/s");
  for (const Scene &scene : {mild, tensile, cook}) {
    expect_same(parse_scene(to_toml(scene), "again.toml"), scene);
    EXPECT_TRUE(scene.remarks.empty());
    EXPECT_TRUE(scene.bearing.steel.knows_rate());
  }
}

TEST(SteelRate, SteelWithoutOneIsDescribedAsEver) {
  const Scene none = scene_of(steel + "rate = \"none\"\n"), ever = scene_of(steel + "nu = 0.3\n");
  EXPECT_FALSE(none.bearing.steel.knows_rate());
  EXPECT_EQ(none.bearing, ever.bearing);
  EXPECT_EQ(to_toml(none).find("rate = "), std::string::npos);
  EXPECT_EQ(rim_identity(none.bearing), rim_identity(ever.bearing));
}

TEST(SteelRate, ALawOfARimIsNotThatOfAnotherRate) {
  const auto identity = [](const std::string &keys) { return rim_identity(scene_of(steel + keys).bearing); };
  const std::string mild = identity("rate = \"cowper-symonds\"\n");
  EXPECT_NE(mild, identity("rate = \"none\"\n"));
  EXPECT_NE(mild, identity("rate = \"cowper-symonds\"\nrate_D_per_s = 3200\n"));
  EXPECT_EQ(mild, identity("rate = \"cowper-symonds\"\nrate_D_per_s = 40\nrate_q = 5\n"));
}

TEST(SteelRate, ConstantsNobodyGaveAreAssumptions) {
  const auto assumed = [](const std::string &keys) {
    std::vector<std::string> list;
    for (const auto &[key, value] : assumptions(scene_of(steel + keys).bearing))
      if (key.find("steel.rate") != std::string::npos) list.push_back(key);
    return list;
  };
  using Keys = std::vector<std::string>;
  EXPECT_EQ(assumed("rate = \"none\"\n"), Keys{});
  EXPECT_EQ(assumed("rate = \"cowper-symonds\"\nrate_q = 5\n"), Keys{"material.steel.rate_D_per_s"});
  EXPECT_EQ(assumed("rate = \"johnson-cook\"\n"),
            (Keys{"material.steel.rate_C", "material.steel.rate_reference_per_s"}));
}

TEST(SteelRate, BadKeysAreRefused) {
  const auto refused = [](const std::string &keys, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { scene_of(steel + keys).validate(); }, words);
  };
  refused("rate = \"cowper-symmonds\"\n", {"rate", "cowper-symmonds", "did you mean \"cowper-symonds\""});
  refused("rate = 40\n", {"rate"});
  refused("rate_d_per_s = 40\n", {"unknown key", "did you mean \"rate_D_per_s\""});
  const std::string mild = "rate = \"cowper-symonds\"\n", cook = "rate = \"johnson-cook\"\n";
  refused(mild + "rate_D_per_s = 0\n", {"rate_D_per_s", "0", "> 0"});
  refused(mild + "rate_D_per_s = -40\n", {"rate_D_per_s", "-40", "> 0"});
  refused(mild + "rate_D_per_s = nan\n", {"rate_D_per_s", "nan"});
  refused(mild + "rate_q = 0.5\n", {"rate_q", "0.5", "1"});
  refused(cook + "rate_C = 0\n", {"rate_C", "> 0"});
  refused(cook + "rate_reference_per_s = inf\n", {"rate_reference_per_s", "inf"});
}

TEST(SteelRate, KeysThatNothingReadsAreSaid) {
  const auto said = [](const std::string &keys) {
    const auto remarks = scene_of(steel + keys).remarks;
    return remarks.size() == 1 ? remarks[0] : std::to_string(remarks.size()) + " remarks";
  };
  EXPECT_EQ(said("rate_D_per_s = 100\n").find("bearing.material.steel.rate_D_per_s is not read by this scene"), 0u)
      << said("rate_D_per_s = 100\n");
  EXPECT_NE(said("rate_D_per_s = 100\n").find("bearing.material.steel.rate \"none\""), std::string::npos);
  EXPECT_NE(said("rate = \"johnson-cook\"\nrate_q = 4\n").find("rate \"johnson-cook\""), std::string::npos);
  const std::string elastic = said("yield_MPa = inf\nrate = \"cowper-symonds\"\n");
  EXPECT_EQ(elastic.find("bearing.material.steel.rate is not read by this scene"), 0u) << elastic;
  EXPECT_NE(elastic.find("yield_MPa inf"), std::string::npos) << elastic;
}

} // namespace
} // namespace rimpact::scene
