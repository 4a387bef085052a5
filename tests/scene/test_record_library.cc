// Records kept between runs.
#include "io/records/record_library.h"
#include "temporary_folder.h"
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

using namespace rimpact;

namespace {

std::string record(double first) {
  return "time_s,acceleration_g\n0," + std::to_string(first) + "\n0.01,-0.2\n0.02,0.3\n";
}

} // namespace

TEST(RecordLibrary, ReadsOnceAndAsTheReaderDoes) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.csv", record(0.1));
  const auto one = shared_record(path), two = shared_record(path);
  EXPECT_EQ(one.get(), two.get());
  EXPECT_EQ(*one, read_record(path));
  EXPECT_EQ(*shared_record(path, 9.81), read_record(path, 9.81)); // of another gravity: another record
  EXPECT_EQ(*shared_record("builtin:near-fault-x"), read_record("builtin:near-fault-x"));
}

TEST(RecordLibrary, AFileWrittenSinceIsReadAgain) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.csv", record(0.1));
  const auto before = shared_record(path);
  folder.write("a.csv", record(0.25));
  std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(2));
  EXPECT_EQ(shared_record(path)->values[0], read_record(path).values[0]);
  EXPECT_NE(shared_record(path)->values[0], before->values[0]); // who holds the old one keeps it
  std::filesystem::remove(path);
  EXPECT_ANY_THROW(shared_record(path));
}

TEST(RecordLibrary, ManyThreadsShareOneRecord) {
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  for (int i = 0; i < 8; ++i) paths.push_back(folder.write(std::to_string(i) + ".csv", record(0.1 * i)));
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&] {
      for (int round = 0; round < 200; ++round)
        for (int i = 0; i < 8; ++i)
          EXPECT_NEAR(shared_record(paths[static_cast<std::size_t>(i)])->values[0], 0.1 * i * standard_gravity, 1e-5);
    });
}
