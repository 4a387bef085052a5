#include "io/files/choice.h"
#include "scene/scene.h"
#include <gtest/gtest.h>
#include <set>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

template <class E> class Choices : public testing::Test {};
using All = testing::Types<ExcitationKind, Rung, Symmetry, ModelKind, Friction, NormalForce, PadFoot, SurfaceKind,
                           Space, RimTouch, PlateRotation, StructureKind, LengthUnit>;
TYPED_TEST_SUITE(Choices, All);

TYPED_TEST(Choices, EveryValueHasOneWordThatReadsBack) {
  std::set<std::string> seen;
  int next = 0;
  for (const auto &choice : choices(TypeParam{})) {
    EXPECT_EQ(static_cast<int>(choice.value), next++) << "a line a value, in their order";
    EXPECT_EQ(word(choice.value), choice.word);
    EXPECT_EQ(parse<TypeParam>(choice.word), choice.value);
    EXPECT_TRUE(seen.insert(choice.word).second);
  }
  EXPECT_EQ(words<TypeParam>().size(), seen.size());
  EXPECT_FALSE(parse<TypeParam>(""));
  EXPECT_FALSE(parse<TypeParam>("no such word"));
}

TEST(Choice, TheTableInALineNamesWordsAndWhatTheyMean) {
  EXPECT_STREQ(words_in_line<Rung>(), "rim | rigid-dish | full");
  EXPECT_STREQ(words_in_line<PlateRotation>(), "fixed: held by what it carries | free");
}

} // namespace
