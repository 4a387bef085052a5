#include "io/records/record_file.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include "io/files/zip_archive.h"
#include "io/records/direction.h"
#include <filesystem>
#include <fmt/format.h>
#include <stdexcept>

namespace rimpact {
namespace {

const RecordFormat &format_of(std::string_view text, const std::string &path) {
  const std::string ending = upper(std::filesystem::path(path).extension().string());
  for (const auto &format : record_formats())
    if (format.is(text, ending)) return format;
  throw std::logic_error("no form takes what no other does");
}

/// A path of which a part is an archive's name.
RecordName in_archive(const std::string &path) {
  std::error_code none;
  for (auto at = upper(path).find(".ZIP/"); at != std::string::npos; at = upper(path).find(".ZIP/", at + 1)) {
    constexpr std::size_t ending = 4;
    const std::string archive = path.substr(0, at + ending);
    if (std::filesystem::is_regular_file(archive, none)) return {archive, path.substr(at + ending + 1), std::nullopt};
  }
  return {path, "", std::nullopt};
}

} // namespace

std::string RecordName::whole() const {
  return member.empty() ? file : file + "/" + member;
}

RecordName record_name(const std::string &name) {
  const auto mark = name.rfind('#');
  std::error_code ignored;
  if (mark == std::string::npos || std::filesystem::exists(name, ignored)) return in_archive(name);
  const auto number = to_number(name.substr(mark + 1));
  if (!number || !(*number >= 1 && *number <= 999) || *number != static_cast<int>(*number)) return in_archive(name);
  RecordName result = in_archive(name.substr(0, mark));
  result.channel = static_cast<std::size_t>(*number);
  return result;
}

std::string record_label(const std::string &name) {
  const RecordName record = record_name(name);
  const std::filesystem::path path(record.whole());
  const std::string ending = path.extension().string();
  const bool tells_direction = ending.size() > 1 && direction_written(ending).kind != DirectionKind::unknown;
  const std::string stem = tells_direction ? path.filename().string() : path.stem().string();
  return record.channel ? fmt::format("{}#{}", stem, *record.channel) : stem;
}

RecordFile RecordFile::read(const RecordName &name) {
  return {name.member.empty() ? read_file(name.file) : ZipArchive(name.file).read(name.member), name.whole()};
}

RecordFile::RecordFile(std::string text, std::string path)
    : text_(std::move(text)), path_(std::move(path)), format_(&format_of(text_, path_)),
      channels_(format_->channels(text_)) {}

RecordHead RecordFile::head(std::size_t channel) const {
  return format_->head(channels_[channel]);
}

std::string RecordFile::name(std::size_t channel) const {
  return n_channels() == 1 ? path_ : fmt::format("{}#{}", path_, channel + 1);
}

SampledSignal RecordFile::parse(std::size_t channel, const ReadAs &as) const {
  ReadAs reading = as;
  reading.column = channels_[channel].column;
  return format_->parse(std::string(channels_[channel].text), name(channel), reading);
}

std::size_t RecordFile::chosen(const std::optional<std::size_t> &channel) const {
  if (channel && *channel <= n_channels()) return *channel - 1;
  if (!channel && n_channels() == 1) return 0;
  std::string all;
  for (std::size_t i = 0; i < n_channels(); ++i) {
    const std::string direction = head(i).direction;
    all += fmt::format("{}#{} ({})", i == 0 ? "" : ", ", i + 1, direction.empty() ? "no direction" : direction);
  }
  throw DataError(channel ? fmt::format("{}: there is no channel {}, it has {}: {}", path_, *channel, n_channels(), all)
                          : fmt::format("{}: holds {} channels: {}; say which, as in \"{}#1\"", path_, n_channels(),
                                        all, std::filesystem::path(path_).filename().string()));
}

} // namespace rimpact
