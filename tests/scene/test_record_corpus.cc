// A small file of every form (our own numbers, the forms' own layout), each read, and refused with its kind of damage.
#include "expect_error.h"
#include "io/files/file.h"
#include "io/files/zip_archive.h"
#include "io/records/record.h"
#include "io/records/record_corrections.h"
#include "io/records/record_doubts.h"
#include "io/records/record_file.h"
#include "io/records/record_folder.h"
#include "temporary_folder.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <zip.h>

using namespace rimpact;

namespace {

const std::string forms = RIMPACT_FORMS;

/// Every file holds the same motion: 40 samples, 0.01 s apart, with its peak of 1 m/s^2 downwards.
struct Example {
  const char *name;                ///< with the channel that holds it
  const char *form;                ///< of record_formats()
  const char *azimuth;             ///< of that channel; empty: not told
  double rounding;                 ///< of the form's numbers [m/s^2]
  const char *good, *damaged;      ///< of the file's text
  std::vector<const char *> words; ///< of the refusal
};

const std::vector<Example> examples{
    {"RSN9001_MADEUP_HIL090.AT2", "AT2", "90", 1e-6, "NPTS=     40", "NPTS=     41", {"truncated", "40", "41"}},
    {"HILL090.AT2", "AT2", "90", 1e-6, "PGA=   0.10", "PGA=   0.20", {"PGA says 1.98", "reach 1 m/s^2"}},
    {"HIL0010301010000.NS", "K-NET", "360", 0.02, "3920(gal)", "392(gal)", {"Max. Acc. (gal) says", "disagree"}},
    {"jma-hill.csv#1", "JMA", "360", 0.02, "UNIT  = gal", "UNIT  = counts", {"UNIT \"counts", "acceleration"}},
    {"HIL0013001010000.csv#1",
     "K-NET CSV",
     "360",
     0.02,
     "5.20,0.20,",
     "5.20,0.30,",
     {":37", "RelativeTime(s) is 0.3", "at 0.2 s"}},
    {"tabelle.csv#1", "CSV", "360", 1e-4, "0,0200;", "0,0250;", {"0.005 s after", "not uniform"}},
    {"units-below.csv", "CSV", "", 1e-4, "s,cm/s2", "s,furlong", {"header"}},
    {"XX.HIL..HNE.D.made-up.ASC",
     "ESM",
     "90",
     1e-6,
     "NDATA: 40",
     "NDATA: 39",
     {"40 values found", "NDATA promises 39"}},
    {"20300101_000000_HILL_20.V2A#1", "GeoNet", "14", 1e-4, "-1000.0 mm/s/s", "-2000.0 mm/s/s", {"Peak says 2"}},
    {"hill.V2c#1",
     "COSMOS V2",
     "360",
     1e-6,
     "   -100.000 cm/sec2",
     "   -150.000 cm/sec2",
     {"Peak acceleration says 1.5", "reach 1 m"}},
    {"ridge.V2#3",
     "COSMOS V2",
     "360",
     1e-5,
     "-100.000 CM/SEC/SEC",
     "-120.000 CM/SEC/SEC",
     {"Peak acceleration says 1.2"}},
    {"slope.V1#3", "COSMOS V2", "360", 5e-4, "  0.050", "  0.058", {"not evenly spaced", "V2"}},
    {"hill230.smc", "SMC", "230", 5e-4, "        40", "        60", {"hill230.smc"}},
};

void write_zip(const std::string &path, const std::vector<std::pair<std::string, std::string>> &members) {
  zip_t *archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  for (const auto &[name, text] : members)
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0);
  ASSERT_EQ(zip_close(archive), 0);
}

std::string text_of(const Example &example) {
  return read_file(record_name(forms + "/" + example.name).file);
}

} // namespace

TEST(RecordCorpus, EveryFormGivesTheSameMotion) {
  const auto wanted = read_record(forms + "/RSN9001_MADEUP_HIL090.AT2");
  for (const auto &example : examples) {
    SCOPED_TRACE(example.name);
    const std::string path = forms + "/" + example.name;
    const auto record = read_record(path);
    EXPECT_NEAR(record.dt, 0.01, 1e-9);
    ASSERT_EQ(record.values.size(), 40u);
    for (std::size_t i = 0; i < record.values.size(); ++i)
      ASSERT_NEAR(record.values[i], wanted.values[i], example.rounding) << i;
    const auto known = records_of_file(path);
    ASSERT_EQ(known.size(), 1u);
    EXPECT_EQ(known[0].form, example.form);
    const auto azimuth = known[0].direction.azimuth_deg;
    EXPECT_EQ(azimuth ? fmt::format("{:g}", *azimuth) : "", example.azimuth);
  }
}

