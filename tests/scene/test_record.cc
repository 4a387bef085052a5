#include "expect_error.h"
#include "io/records/near_fault_pulse.h"
#include "io/records/record.h"
#include "temporary_folder.h"
#include <cmath>
#include <map>

namespace {
using namespace rimpact;

const std::string head = "PEER NGA STRONG MOTION DATABASE RECORD\nEvent, date, station, 90\n"
                         "ACCELERATION TIME SERIES IN UNITS OF G\n";
SampledSignal at2(const std::string &text) {
  return parse_at2(text, "test.AT2", 10.0);
}

TEST(At2, ReadsEveryHeaderMetInPractice) {
  for (const char *line :
       {"NPTS=      4, DT=   .0200 SEC,   0 POLE @    30.00000 HZ", "NPTS=  4, DT= .02000 SEC", "NPTS= 4 DT= 0.02",
        "npts = 4 , dt = 2.0E-2 sec", "    4    .0200    NPTS, DT", "NPTS=4,DT=.02SEC"}) {
    SCOPED_TRACE(line);
    const auto r = at2(head + line + "\n .1E+00 -.2 \n 3.0D-01 0\n");
    EXPECT_DOUBLE_EQ(r.dt, 0.02);
    ASSERT_EQ(r.values.size(), 4u);
    EXPECT_NEAR(r.values[0], 1, 1e-15);
    EXPECT_NEAR(r.values[1], -2, 1e-15);
    EXPECT_NEAR(r.values[2], 3, 1e-15);
  }
}

TEST(At2, ReadsFortransOddities) {
  const std::string line = "NPTS= 3, DT= .01 SEC\r\n";
  auto r = at2(head + line + "  .1000000E-01 -.2000000E-01 .3-100\r\n");
  EXPECT_NEAR(r.values[2], 0.3e-100 * 10, 1e-110);
  r = at2(head + line + "-.1000000E-01-.2000000E-01+.3000000E+00\n"); // columns that touch
  EXPECT_NEAR(r.values[1], -0.2, 1e-15);
  EXPECT_NEAR(r.values[2], 3, 1e-15);
  r = at2(head + line + "1,2,3\nthe end, trailing junk NaN\n");
  EXPECT_EQ(r.values.size(), 3u);
}

TEST(At2, KnowsUnits) {
  const auto with = [](const std::string &unit) {
    return at2("a\nb\nACCELERATION TIME HISTORY IN UNITS OF " + unit + "\nNPTS= 2, DT= .01\n1 1\n").values[0];
  };
  EXPECT_DOUBLE_EQ(with("G. FILTER POINTS: HP=0.07 Hz"), 10.0);
  EXPECT_DOUBLE_EQ(with("CM/S/S"), 0.01);
  EXPECT_DOUBLE_EQ(with("M/S/S"), 1.0);
  for (const char *unit : {"cm/s/s", "CM/SEC**2", "gal", "cm/s^2"}) EXPECT_DOUBLE_EQ(with(unit), 0.01) << unit;
  for (const char *unit : {"G", "g, unfiltered", "G (HP 0.1 HZ)", "G'S"}) EXPECT_DOUBLE_EQ(with(unit), 10.0) << unit;
  expect_error<DataError>([&] { with("FURLONGS"); }, {"FURLONGS", "test.AT2:3"});
  for (const char *unit : {"G/10", "G*100", "G / 10", "G X 100", "G 10", "G (FACTOR 0.01)", "G SCALED BY 2",
                           "CM/S/S/10", "CM/S/S*100", "CM/S/S/S", "GRAVITY"})
    expect_error<DataError>([&] { with(unit); }, {"test.AT2:3", "is not known"});
}

TEST(At2, FindsTheUnitHoweverItIsAnnounced) {
  const auto with = [](const std::string &line) {
    return at2("a\nb\n" + line + "\nNPTS= 2, DT= .01\n1 1\n").values[0];
  };
  for (const char *line : {"ACCELERATION TIME SERIES, UNITS: CM/S/S", "ACCELERATION TIME SERIES (CM/S/S)",
                           "UNITS = CM/S/S", "ACCELERATION TIME HISTORY IN CM/S/S", "Units (cm/s/s)"})
    EXPECT_DOUBLE_EQ(with(line), 0.01) << line;
  expect_error<DataError>([&] { with("UNITS: G/10"); }, {"G/10"});
}

TEST(At2, RefusesWithFileAndLine) {
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    SCOPED_TRACE(text.substr(0, 400));
    expect_error<DataError>([&] { at2(text); }, words);
  };
  refuse("a\nb\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01\n1 2\n", {"test.AT2:3", "velocity"});
  refuse("a\nb\nDISPLACEMENT TIME SERIES IN UNITS OF CM\nNPTS= 2, DT= .01\n1 2\n", {"displacement"});
  refuse(head + "NPTS= 9, DT= .01\n1 2 3\n4 5 6\n", {"test.AT2", "6 values", "9"});
  refuse(head + "NPTS= 3, DT= .01\n1 2 3\n4 5 6\n", {"test.AT2:6", "4 comes after the 3 values"});
  refuse(head + "NPTS= 3, DT= .01\n1 2 3 0 7\n", {"test.AT2:5", "7 comes after"});
  EXPECT_EQ(at2(head + "NPTS= 3, DT= .01\n1 2 3 0\n0 0\n").values.size(), 3u) << "padding";
  refuse(head + "NPTS= 3, DT= .01\n1 NaN 3\n", {"test.AT2:5", "NaN"});
  refuse(head + "NPTS= 3, DT= .01\n1 2\n***** 3\n", {"test.AT2:6", "*****"});
  refuse(head + "NPTS= 3, DT= .01\n1 2 1e999\n", {"test.AT2:5", "1e999"});
  refuse(head + "NPTS= 3, DT= 0.0\n1 2 3\n", {"test.AT2:4", "DT 0"});
  refuse(head + "NPTS= 3, DT= 10 SEC\n1 2 3\n", {"test.AT2:4", "DT 10"});
  refuse(head + "NPTS= 3, DT= 10 MSEC\n1 2 3\n", {"test.AT2:4", "milliseconds"});
  refuse(head + "NPTS= 3, DT= -.01\n1 2 3\n", {"DT -0.01"});
  refuse(head + "NPTS= 1, DT= .01\n1\n", {"NPTS 1"});
  refuse(head + "NPTS= 2.5, DT= .01\n1 2 3\n", {"NPTS 2.5"});
  refuse(head + "NPTS= 99999999999999, DT= .01\n1 2 3\n", {"NPTS"});
  refuse(head + "1 2 3\n", {"NPTS and DT"});
  refuse("", {"NPTS and DT"});
  expect_error<DataError>([] { read_record("no/such.AT2"); }, {"no/such.AT2", "no such file"});
  expect_error<DataError>([] { read_record("/"); }, {"folder"});
}

