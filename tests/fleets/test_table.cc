#include "../scene/expect_error.h"
#include "../scene/temporary_folder.h"
#include "io/files/table.h"
#include "io/files/table_csv.h"
#include "io/files/table_hdf5.h"
#include <cmath>
#include <filesystem>
#include <limits>

using namespace rimpact;

TEST(Table, ReadsBackExactly) {
  const TemporaryFolder folder;
  const Table t{{"run", "text", "value_m"},
                {{1.0, std::string("a, \"b\"; c"), 0.1 + 0.2},
                 {2.0, Cell{}, Cell{}},
                 {3.0, std::string(""), -1e-300},
                 {4.0, std::string("12"), std::numeric_limits<double>::max()}},
                {}};
  write_csv(t, folder / "t.csv");
  const Table r = read_table(folder / "t.csv");
  EXPECT_EQ(r.columns, t.columns);
  EXPECT_EQ(r.rows, t.rows);
}

TEST(Table, RefusesWhatIsNotFinite) {
  const TemporaryFolder folder;
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Table t{{"x"}, {{bad}}, {}};
    EXPECT_THROW(write_csv(t, folder / "t.csv"), std::logic_error);
    EXPECT_THROW(write_hdf5(t, folder / "t.h5"), std::logic_error);
  }
  EXPECT_EQ(folder.n_files(), 0u);
}

TEST(Table, DamageIsNamedWithItsLine) {
  const TemporaryFolder folder;
  const auto refused = [&](const char *text, std::initializer_list<const char *> words) {
    const auto path = folder.write("t.csv", text);
    expect_error<DataError>([&] { read_table(path); }, words);
  };
  refused("", {"t.csv", "empty"});
  refused("a,b\n1,2\n3\n", {"t.csv:3", "2 cells"});
  refused("a,b\n1,2,3\n", {"t.csv:2"});
  refused("a\nword\n", {"t.csv:2", "word"});
  refused("a\n\"open\n", {"t.csv:2", "quote"});
  refused("a\nnan\n", {"t.csv:2", "nan"});
}

/// What h5py and pandas make of them: tests/app/test_sweep.py, test_reliability.py.
TEST(Table, HasTheShapeOfItsColumns) {
  const Table t{{"run", "text", "empty"}, {{1.0, std::string("aé"), Cell{}}, {2.0, std::string(), Cell{}}}, {}};
  const TableShape shape = shape_of(t);
  EXPECT_EQ(shape.n_rows, 2u);
  EXPECT_EQ(shape.columns, (std::vector<std::pair<std::string, std::size_t>>{{"run", 0}, {"text", 3}, {"empty", 0}}));
}

TEST(Table, OfManyRowsIsPacked) {
  const TemporaryFolder folder;
  Table t{{"run", "status"}, {}, {}};
  constexpr int n = 40'000; // more than one piece
  for (int i = 0; i < n; ++i) t.rows.push_back({1.0 * i, std::string(i == 17 ? std::string(300, 'x') : "done")});
  write_hdf5(t, folder / "t.h5");
  EXPECT_LT(std::filesystem::file_size(folder / "t.h5"), 8u * n) << "numbers alone would take that";
}

/// Keys with commas and quotes, as a sweep over variable."a,b" has them.
TEST(Table, NamesWithCommasAndQuotesComeBack) {
  const TemporaryFolder folder;
  const Table t{{"run", "variable.\"a,b\"", "\"", "x"}, {{1.0, 2.0, std::string("a"), Cell{}}}, {}};
  write_csv(t, folder / "t.csv");
  EXPECT_EQ(read_table(folder / "t.csv").columns, t.columns);
}
