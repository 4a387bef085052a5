// Cells and numbers of tables as laboratories and spreadsheets write them.
#include "io/files/binary_kind.h"
#include "io/files/error.h"
#include "io/files/loose_cells.h"
#include "io/files/loose_csv.h"
#include "io/files/table_lines.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rimpact {
namespace {

using Cells = std::vector<std::string>;

TEST(LooseCells, CellsLoseQuotesAndBlanks) {
  EXPECT_EQ(cells_of("a, b ,c", ','), (Cells{"a", "b", "c"}));
  EXPECT_EQ(cells_of(R"("a";" b ";"c;d")", ';'), (Cells{"a", " b ", "c;d"}));
  EXPECT_EQ(cells_of(R"("say ""hi""", 2)", ','), (Cells{"say \"hi\"", "2"}));
  EXPECT_EQ(cells_of(R"("1,5" ,"2")", ','), (Cells{"1,5", "2"}));
  EXPECT_EQ(cells_of("", ','), (Cells{""}));
  EXPECT_EQ(cells_of("a,,", ','), (Cells{"a", "", ""}));
}

TEST(LooseCells, SeparatorIsStatedOrSeen) {
  EXPECT_EQ(stated_separator("sep=;"), ';');
  EXPECT_EQ(stated_separator("\"SEP=,\""), ',');
  EXPECT_FALSE(stated_separator("separator"));
  EXPECT_EQ(separator_of("t;x, y;F"), ';');
  EXPECT_EQ(separator_of("t\tx, y"), '\t');
  EXPECT_EQ(separator_of("\"t; s\",x"), ',');
}

TEST(LooseCells, Utf16BecomesUtf8) {
  const std::string little("\xFF\xFE\x41\x00\xE4\x00\xAC\x20\x3D\xD8\x00\xDE", 12);
  EXPECT_EQ(utf8_text(little, "t"), "A\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80");
  const std::string big("\xFE\xFF\x00\x41\x00\xE4", 6);
  EXPECT_EQ(utf8_text(big, "t"), "A\xC3\xA4");
  EXPECT_EQ(utf8_text("plain", "t"), "plain");
  EXPECT_THROW(utf8_text(std::string("\xFF\xFE\x41", 3), "t"), DataError);
  EXPECT_THROW(utf8_text(std::string("\xFF\xFE\x3D\xD8\x41\x00", 6), "t"), DataError);
}

TEST(LooseCells, OneDecimalSignAFile) {
  DecimalReader commas;
  EXPECT_EQ(commas.number("0,5", "t:1"), 0.5);
  EXPECT_EQ(commas.number("-1,5e-3", "t:1"), -1.5e-3);
  EXPECT_EQ(commas.number("7", "t:1"), 7);
  EXPECT_TRUE(commas.comma());
  EXPECT_THROW(commas.number("0.5", "t:2"), DataError);
  DecimalReader points;
  EXPECT_EQ(points.number("0.5", "t:1"), 0.5);
  EXPECT_FALSE(points.comma());
  EXPECT_THROW(points.number("0,5", "t:2"), DataError);
  EXPECT_FALSE(points.number("1.234,5", "t:2"));
  EXPECT_FALSE(points.number("word", "t:2"));
  EXPECT_FALSE(points.number("inf", "t:2"));
}

using namespace std::literals;

TEST(BinaryKind, WhatIsNoTextIsNamed) {
  EXPECT_EQ(binary_kind(""), "");
  EXPECT_EQ(binary_kind("t;x\n1;2\n"), "");
  EXPECT_EQ(binary_kind("\xFF\xFE\x41\0"sv), "");
  EXPECT_EQ(binary_kind("PK\3\4 a kind of header\n"), "a zip archive: unpack it");
  EXPECT_THAT(binary_kind("PK\3\4....xl/workbook.xml"), testing::StartsWith("an Excel workbook"));
  EXPECT_THAT(binary_kind("PK\3\4....mimetypeapplication/vnd.oasis.opendocument.spreadsheet"),
              testing::StartsWith("a LibreOffice spreadsheet"));
  EXPECT_THAT(binary_kind("\xD0\xCF\x11\xE0\xA1\xB1"sv), testing::StartsWith("an old Excel workbook"));
  EXPECT_THAT(binary_kind("\x89HDF\r\n"sv), testing::StartsWith("an HDF5 file"));
  EXPECT_THAT(binary_kind("t,x\n\0\0"sv), testing::StartsWith("no text"));
}

TEST(BinaryKind, EveryReaderOfTablesRefusesIt) {
  EXPECT_THROW(table_lines("%PDF-1.4", "t.csv"), DataError);
  EXPECT_THROW(LooseTable("\x1F\x8B\x08", "t.csv", {"a"}), DataError);
}

} // namespace
} // namespace rimpact