TEST(RecordCsv, ReadsBothUnitsAndRefuses) {
  const auto csv = [](const std::string &text) { return parse_record_csv(text, "r.csv", 10.0); };
  auto r = csv("time_s,acceleration_g\r\n5.00,0.1\r\n5.01,-0.2\r\n5.02,0\r\n");
  EXPECT_NEAR(r.dt, 0.01, 1e-12);
  EXPECT_NEAR(r.values[1], -2, 1e-15);
  EXPECT_NEAR(csv("# mine\nacceleration_m_per_s2, time_s\n3,0\n4,1\n").values[1], 4, 1e-15);
  expect_error<DataError>([&] { csv("time,acc\n0,1\n"); }, {"r.csv:1", "time_s,acceleration_g"});
  expect_error<DataError>([&] { csv("time_s,acceleration_g\n0,1\n1,x\n"); }, {"r.csv:3", "\"x\""});
  expect_error<DataError>([&] { csv("time_s,acceleration_g\n0,1\n1\n"); }, {"r.csv:3", "1 of 2"});
  expect_error<DataError>([&] { csv("time_s,acceleration_g\n0,0.1\n10,0.2\n20,0\n"); }, {"10 s apart", "milliseconds"});
  expect_error<DataError>([&] { csv("time_s,acceleration_g\n0,1\n1,1\n1.5,1\n3,2\n"); },
                          {"sample 3 at 1.5 s", "not uniform"});
  std::string back = "time_s,acceleration_g\n";
  for (int i = 0; i < 100; ++i) back += std::to_string(0.01 * (i == 60 ? 50 : i)) + ",0.1\n";
  expect_error<DataError>([&] { csv(back); }, {"sample 61", "not uniform"});
  expect_error<DataError>([&] { csv("time_s;acceleration_g\n0;1\n"); }, {"1 samples"});
  expect_error<DataError>([&] { csv("time_s,acceleration_g\n0,1\n0,1\n"); }, {"must grow"});
  expect_error<DataError>([&] { csv("time_s,acceleration_g\n0,1\n"); }, {"1 samples"});
  expect_error<DataError>([&] { csv("time_s,acceleration_g\n0,nan\n1,1\n"); }, {"nan"});
}

