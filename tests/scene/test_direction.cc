// The one table of spellings of a record's direction.
#include "io/records/direction.h"
#include <gtest/gtest.h>

using namespace rimpact;

namespace {

constexpr auto vertical = DirectionKind::vertical, horizontal = DirectionKind::horizontal,
               unknown = DirectionKind::unknown;

struct Named {
  const char *stem, *station, *spelling;
  DirectionKind kind;
  std::optional<double> azimuth;
};

} // namespace

TEST(Direction, AtTheEndOfANameWithItsStation) {
  for (const auto &[stem, station, spelling, kind, azimuth] : {
           Named{"RSN1086_NORTHR_SYL090", "RSN1086_NORTHR_SYL", "090", horizontal, 90},
           Named{"RSN1086_NORTHR_SYL-UP", "RSN1086_NORTHR_SYL", "UP", vertical, {}},
           Named{"RSN1529_CHICHI_TCU102-E", "RSN1529_CHICHI_TCU102", "E", horizontal, 90},
           Named{"RSN2626_CHICHI.03_TCU075N", "RSN2626_CHICHI.03_TCU075", "N", horizontal, 360},
           Named{"RSN139_TABAS_DAY-L1", "RSN139_TABAS_DAY", "L1", horizontal, {}},
           Named{"RSN4207_NIIGATA_NIG017EW", "RSN4207_NIIGATA_NIG017", "EW", horizontal, 90},
           Named{"RSN6906_DARFIELD_GDLCN55W", "RSN6906_DARFIELD_GDLC", "N55W", horizontal, 305},
           Named{"RSN6906_DARFIELD_GDLCS35W", "RSN6906_DARFIELD_GDLC", "S35W", horizontal, 215},
           Named{"RSN6923_DARFIELD_KPOCS75E", "RSN6923_DARFIELD_KPOC", "S75E", horizontal, 105},
           Named{"RSN6953_DARFIELD_PRPCS", "RSN6953_DARFIELD_PRPC", "S", horizontal, 180},
           Named{"RSN2114_DENALI_PS10-047", "RSN2114_DENALI_PS10", "047", horizontal, 47},
           Named{"RSN172_IMPVALL.H_H-E12140", "RSN172_IMPVALL.H_H-E12", "140", horizontal, 140},
           Named{"RIO360", "RIO", "360", horizontal, 360},
           Named{"hill_e", "hill", "E", horizontal, 90},
           Named{"IT.AMT..HNE", "IT.AMT", "HNE", horizontal, 90},
           Named{"site-H1", "site", "H1", horizontal, {}},
       }) {
    const auto named = direction_in_name(stem);
    EXPECT_EQ(named.station, station) << stem;
    EXPECT_EQ(named.direction.spelling, spelling) << stem;
    EXPECT_EQ(named.direction.kind, kind) << stem;
    EXPECT_EQ(named.direction.azimuth_deg, azimuth) << stem;
  }
}

TEST(Direction, VerticalUnderManySpellings) {
  for (const char *ending : {"-UP", "_UP",  "UP",  "-DWN", "DWN",  "-DOWN", "UD",  "-UD",   "-V",       "_V",
                             "V",   "-VER", "VRT", "VER",  "VERT", "-VRT",  "_Z",  "-Z",    "-HNZ",     "-Up",
                             "dwn", "-DN",  "-U",  "Z",    "UD2",  "-V1",   "-VT", "-UPDO", "_Vertical"}) {
    const auto named = direction_in_name(std::string("RSN1_HELENA.A_A-HM7") + ending);
    EXPECT_EQ(named.direction.kind, vertical) << ending;
    EXPECT_EQ(named.station, "RSN1_HELENA.A_A-HM7") << ending;
  }
  for (const char *stem : {"RSN1_HELENA.A_A-HMCDWN", "RSN6906_DARFIELD_GDLCUP", "RSN9_A_BCV", "site_DWN", "TCU079V"})
    EXPECT_EQ(direction_in_name(stem).direction.kind, vertical) << stem;
}

TEST(Direction, OfNamesThatDoNotTellIt) {
  for (const char *stem : {"GROUP", "TOWNS", "elcentro", "quake", "N", "motion-1", "record12", "RSN", "", "a-hnx"}) {
    EXPECT_EQ(direction_in_name(stem).direction.kind, unknown) << stem;
    EXPECT_EQ(direction_in_name(stem).station, stem);
  }
  EXPECT_EQ(direction_in_name("site361").direction.kind, unknown);
}

TEST(Direction, AsHeadersWriteIt) {
  for (const auto &[word, azimuth] : {std::pair{"0", 0.0},
                                      {"92", 92.0},
                                      {"360 Deg", 360.0},
                                      {"N", 360.0},
                                      {"E-W", 90.0},
                                      {"N 55 W", 305.0},
                                      {"S75E", 105.0},
                                      {"Comp: 270", 270.0},
                                      {"45\xC2\xB0", 45.0},
                                      {"HNN", 360.0},
                                      {"south", 180.0},
                                      {"Az. 12 degrees", 12.0}}) {
    EXPECT_EQ(direction_written(word).kind, horizontal) << word;
    EXPECT_EQ(direction_written(word).azimuth_deg, azimuth) << word;
  }
  for (const char *word : {"UP", "U-D", "Vertical", "HGZ", "Dwn", " v ", "Up-Down"})
    EXPECT_EQ(direction_written(word).kind, vertical) << word;
  for (const char *word : {"L", "Trans", "H2", "long"}) {
    EXPECT_EQ(direction_written(word).kind, horizontal) << word;
    EXPECT_FALSE(direction_written(word).azimuth_deg) << word;
  }
  for (const char *word : {"", "NA", "361", "-90.5", "N91E", "San Fernando", "4000", "made by hand"})
    EXPECT_EQ(direction_written(word).kind, unknown) << word;
}
