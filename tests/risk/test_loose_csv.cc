#include "../scene/expect_error.h"
#include "io/files/loose_csv.h"

using namespace rimpact;
using rimpact::LooseTable;

TEST(LooseCsv, CommasSemicolonsTabsAndAByteOrderMark) {
  const std::vector<std::string> columns{"rsn", "factor"};
  for (const char *text :
       {"\xEF\xBB\xBFrsn,factor\n31,0.55\n", "rsn;factor\r\n31;0,55\r\n", "remark\n\nrsn\tfactor\n31\t0,55",
        "-- a remark --\n rsn, factor ,\n31, 0.55 ,\n\nrsn,factor\n1,2\n"}) {
    const LooseTable table(text, "t.csv", columns);
    ASSERT_EQ(table.rows().size(), 1u) << text;
    EXPECT_EQ(table.text(table.rows()[0], "rsn"), "31");
    EXPECT_DOUBLE_EQ(table.number(table.rows()[0], "factor"), 0.55);
  }
}

TEST(LooseCsv, Utf16AsSpreadsheetsSaveIt) {
  std::string bytes = "\xFF\xFE";
  for (const char c : std::string("rsn\tfactor\r\n31\t0,55\r\n")) bytes += c, bytes += '\0';
  const LooseTable table(bytes, "t.csv", {"rsn", "factor"});
  EXPECT_DOUBLE_EQ(table.number(table.rows().at(0), "factor"), 0.55);
}

TEST(LooseCsv, APointAmongDecimalCommasStandsForThousands) {
  const LooseTable table("rsn;factor\n31;0,55\n32;1.250\n", "t.csv", {"rsn", "factor"});
  EXPECT_DOUBLE_EQ(table.number(table.rows()[0], "factor"), 0.55);
  expect_error<DataError>([&] { table.number(table.rows()[1], "factor"); }, {"t.csv:3", "1.250", "thousands"});
}

TEST(LooseCsv, QuotesKeepTheirSeparators) {
  const LooseTable table("rsn,event\n31,\"Chi-Chi, Taiwan \"\"06\"\"\"\n", "t.csv", {"rsn", "event"});
  EXPECT_EQ(table.text(table.rows()[0], "event"), "Chi-Chi, Taiwan \"06\"");
}

TEST(LooseCsv, RefusalsNameTheLine) {
  expect_error<DataError>([] { LooseTable("a,b\n1,2\n", "t.csv", {"rsn"}); }, {"t.csv", "no line", "rsn"});
  expect_error<DataError>([] { LooseTable("rsn,factor\n31,0,55\n", "t.csv", {"rsn"}); },
                          {"t.csv:2", "3 cells", "2", "semicolons"});
  expect_error<DataError>([] { LooseTable("rsn\n", "t.csv", {"rsn"}); }, {"no rows"});
  const LooseTable table("rsn,factor\n31,half\n", "t.csv", {"rsn"});
  expect_error<DataError>([&] { table.number(table.rows()[0], "factor"); }, {"t.csv:2", "factor", "half"});
}