TEST(RecordCsv, TablesOfAnyTongue) {
  for (const char *text :
       {"Zeit [s];Beschleunigung [m/s\xC2\xB2]\n0,00;1,5\n0,01;-2,5\n",                            // UTF-8
        "Zeit [s];Beschleunigung [m/s\xB2]\r\n0,00;1,5\r\n0,01;-2,5\r\n\r\nEnde der Messung;\r\n", // Latin-1
        "station: X\nevent: Y\n\nTempo;Acc\ns;m/s2\n0,00;1,5\n0,01;-2,5\n", // units in the line below
        "sep=;\nTiempo (seg);Aceleracion (cm/s2);Velocidad (cm/s)\n0;150;0\n0.01;-250;1\n",
        "Time (s)\tAcceleration (gal)\n0\t150\n0.01\t-250\nPGA 250 gal\n", "\"t_s\",\"a [g]\"\n0,0.15\n0.01,-0.25\n"}) {
    SCOPED_TRACE(text);
    const auto r = parse_record_csv(text, "r.csv", 10.0);
    ASSERT_EQ(r.values.size(), 2u);
    EXPECT_NEAR(r.dt, 0.01, 1e-12);
    EXPECT_NEAR(r.values[0], 1.5, 1e-12);
    EXPECT_NEAR(r.values[1], -2.5, 1e-12);
  }
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    expect_error<DataError>([&] { parse_record_csv(text, "r.csv", 10.0); }, words);
  };
  refuse("t (s),a (g)\n0,1\nbroken\n0.02,1\n", {"r.csv:3", "rows go on"});
  refuse("t (s),NS (g),N (g)\n0,1,2\n0.01,1,2\n", {"r.csv:1", "N (g)", "NS (g)"});
  refuse("t (s),NS (g),trigger (g)\n0,1,2\n0.01,1,2\n", {"r.csv:1", "trigger (g)", "NS (g)"});
  refuse("T [s],Sa [g]\n0,1\n0.01,1\n", {"r.csv:1", "header must be"});
  refuse("period_s,level_g\n0,1\n0.01,1\n", {"r.csv:1", "header must be"});
  refuse("t (ms),a (g)\n0,1\n10,1\n", {"r.csv:1", "header must be"});
  refuse("t (s);a (g)\n0;1\n0,01;1\n0.02;2\n", {"r.csv:4", "decimal"});
}

TEST(RecordCsv, KeepsItsFirstInstant) {
  const auto r = parse_record_csv("time_s,acceleration_m_per_s2\n0.5,1\n0.6,3\n0.7,0\n", "r.csv", 10.0);
  EXPECT_DOUBLE_EQ(r.start, 0.5);
  EXPECT_DOUBLE_EQ(r.end(), 0.7);
  EXPECT_EQ(r.at(0.49), 0);
  EXPECT_NEAR(r.at(0.55), 2, 1e-12);
  EXPECT_EQ(at2(head + "NPTS= 2, DT= .01\n1 2\n").start, 0);
}

TEST(RecordCsv, RefusesWhatContradictsItself) {
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    expect_error<DataError>([&] { parse_record_csv(text, "r.csv", 10.0); }, words);
  };
  refuse("time_s,acceleration_g,acceleration_m_per_s2\n0,0.2,9\n1,0,0\n",
         {"r.csv:1", "column 3", "acceleration_m_per_s2", "acceleration_g"});
  refuse("time_s,acceleration_g,acceleration_g\n0,0.2,9\n1,0,0\n", {"r.csv:1", "column 3"});
  refuse("time_s,acceleration_g,time_s\n0,0.2,9\n1,0,0\n", {"r.csv:1", "time_s"});
  refuse("time_s,acceleration_g\n0,0,1\n1,0,2\n", {"r.csv:2", "3 cells for 2 columns", "decimal comma"});
  refuse("time_s,acceleration_g\n-1,0\n0,1\n", {"r.csv", "begins at -1 s", "shift"});
}