TEST(RecordCorpus, EveryFormIsRefusedWithItsDamage) {
  for (const auto &example : examples) {
    SCOPED_TRACE(example.name);
    std::string text = text_of(example);
    for (auto at = text.find(example.good); at != std::string::npos; at = text.find(example.good, at + 1))
      text.replace(at, std::string(example.good).size(), example.damaged);
    ASSERT_NE(text, text_of(example));
    const TemporaryFolder folder;
    const std::string name = example.name, file = name.substr(0, name.find('#'));
    const std::string channel = file == name ? "" : name.substr(name.find('#'));
    const std::string path = folder.write(file, text) + channel;
    try {
      read_record(path);
      ADD_FAILURE() << "was read";
    } catch (const DataError &error) {
      for (const char *word : example.words)
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << word << " in: " << error.what();
    }
  }
}

TEST(RecordCorpus, EveryTruncatedFileIsRefusedOrShorter) {
  for (const auto &example : examples) {
    const std::string text = text_of(example);
    const TemporaryFolder folder;
    const std::string name = example.name, file = name.substr(0, name.find('#'));
    for (std::size_t length = 0; length < text.size(); length += 97) {
      const std::string path = folder.write(file, text.substr(0, length));
      try {
        EXPECT_LE(read_record(path + name.substr(file.size())).values.size(), 40u) << name << " at " << length;
      } catch (const DataError &) {
      }
    }
  }
}

TEST(RecordCorpus, FilesOfSeveralChannelsAreRefusedAndNameThem) {
  for (const char *file : {"tabelle.csv", "jma-hill.csv"})
    expect_error<DataError>([&] { read_record(forms + "/" + file); }, {"3 channels", "#1 (NS)", "#2 (EW)", "#3 (UD)"});
  expect_error<DataError>([&] { read_record(forms + "/slope.V1"); }, {"3 channels", "#1 (90)", "#2 (UP)", "#3 (360)"});
  expect_error<DataError>([&] { read_record(forms + "/ridge.V2"); }, {"3 channels", "#2 (UP)"});
  expect_error<DataError>([&] { read_record(forms + "/flat.V3"); }, {"spectra"});
  EXPECT_NEAR(inspect(read_record(forms + "/tabelle.csv#3")).pga_g, 0.5 / standard_gravity, 1e-6);
}

TEST(RecordCorpus, AFolderOfAllFormsIsSeenAsItsStations) {
  const auto folder = read_record_folder(forms);
  std::size_t pairs = 0;
  for (const auto &station : folder.stations) pairs += station.is_pair();
  EXPECT_EQ(pairs, 7u);                             // the three-channel files
  EXPECT_EQ(folder.records.size(), 7 * 3 + 6 + 1u); // and the spectrum, which reading refuses
}

TEST(RecordCorpus, SixColumnsOfKiknetAreTwoStations) {
  std::string text = read_file(forms + "/HIL0013001010000.csv"), six;
  for (std::size_t at = 0, number = 1; at < text.size(); ++number) {
    const auto end = text.find('\n', at);
    std::string line = text.substr(at, end - at);
    if (line.starts_with("#Time")) line = "#Time,RelativeTime(s),1(gal),2(gal),3(gal),4(gal),5(gal),6(gal)";
    if (!line.starts_with("#")) line += line.substr(line.find(',', line.find(',') + 1)); // the same below and above
    six += line + "\n", at = end + 1;
  }
  const TemporaryFolder folder;
  const std::string path = folder.write("HILH013001010000.csv", six);
  const auto read = read_record_folder(folder.path());
  ASSERT_EQ(read.stations.size(), 2u);
  for (const auto &station : read.stations) EXPECT_TRUE(station.is_pair()) << station.name;
  EXPECT_EQ(read.stations[0].name, "HILH013001010000 borehole");
  EXPECT_EQ(read_record(path + "#5").values, read_record(path + "#2").values);
  expect_error<DataError>([&] { read_record(path); }, {"6 channels", "#4 (N-S)", "#6 (U-D)"});
}

TEST(RecordCorpus, MembersOfAnArchiveAreReadInPlace) {
  const std::string archive = forms + "/portal.zip";
  const auto folder = read_record_folder(archive);
  ASSERT_EQ(folder.records.size(), 3u); // neither the remarks nor a Macintosh's shadow
  ASSERT_EQ(folder.stations.size(), 2u);
  EXPECT_EQ(std::count_if(folder.stations.begin(), folder.stations.end(), [](const auto &s) { return s.is_pair(); }),
            1);
  const auto inside = read_record(archive + "/made/RSN9001_MADEUP_HIL090.AT2");
  EXPECT_EQ(inside.values, read_record(forms + "/RSN9001_MADEUP_HIL090.AT2").values);
  EXPECT_EQ(record_label(archive + "/made/RSN9001_MADEUP_HIL090.AT2"), "RSN9001_MADEUP_HIL090");
  EXPECT_EQ(files_of_record(archive + "/hill230.smc"), std::vector<std::string>{archive});
  expect_error<DataError>([&] { read_record(archive + "/none.AT2"); }, {"portal.zip/none.AT2", "no such member"});
}

