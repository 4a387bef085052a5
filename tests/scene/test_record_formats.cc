// Records as data bases give them: K-NET, ESM, COSMOS V2.
#include "expect_error.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include <cmath>
#include <fmt/format.h>

using namespace rimpact;

namespace {

const std::string knet =
    "Origin Time       2011/03/11 14:46:00\nLat.              38.103\nLong.             142.860\nDepth. (km)       "
    "24\nMag.              9.0\nStation Code      MYG004\nStation Lat.      38.7292\nStation Long.     "
    "141.0217\nStation Height(m) 40\nRecord Time       2011/03/11 14:46:36\nSampling Freq(Hz) "
    "100Hz\nDuration Time(s)  0\nDir.              N-S\nScale Factor      3920(gal)/6182761\nMax. Acc. (gal)   "
    "0.634\nLast Correction   2011/03/11 14:46:21\nMemo.             \n    1000    3000    2000    2000\n    "
    "2000    2000\n";

const std::string esm =
    "EVENT_NAME: CENTRAL_ITALY\nEVENT_ID: EMSC-20161030_0000029\nEVENT_DATE_YYYYMMDD: "
    "20161030\nSAMPLING_INTERVAL_S: 0.005000\nNDATA: 4\nDURATION_S: 0.015\nSTREAM: HGE\nUNITS: cm/s^2\nDATA_TYPE: "
    "ACCELERATION\nUSER1:\n0.5\n-98.0665\n1.0e1\n-2\n";

/// 62 values of the real header in columns of 13, the 34th and the 62nd as given.
std::string cosmos(double raw_s, double series_ms, const std::string &counts, const std::string &data) {
  std::string text = "Corrected acceleration    (Format v01.20 with 13 text lines)\nStatn No: 02\n 100  Real-header "
                     "values follow on 17 "
                     "lines , Format = (6F13.6)\n";
  for (int i = 1; i <= 102; ++i)
    text += fmt::format("{:13.6f}", i == 34   ? raw_s
                                    : i == 62 ? series_ms
                                    : i == 42 ? 426212.0
                                              : -999.0) +
            (i % 6 == 0 ? "\n" : "");
  return text + "  0 Comment line(s) follow, each starting with a \"|\":\n" + counts + "\n" + data +
         "End-of-data for chan 1 acceleration\n";
}
const std::string counts = "   4 acceleration pts, approx  0 secs, units=cm/s^2,Format=(8F10.5)";
const std::string touching = "   0.50000-100.00000 -98.06650   2.00000\n";

void expect_values(const SampledSignal &record, double dt, const std::vector<double> &values) {
  EXPECT_DOUBLE_EQ(record.dt, dt);
  ASSERT_EQ(record.values.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(record.values[i], values[i], 1e-9) << i;
}
std::string replaced(std::string text, const std::string &old, const std::string &now) {
  return text.replace(text.find(old), old.size(), now);
}

} // namespace

TEST(RecordFormats, AreToldByTheFileNotItsEnding) {
  for (const char *path : {"MYG004.NS", "a.txt", "b"}) {
    const double gal = 3920.0 / 6182761 / 100;
    expect_values(parse_record(knet, path, 9.81), 0.01, {-1000 * gal, 1000 * gal, 0, 0, 0, 0}); // less their mean
    expect_values(parse_record(esm, path, 9.81), 0.005, {0.005, -0.980665, 0.1, -0.02});
    expect_values(parse_record(cosmos(0.01, 5, counts, touching), path, 9.81), 0.005, {0.005, -1, -0.980665, 0.02});
  }
  EXPECT_EQ(parse_record("PEER\nx\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2, DT= .01 SEC\n1 2\n", "q.txt", 10)
                .values[1],
            20);
}

TEST(RecordFormats, UnitsInG) {
  expect_values(parse_record(replaced(esm, "cm/s^2", "g"), "x", 10), 0.005, {5, -980.665, 100, -20});
}

TEST(RecordFormats, EsmRefusals) {
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    expect_error<DataError>([&] { parse_record(text, "q.asc", 9.81); }, words);
  };
  refuse(replaced(esm, "cm/s^2", "furlong"), {"q.asc", "furlong"});
  refuse(replaced(esm, "ACCELERATION", "VELOCITY"), {"VELOCITY"});
  refuse(replaced(esm, "NDATA: 4", "NDATA: 9"), {"truncated", "4 values", "9"});
  refuse(replaced(esm, "0.005000", "0"), {"SAMPLING_INTERVAL_S 0", "> 0"});
  refuse(replaced(esm, "1.0e1", "nan"), {"q.asc:13", "nan"});
  refuse(replaced(esm, "-98.0665", "-980665"), {"100 g"});
}