TEST(RecordInfo, AgreesWithClosedForms) {
  SampledSignal sine{0.001, {}};
  for (int i = 0; i <= 2000; ++i) sine.values.push_back(3 * std::sin(2 * M_PI * i * 0.001));
  const auto info = inspect(sine, 9.81);
  EXPECT_EQ(info.npts, 2001u);
  EXPECT_NEAR(info.pga_g, 3 / 9.81, 1e-6);
  EXPECT_NEAR(info.pgv, 3 / M_PI, 1e-5);           // (A/w)(1 - cos)
  EXPECT_NEAR(info.pgd, 3 / (2 * M_PI) * 2, 1e-4); // A/w t at 2 s
  EXPECT_NEAR(info.arias, M_PI / (2 * 9.81) * 9 * 0.5 * 2, 1e-4);
  EXPECT_NEAR(info.duration, 1.7, 0.2);
  const auto constant = inspect({0.5, {2.0, 2.0, 2.0}}, 10); // piecewise linear motion is integrated exactly
  EXPECT_NEAR(constant.pgd, 1.0, 1e-14);
  EXPECT_NEAR(constant.duration, 0.9, 1e-12);
}

TEST(BuiltinPulse, IntegratesToItsVelocity) {
  const auto check = [](const char *name, double amplitude, double frequency, double cycles, double centre) {
    const auto record = builtin_record(name);
    double v = 0, largest_error = 0;
    for (std::size_t i = 0; i + 1 < record.values.size(); ++i) {
      v += (record.values[i] + record.values[i + 1]) / 2 * record.dt;
      const double tau = (static_cast<double>(i) + 1) * record.dt - centre, w = 2 * M_PI * frequency;
      const bool inside = std::abs(tau) < cycles / (2 * frequency);
      const double expected = inside ? -amplitude / 2 * (1 + std::cos(w * tau / cycles)) * std::sin(w * tau) : 0;
      largest_error = std::max(largest_error, std::abs(v - expected));
    }
    EXPECT_LT(largest_error, 1e-3 * amplitude) << name;
    EXPECT_EQ(record.values.front(), 0);
    EXPECT_EQ(record.values.back(), 0);
  };
  check("builtin:near-fault-x", 0.90, 0.5, 1.6, 3.0);
  check("builtin:near-fault-y", 0.36, 0.6, 1.5, 3.2);
  expect_error<InputError>([] { builtin_record("builtin:near-fault"); }, {"did you mean"});
}

/// PGA [g], PGV [cm/s], PGD [cm], D5-95 [s] of records integrated as they are, published beside them.
struct Published {
  double pga, pgv, pgd, duration;
};
const std::map<std::string, Published> published{
    {"RSN1086_NORTHR_SYL090.AT2", {0.6049, 77.52, 16.00, 6.8}},
    {"RSN1086_NORTHR_SYL360.AT2", {0.8434, 129.33, 32.13, 5.3}},
    {"RSN1119_KOBE_TAZ000.AT2", {0.6973, 68.38, 26.66, 4.6}},
    {"RSN170_IMPVALL.H_H-ECC092.AT2", {0.2354, 73.36, 47.99, 13.2}},
    {"RSN1044_NORTHR_NWH360.AT2", {0.5904, 96.56, 34.34, 5.5}},
    {"RSN828_CAPEMEND_PET090.AT2", {0.6616, 88.48, 33.21, 16.1}},
};

TEST(Records, EveryRecordOfTheFolderIsRead) {
  const char *named = std::getenv("RIMPACT_RECORDS");
  const std::filesystem::path folder = named ? named : RIMPACT_SHARED_RECORDS;
  if (!std::filesystem::is_directory(folder))
    GTEST_SKIP() << "no records: set RIMPACT_RECORDS to a folder of AT2 files";
  int n_read = 0;
  for (const auto &entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".AT2") continue;
    SCOPED_TRACE(entry.path().filename().string());
    RecordInfo info{};
    ASSERT_NO_THROW(info = inspect(read_record(entry.path().string())));
    EXPECT_GT(info.npts, 1000u);
    EXPECT_TRUE(info.dt == 0.005 || info.dt == 0.01 || info.dt == 0.02) << info.dt;
    EXPECT_GT(info.pga_g, 0.01);
    EXPECT_LT(info.pga_g, 2.0);
    ++n_read;
    const auto found = published.find(entry.path().filename().string());
    if (found == published.end()) continue;
    EXPECT_NEAR(info.pga_g, found->second.pga, 5.1e-5);
    EXPECT_NEAR(info.pgv * 100, found->second.pgv, 5.1e-3);
    EXPECT_NEAR(info.pgd * 100, found->second.pgd, 5.1e-3);
    EXPECT_NEAR(info.duration, found->second.duration, 0.051);
  }
  EXPECT_GT(n_read, 0);
}

} // namespace
