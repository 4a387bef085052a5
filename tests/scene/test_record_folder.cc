// What a folder's records are: stations, directions, pairs, and what is asked about.
#include "expect_error.h"
#include "io/records/record.h"
#include "io/records/record_file.h"
#include "io/records/record_folder.h"
#include "temporary_folder.h"
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace rimpact;

namespace {

std::string at2(const std::string &title) {
  return "PEER\n" + title + "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .0100 SEC\n .1 .2 .1\n";
}
std::vector<std::string> files(const RecordFolder &folder, const std::vector<std::size_t> &records) {
  std::vector<std::string> names;
  for (const std::size_t i : records) names.push_back(folder.records[i].file);
  return names;
}
const Station *station(const RecordFolder &folder, const std::string &name) {
  const auto found =
      std::find_if(folder.stations.begin(), folder.stations.end(), [&](const auto &s) { return s.name == name; });
  return found == folder.stations.end() ? nullptr : &*found;
}
const FolderRecord &record(const RecordFolder &folder, const std::string &file) {
  return *std::find_if(folder.records.begin(), folder.records.end(), [&](const auto &r) { return r.file == file; });
}
using Names = std::vector<std::string>;

} // namespace

TEST(RecordFolder, HeadersComeBeforeNames) {
  const TemporaryFolder folder;
  folder.write("13.AT2", at2("Cape Mendocino, 4/25/1992, Petrolia, 0"));
  folder.write("14.AT2", at2("Cape Mendocino, 4/25/1992, Petrolia, 90"));
  folder.write("7.AT2", at2("Cape Mendocino, 4/25/1992, Petrolia, UP"));
  folder.write("RSN8_A_B360.AT2", at2("A, 1/1/2000, B, UP")); // its name says another direction
  folder.write("notes.md", "NPTS= 3 of no record");
  const auto read = read_record_folder(folder.path());
  ASSERT_EQ(read.records.size(), 4u);
  const auto *petrolia = station(read, "Cape Mendocino, 4/25/1992, Petrolia");
  ASSERT_TRUE(petrolia);
  EXPECT_TRUE(petrolia->is_pair());
  EXPECT_EQ(files(read, petrolia->horizontal), (Names{"13.AT2", "14.AT2"}));
  EXPECT_EQ(files(read, petrolia->vertical), Names{"7.AT2"});
  const auto &other = record(read, "RSN8_A_B360.AT2");
  EXPECT_EQ(other.direction.kind, DirectionKind::vertical);
  EXPECT_EQ(other.rsn, "8");
  ASSERT_EQ(other.doubts.size(), 1u);
  EXPECT_NE(other.doubts[0].find("direction UP, its name 360"), std::string::npos) << other.doubts[0];
  EXPECT_EQ(read.question(), "");
}

TEST(RecordFolder, NamesPartWhatOneHeaderHolds) {
  const TemporaryFolder folder;
  for (const char *name : {"RSN1_A090.AT2", "RSN1_A180.AT2", "RSN2_A090.AT2", "RSN2_A180.AT2"})
    folder.write(name, at2(fmt::format("Event, 1/1/2000, Array, {}", std::string(name).substr(6, 3))));
  const auto read = read_record_folder(folder.path());
  ASSERT_EQ(read.stations.size(), 2u);
  EXPECT_EQ(read.stations[1].name, "RSN2_A");
  EXPECT_TRUE(read.stations[1].is_pair());
}

TEST(RecordFolder, WhatIsNotToldIsAskedAbout) {
  const TemporaryFolder folder;
  folder.write("hill.AT2", at2("made up"));
  folder.write("hill-N.AT2", at2("made up"));
  folder.write("dale.AT2", at2("made up"));
  auto read = read_record_folder(folder.path());
  ASSERT_EQ(read.stations.size(), 1u);
  EXPECT_NE(read.question().find("dale.AT2, hill.AT2"), std::string::npos) << read.question();
  EXPECT_NE(read.question().find("--ask"), std::string::npos);

  EXPECT_NE(records_csv(read).find("\nhill-N.AT2,hill,N,\nhill.AT2,hill,,\n"), std::string::npos) << records_csv(read);
  folder.write("records.csv", "file;station;direction\nhill.AT2;hill;W\ndale.AT2;;none\n");
  read = read_record_folder(folder.path());
  EXPECT_EQ(read.question(), "");
  ASSERT_EQ(read.stations.size(), 1u);
  EXPECT_EQ(files(read, read.stations[0].horizontal), (Names{"hill.AT2", "hill-N.AT2"})); // 270 before 360
  EXPECT_TRUE(record(read, "dale.AT2").left_out);

  const auto refuse = [&](const std::string &row, std::initializer_list<const char *> words) {
    folder.write("records.csv", "file,station,direction\n" + row + "\n");
    expect_error<DataError>([&] { read_record_folder(folder.path()); }, words);
  };
  refuse("hil.AT2,,N", {"records.csv:2", "hil.AT2", "no record"});
  refuse("hill.AT2,,NNW", {"records.csv:2", "NNW", "0 to 360", "none"});
}

TEST(RecordFolder, ComponentsThatAreNotAtRightAnglesAreDoubted) {
  const TemporaryFolder folder;
  folder.write("A010.AT2", at2("made up"));
  folder.write("A040.AT2", at2("made up"));
  const auto read = read_record_folder(folder.path());
  for (const auto &each : read.records) {
    ASSERT_EQ(each.doubts.size(), 1u);
    EXPECT_NE(each.doubts[0].find("30 degrees apart"), std::string::npos);
  }
}

