#include "io/files/binary_kind.h"

#include "io/files/error.h"
#include <array>
#include <fmt/format.h>

namespace rimpact {
namespace {

struct Kind {
  std::string_view begins, holds, words;
};
using namespace std::literals;
/// The first that fits counts. `holds` stands in the first kilobytes.
constexpr std::array kinds = {
    Kind{"PK\3\4"sv, "xl/"sv, "an Excel workbook: save its sheet as CSV"sv},
    Kind{"PK\3\4"sv, "[Content_Types].xml"sv, "an Excel workbook: save its sheet as CSV"sv},
    Kind{"PK\3\4"sv, "opendocument.spreadsheet"sv, "a LibreOffice spreadsheet: save its sheet as CSV"sv},
    Kind{"PK\3\4"sv, ""sv, "a zip archive: unpack it"sv},
    Kind{"\xD0\xCF\x11\xE0"sv, ""sv, "an old Excel workbook: save its sheet as CSV"sv},
    Kind{"\x1F\x8B"sv, ""sv, "compressed by gzip: unpack it"sv},
    Kind{"%PDF"sv, ""sv, "a PDF document: ask for its numbers as CSV"sv},
    Kind{"MATLAB 5.0 MAT-file"sv, ""sv, "a MATLAB file: write its columns as CSV, writetable does"sv},
    Kind{"\x89HDF"sv, ""sv, "an HDF5 file: write its columns as CSV, h5dump or pandas do"sv},
    Kind{"PAR1"sv, ""sv, "a Parquet file: write its columns as CSV, pandas does"sv},
    Kind{"TDSm"sv, ""sv, "a LabVIEW TDMS file: write its channels as CSV"sv}};

} // namespace

std::string binary_kind(std::string_view bytes) {
  constexpr std::size_t looked_at = 8192;
  const std::string_view head = bytes.substr(0, looked_at);
  for (const Kind &kind : kinds)
    if (bytes.starts_with(kind.begins) && head.find(kind.holds) != std::string_view::npos)
      return std::string(kind.words);
  const bool utf_16 = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
  return !utf_16 && head.find('\0') != std::string_view::npos ? "no text: write its columns as CSV" : "";
}

void refuse_binary(std::string_view bytes, const std::string &path) {
  if (const std::string kind = binary_kind(bytes); !kind.empty())
    throw DataError(fmt::format("{}: is {}; a table is read from text", path, kind));
}

} // namespace rimpact