TEST(RecordFormats, HeadersThatDisagreeWithTheirDataAreRefusedWithBothFigures) {
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    expect_error<DataError>([&] { parse_record(text, "q.x", 9.81); }, words);
  };
  refuse(replaced(esm, "NDATA: 4", "NDATA: 3"), {"4 values found", "NDATA promises 3"});
  refuse(replaced(esm, "USER1:", "PGA_CM/S^2: 49.0"), {"PGA_CM/S^2 says 0.49", "reach 0.98067"});
  expect_values(parse_record(replaced(esm, "USER1:", "PGA_CM/S^2: -98.07"), "q", 9.81), 0.005,
                {0.005, -0.980665, 0.1, -0.02}); // rounded, and of the other sign
  refuse(replaced(esm, "ACCELERATION", "ACCELERATION RESPONSE SPECTRUM"), {"SPECTRUM", "acceleration record"});
  refuse(replaced(esm, "1.0e1\n", "0.09 1.0e1\n"), {"q.x:13", "one a line"});
  refuse(replaced(knet, "Duration Time(s)  0", "Duration Time(s)  3"), {"6 values found", "promises 300"});
  refuse(replaced(knet, "0.634", "6.34"), {"Max. Acc. (gal) says 0.0634", "reach 0.0063"});
  refuse(cosmos(0.01, 5, counts, touching + "   1.00000   2.00000\n"), {"more numbers", "4 values"});
}

TEST(RecordFormats, Geonet) {
  const auto component = [](const std::string &direction, const std::string &count, const std::string &peak) {
    std::string text =
        "Corrected accelerogram 20300101_000000_HALL_20 GNS Science\nSite HALL      43 30 25S  172 43 53E\n"
        "Hall\nInstrument\nResolution\nAccelerogram\nnear\n2030 January 01         00:00:00 UT\nEpicentre\n"
        "Number of points\nunits\nfiltered\nComponent " +
        direction + "\nAcceleration:  Peak  " + peak + " mm/s/s at  0.01 s\nVelocity\nDisplacement\n";
    for (int i = 0; i < 100; ++i)
      text += fmt::format("{:>8}", i == 33   ? count
                                   : i == 65 ? "0.0050"
                                   : i == 34 ? "2"
                                             : "0") +
              (i % 10 == 9 ? "\n" : "");
    return text + "   500.0-1000.0   100.0\n     1.0     2.0\n";
  };
  const auto one = component("S14E", "3", "-1000.0");
  expect_values(parse_record(one, "a.V2A", 9.81), 0.005, {0.5, -1, 0.1});
  expect_error<DataError>([&] { parse_record(one + component("Up", "3", "-1000.0"), "a.V2A", 9.81); },
                          {"2 channels", "#1 (S14E)", "#2 (Up)"});
  expect_error<DataError>([&] { parse_record(component("N76E", "3", "-1100.0"), "a.V2A", 9.81); },
                          {"Acceleration: Peak says 1.1", "reach 1 m/s^2"});
  expect_error<DataError>([&] { parse_record(component("N76E", "9", "-1000.0"), "a.V2A", 9.81); },
                          {"truncated", "9 needed"});
  expect_error<DataError>([&] { parse_record(component("N76E", "0", "-1000.0"), "a.V2A", 9.81); }, {"samples 0"});
}

TEST(RecordFormats, Csmip) {
  const auto csmip = [](const std::string &channel, const std::string &values) {
    return "CORRECTED ACCELEROGRAM DATA\nSTATION NO. 24514\nCHAN 1: " + channel +
           "\n    4 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC, IN CM/SEC2.   (8F10.3)\n" + values +
           "    4 POINTS OF VELOC DATA EQUALLY SPACED AT  .020 SEC, IN CM/SEC.    (8F10.3)\n" + values + "/&\n";
  };
  const std::string values = "    50.000  -100.000   -98.067     2.000\n";
  const auto one = csmip("90 DEG", values);
  expect_values(parse_record(one, "a.V2", 9.81), 0.02, {0.5, -1, -0.98067, 0.02});
  expect_error<DataError>([&] { parse_record(one + csmip("UP", values), "a.V2", 9.81); },
                          {"2 channels", "#1 (90)", "#2 (UP)"});
  expect_error<DataError>([&] { parse_record("RESPONSE AND FOURIER AMPLITUDE SPECTRA\n1 2\n", "a.V3", 9.81); },
                          {"spectra", "V2"});
}

TEST(RecordFormats, KnetRefusals) {
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    expect_error<DataError>([&] { parse_record(text, "q.NS", 9.81); }, words);
  };
  refuse(replaced(knet, "3920(gal)/6182761", "3920"), {"q.NS", "scale factor", "3920"});
  refuse(replaced(knet, "100Hz", "0Hz"), {"Sampling Freq", "between 1 and 10000"});
  refuse(replaced(knet, "Memo.", "Mem"), {"Memo"});
  refuse(replaced(knet, "    3000", "   x3000"), {"q.NS:18", "x3000"});
}

TEST(RecordFormats, CosmosIntervalAndRefusals) {
  EXPECT_DOUBLE_EQ(parse_record(cosmos(0.01, -999, counts, touching), "q.v2", 9.81).dt, 0.01); // the raw record's
  const auto bare = replaced(counts, "(8F10.5)", "8F10.5"); // no width told: blanks part the values
  EXPECT_EQ(parse_record(cosmos(0.01, 5, bare, "0.5 -100 -98.0665 2\n"), "q.v2", 9.81).values.size(), 4u);
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    expect_error<DataError>([&] { parse_record(text, "q.v2", 9.81); }, words);
  };
  refuse(cosmos(-999, -999, counts, touching), {"sampling interval", "> 0"});
  refuse(cosmos(0.01, 5, replaced(counts, "cm/s^2", "counts"), touching), {"q.v2", "unit"});
  refuse(cosmos(0.01, 5, replaced(counts, "   4", "   5"), touching), {"q.v2"});
  refuse("Corrected acceleration\n", {"line of counts"});
}
