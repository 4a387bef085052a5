#include "expect_error.h"
#include "io/files/file.h"
#include "responses/response_csv.h"
#include "responses/response_hdf5.h"
#include "responses/summary.h"
#include "temporary_folder.h"
#include <cmath>
#include <csignal>
#include <sys/resource.h>
#include <thread>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

Response example(std::size_t n = 200) {
  Response r;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 0.01 * static_cast<double>(i) / 3;
    r.append("time", t);
    for (const char *name : {"displacement_x", "displacement_y", "displacement_z", "velocity_x", "velocity_y",
                             "force_x", "force_y", "force_z", "impact_x", "impact_y", "gap", "energy_plastic"})
      r.append(name, std::sin(t + name[0] + name[9 % std::string(name).size()]));
  }
  r.meta["version"] = "1.2.3";
  r.meta["scene"] = "name = \"é\"\n";
  r.meta["empty"] = "";
  return r;
}

TEST(Response, KnowsItsSignals) {
  Response r;
  EXPECT_THROW(r.append("dispalcement_x", 1), std::logic_error);
  EXPECT_THROW(std::as_const(r).series("gap"), DataError);
  EXPECT_EQ(r.size(), 0u);
  EXPECT_EQ(known_signals().front().name, "time");
  for (const auto &signal : known_signals()) EXPECT_FALSE(signal.units.empty() || signal.description.empty());
}

TEST(Response, RefusesUnevenAndNotFiniteSeries) {
  Response r = example();
  EXPECT_NO_THROW(r.check());
  r.append("gap", 1);
  EXPECT_THROW(r.check(), std::logic_error);
  r = example();
  r.series("gap")[3] = NAN;
  const TemporaryFolder folder;
  EXPECT_THROW(write_hdf5(r, folder / "r.h5"), std::logic_error);
  EXPECT_EQ(folder.n_files(), 0u);
}

TEST(ResponseHdf5, ReadsBackExactly) {
  const TemporaryFolder folder;
  const Response r = example();
  write_hdf5(r, folder / "response.h5");
  const Response back = read_response(folder / "response.h5");
  EXPECT_EQ(back.all(), r.all());
  EXPECT_EQ(back.meta, r.meta);
  EXPECT_EQ(read_response(folder.path()).all(), r.all()) << "a run folder";
}

TEST(ResponseHdf5, ThreadsMayWriteAtOnce) {
  const TemporaryFolder folder;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      for (int i = 0; i < 5; ++i) write_hdf5(example(), folder / (std::to_string(k) + ".h5"));
    });
  for (auto &thread : threads) thread.join();
  for (int k = 0; k < 4; ++k) EXPECT_EQ(read_response(folder / (std::to_string(k) + ".h5")).size(), 200u);
}

TEST(ResponseHdf5, RefusesDamagedFiles) {
  const TemporaryFolder folder;
  write_hdf5(example(), folder / "r.h5");
  const std::string bytes = text_of(folder / "r.h5");
  for (const std::size_t kept :
       {std::size_t{0}, std::size_t{7}, std::size_t{8}, std::size_t{100}, bytes.size() / 2, bytes.size() - 1}) {
    const std::string path = folder.write("cut.h5", bytes.substr(0, kept));
    expect_error<DataError>([&] { read_response(path); }, {"cut.h5"});
  }
  expect_error<DataError>([&] { read_response(folder / "none.h5"); }, {"none.h5", "no such file"});
  const TemporaryFolder empty;
  expect_error<DataError>([&] { read_response(empty.path()); }, {"response.h5", "response.csv"});
}

TEST(ResponseCsv, HasTheContractsHeaderAndReadsBackExactly) {
  const TemporaryFolder folder;
  const Response r = example();
  write_csv(r, folder / "r.csv");
  const std::string text = text_of(folder / "r.csv");
  EXPECT_EQ(text.substr(0, text.find('\n')), "time_s,ux_m,uy_m,uz_m,Fx_N,Fy_N,Fz_N,Ix_N,Iy_N,gap_m");
  const Response back = read_response(folder / "r.csv");
  for (const char *name : {"time", "displacement_x", "displacement_z", "force_y", "impact_x", "impact_y", "gap"})
    EXPECT_EQ(back.series(name), r.series(name)) << name;
  EXPECT_FALSE(back.has("velocity_x"));
}