TEST(RecordCorpus, TheTableOfAnArchiveCorrectsItsMembers) {
  const std::string member = "portal/hill.AT2", unknown = "portal/dale.AT2";
  const std::string text = read_file(forms + "/RSN9001_MADEUP_HIL090.AT2");
  std::string nameless = text; // a header without a direction
  nameless.replace(nameless.find("Hillside, 90"), 12, "Hillside    ");
  const TemporaryFolder folder;
  const std::string archive = folder / "portal.zip", beside = folder / "portal.records.csv";
  const auto pack = [&](const std::string &table) {
    write_zip(archive,
              {{member, nameless}, {unknown, nameless}, {"other/dale.AT2", nameless}, {"portal/records.csv", table}});
  };
  pack("file,station,direction,unit\nhill.AT2,hill,N,m/s2\nportal/dale.AT2,hill,E,\nother/dale.AT2,,none,\n");
  const auto read = read_record_folder(archive);
  EXPECT_EQ(read.records.size(), 3u) << "the table itself is no record";
  EXPECT_EQ(read.question(), "");
  ASSERT_EQ(read.stations.size(), 1u);
  EXPECT_TRUE(read.stations[0].is_pair());
  EXPECT_NEAR(peak_of(read_record(archive + "/" + member).values), 1 / standard_gravity, 1e-6) << "its unit counts";
  EXPECT_NE(records_csv(read).find("\nportal/dale.AT2,hill,E,\nportal/hill.AT2,hill,N,m/s2\n"), std::string::npos)
      << records_csv(read);

  EXPECT_EQ(corrections_path(archive), beside);
  folder.write("portal.records.csv", "file,station,direction,unit\nportal/hill.AT2,hill,270,\n"); // has the last word
  const auto corrected = read_record_folder(archive);
  EXPECT_EQ(corrected.stations.size(), 1u);
  EXPECT_NE(corrected.question().find("portal.records.csv"), std::string::npos) << corrected.question();
  EXPECT_NEAR(peak_of(read_record(archive + "/" + member).values), 1, 1e-6);
  folder.write("portal.records.csv", "file,station,direction,unit\nportal/hill.AT2,hill,270,cm/s2\n");
  EXPECT_EQ(files_of_record(archive + "/" + member), (std::vector<std::string>{archive, beside}));

  const auto refuse = [&](const std::string &row, std::initializer_list<const char *> words) {
    folder.write("portal.records.csv", "file,station,direction\n" + row + "\n");
    expect_error<DataError>([&] { read_record_folder(archive); }, words);
  };
  refuse("dale.AT2,,N", {"portal.records.csv:2", "name of 2 records", "other/dale.AT2"});
  refuse("vale.AT2,,N", {"portal.records.csv:2", "no record"});
}

TEST(RecordCorpus, DamagedArchivesAreRefused) {
  const std::string bytes = read_file(forms + "/portal.zip");
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string &damaged, std::initializer_list<const char *> words) {
    const std::string path = folder.write("a.zip", damaged);
    expect_error<DataError>([&] { read_record(path + "/made/RSN9001_MADEUP_HIL090.AT2"); }, words);
  };
  refuse(bytes.substr(0, bytes.size() / 2), {"a.zip", "truncated"});
  std::string flipped = bytes;
  flipped[flipped.find("HIL090.AT2") + 60] ^= 0x40; // inside the member's packed bytes
  refuse(flipped, {"RSN9001_MADEUP_HIL090.AT2", "damaged"});
  for (std::size_t at = 0; at < bytes.size(); at += 31) { // whatever is flipped, it is read or refused
    std::string any = bytes;
    any[at] ^= 0x11;
    const std::string path = folder.write("b.zip", any);
    try {
      for (const auto &name : ZipArchive(path).names()) ZipArchive(path).read(name);
    } catch (const DataError &) {
    }
  }
}

TEST(RecordCorpus, AUnitOfRecordsCsvTakesThePlaceOfTheHeaders) {
  const TemporaryFolder folder;
  const std::string text = read_file(forms + "/units-below.csv");
  const std::string path = folder.write("hill-N.csv", text);
  EXPECT_EQ(files_of_record(path), std::vector<std::string>{path});
  const std::string stated = folder.write("records.csv", "file,station,direction,unit\nhill-N.csv,,N,m/s2\n");
  EXPECT_NEAR(peak_of(read_record(path).values), 100, 1e-9); // of 1 m/s^2 in cm/s^2
  EXPECT_EQ(files_of_record(path), (std::vector<std::string>{path, stated}));
  EXPECT_NE(records_csv(read_record_folder(folder.path())).find("hill-N.csv,hill,N,m/s2\n"), std::string::npos);
  folder.write("records.csv", "file,station,direction,unit\nhill-N.csv,,N,furlong\n");
  expect_error<DataError>([&] { read_record(path); }, {"records.csv:2", "furlong", "cm/s2"});
}
