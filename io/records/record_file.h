/// A file of records: its form, and its channels where it holds several.
#pragma once
#include "io/records/record_format.h"
#include <optional>
#include <string>
#include <vector>

namespace rimpact {

/// "station.V2#3" is channel 3 of station.V2, from 1; any other name is a file's, also one with "#" that is there.
/// "portal.zip/A/B.AT2" is a member of an archive, where portal.zip is a file.
struct RecordName {
  std::string file;                   ///< on the disk: the record's, or the archive's
  std::string member;                 ///< of an archive; empty: none
  std::optional<std::size_t> channel; ///< from 1; none: not said
  std::string whole() const;          ///< without the channel
};
RecordName record_name(const std::string &name);
/// A component's name in tables: its file's without folder and ending, with the channel where it says one. An ending
/// that is a direction, as K-NET's (".EW", ".NS2"), stays.
std::string record_label(const std::string &name);

/// The text of one file, told apart into channels by its form.
class RecordFile {
public:
  /// Throws DataError as read_file, or as ZipArchive::read.
  static RecordFile read(const RecordName &name);
  RecordFile(std::string text, std::string path);
  RecordFile(const RecordFile &) = delete; // its channels point into its text
  RecordFile(RecordFile &&) = delete;

  const RecordFormat &format() const { return *format_; }
  const std::string &path() const { return path_; }
  std::size_t n_channels() const { return channels_.size(); }
  RecordHead head(std::size_t channel) const;  ///< channel from 0
  std::string name(std::size_t channel) const; ///< as read_record takes it: with its number where there are several
  SampledSignal parse(std::size_t channel, const ReadAs &as) const;
  /// The channel that a name asks for, from 0. Throws DataError, naming all of them with their directions, where none
  /// is asked for and there are several, or the file has no such channel.
  std::size_t chosen(const std::optional<std::size_t> &channel) const;

private:
  std::string text_, path_;
  const RecordFormat *format_;
  std::vector<Channel> channels_;
};

} // namespace rimpact