TEST(ResponseCsv, ReadsALaboratorysFile) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string &text) { return read_response(folder.write("lab.csv", text)); };
  const Response r =
      read("\xEF\xBB\xBF# test 7\r\nFx_kN; time_s; ux_mm ;temperature\r\n1.5;0;10;cold\r\n2;0.1;20;cold\r\n");
  EXPECT_DOUBLE_EQ(r.series("force_x")[0], 1500);
  EXPECT_DOUBLE_EQ(r.series("displacement_x")[1], 0.02);
  EXPECT_EQ(r.series("displacement_y")[1], 0.0);
  EXPECT_FALSE(r.has("impact_x"));
  const std::string head = "time_s,ux_m,Fx_N\n";
  expect_error<DataError>([&] { read("time_s,ux_m\n0,1\n"); }, {"Fx_N", "missing"});
  expect_error<DataError>([&] { read("time_s,ux,Fx_N\n0,1,1\n"); }, {"\"ux\"", "unit"});
  expect_error<DataError>([&] { read("time_s,ux_inch,Fx_N\n0,1,1\n"); }, {"ux_inch", "ux_m"});
  expect_error<DataError>([&] { read("time_s,ux_m,ux_mm,Fx_N\n0,1,1,1\n"); }, {"twice"});
  expect_error<DataError>([&] { read(head + "0,1,1\n1,nan,1\n"); }, {"lab.csv:3", "nan"});
  expect_error<DataError>([&] { read(head + "0,1,1\n1,,1\n"); }, {"lab.csv:3"});
  expect_error<DataError>([&] { read(head + "0,1,1\n1,1\n"); }, {"lab.csv:3", "2 of 3"});
  expect_error<DataError>([&] { read(head + "0,1,1\n1,1,1\n0.5,1,1\n"); }, {"time falls from 1 s to 0.5 s"});
  expect_error<DataError>([&] { read(head); }, {"no instants"});
  expect_error<DataError>([&] { read(""); }, {"no header"});
}

/// Files longer than `bytes` cannot be written while it lives, as on a full disk.
class FullDisk {
public:
  explicit FullDisk(rlim_t bytes) {
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

private:
  rlimit before_{};
};

TEST(Writing, AFullDiskLeavesEarlierResults) {
  const TemporaryFolder folder;
  const Response earlier = example(20);
  write_hdf5(earlier, folder / "r.h5");
  write_csv(earlier, folder / "r.csv");
  write_atomically("earlier", folder / "t.txt");
  {
    const FullDisk full(4096);
    expect_error<IoError>([&] { write_hdf5(example(5000), folder / "r.h5"); }, {"r.h5", "File too large"});
    expect_error<IoError>([&] { write_csv(example(5000), folder / "r.csv"); }, {"r.csv"});
    expect_error<IoError>([&] { write_atomically(std::string(10000, 'x'), folder / "t.txt"); }, {"t.txt"});
  }
  EXPECT_EQ(read_response(folder / "r.h5").all(), earlier.all());
  EXPECT_EQ(read_response(folder / "r.csv").size(), 20u);
  EXPECT_EQ(text_of(folder / "t.txt"), "earlier");
  EXPECT_EQ(folder.n_files(), 3u) << "no temporary files are left";
  EXPECT_NO_THROW(write_hdf5(example(5000), folder / "r.h5")) << "and the library still works";
}

TEST(Writing, NamesAFolderThatIsNotThere) {
  expect_error<IoError>([] { write_atomically("x", "/no/such/folder/x.txt"); },
                        {"/no/such/folder/x.txt", "No such file"});
  expect_error<IoError>([] { write_hdf5(example(), "/proc/r.h5"); }, {"/proc/r.h5"});
}

} // namespace