TEST(RecordFolder, ChannelsOfOneFileAreAStation) {
  const auto channel = [](int number, const std::string &direction) {
    std::string text =
        fmt::format("Corrected acceleration (Format v01.20)\nChn {}: {}\n 100  Real-header values follow on 17 "
                    "lines , Format = (6F13.6)\n",
                    number, direction);
    for (int i = 1; i <= 102; ++i) text += fmt::format("{:13.6f}", i == 62 ? 5.0 : -999.0) + (i % 6 == 0 ? "\n" : "");
    return text + "   4 acceleration pts, approx  0 secs, units=cm/s^2,Format=(8F10.5)\n" +
           fmt::format("{:10.5f}{:10.5f}{:10.5f}{:10.5f}\n", 1.0 * number, 2.0, 3.0, 4.0) +
           fmt::format("End-of-data for chan {} acceleration\n", number);
  };
  const TemporaryFolder folder;
  const std::string path = folder.write("hall.V2", channel(1, "360 Deg") + channel(2, "Up") + channel(3, "90 Deg"));
  const auto read = read_record_folder(folder.path());
  ASSERT_EQ(read.stations.size(), 1u);
  EXPECT_EQ(read.stations[0].name, "hall");
  EXPECT_EQ(files(read, read.stations[0].horizontal), (Names{"hall.V2#3", "hall.V2#1"}));
  EXPECT_EQ(files(read, read.stations[0].vertical), Names{"hall.V2#2"});
  EXPECT_NEAR(read_record(path + "#3").values[0], 0.03, 1e-12);
  expect_error<DataError>([&] { read_record(path); }, {"3 channels", "#1 (360)", "#2 (UP)", "hall.V2#1"});
  expect_error<DataError>([&] { read_record(path + "#4"); }, {"no channel 4"});
}

TEST(RecordFolder, KnetsEndingsAndKiknetsTwoInstruments) {
  const auto knet = [](const std::string &direction) {
    return "Origin Time       2011/03/11 14:46:00\nLat.              38.103\nStation Code      MYG004\nRecord Time     "
           "  "
           "2011/03/11 14:46:36\nSampling Freq(Hz) 100Hz\nDir.              " +
           direction + "\nScale Factor      3920(gal)/6182761\nMemo.\n    1000    3000    2000    2000\n";
  };
  const TemporaryFolder folder;
  for (const auto &[name, direction] : {std::pair{"MYG0041103111446.EW", "E-W"},
                                        {"MYG0041103111446.NS", "N-S"},
                                        {"MYG0041103111446.UD", "U-D"},
                                        {"KIK.NS1", "1"},
                                        {"KIK.EW1", "2"},
                                        {"KIK.NS2", "4"},
                                        {"KIK.EW2", "5"},
                                        {"KIK.UD2", "6"}})
    folder.write(name, knet(direction));
  const auto read = read_record_folder(folder.path());
  EXPECT_EQ(read.question(), "");
  ASSERT_EQ(read.stations.size(), 3u);
  for (const auto &each : read.stations) EXPECT_TRUE(each.is_pair()) << each.name;
  EXPECT_NE(record_label("a/MYG0041103111446.EW"), record_label("a/MYG0041103111446.NS"));
  EXPECT_EQ(record_label("a/RSN1_A090.AT2"), "RSN1_A090");
}

TEST(RecordFolder, RecordsOfPeerJoinedIntoOneFile) {
  const TemporaryFolder folder;
  const std::string path = folder.write("both.AT2", at2("E, 1/1/2000, S, 90") + "\n" + at2("E, 1/1/2000, S, 360") +
                                                        at2("E, 1/1/2000, S, UP"));
  const auto read = read_record_folder(folder.path());
  ASSERT_EQ(read.stations.size(), 1u);
  EXPECT_EQ(files(read, read.stations[0].horizontal), (Names{"both.AT2#1", "both.AT2#2"}));
  EXPECT_EQ(read_record(path + "#2").values.size(), 3u);
  expect_error<DataError>([&] { read_record(path); }, {"3 channels", "#2 (360)", "#3 (UP)"});
}

TEST(RecordFolder, NoFolderAndNoRecord) {
  const TemporaryFolder folder;
  expect_error<InputError>([&] { read_record_folder(folder / "nowhere"); }, {"nowhere", "cannot be read"});
  folder.write("a.md", "text");
  expect_error<InputError>([&] { read_record_folder(folder.path()).require_any(); }, {"holds no record"});
}

TEST(RecordFolder, EveryStationOfAppendixCIsAPair) {
  const std::string shelf = std::string(RIMPACT_SHARED_RECORDS) + "/appendix_c";
  if (!std::filesystem::exists(shelf)) GTEST_SKIP() << "the records of appendix C are not here";
  const auto read = read_record_folder(shelf);
  std::size_t pairs = 0, single = 0;
  for (const auto &each : read.stations) {
    pairs += each.is_pair(), single += each.horizontal.size() == 1;
    EXPECT_TRUE(each.vertical.empty()) << each.name;
  }
  EXPECT_EQ(pairs, 117u);
  EXPECT_EQ(single, 20u);
  EXPECT_EQ(read.records.size(), 254u);
  EXPECT_EQ(read.question(), "");
}
