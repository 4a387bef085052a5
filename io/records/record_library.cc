#include "io/records/record_library.h"
#include "io/records/near_fault_pulse.h"
#include "io/records/record_file.h"
#include <algorithm>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>

namespace rimpact {
namespace {

namespace fs = std::filesystem;

/// Which file, and as of when.
struct Stamp {
  fs::file_time_type written;
  std::uintmax_t length;
  bool operator==(const Stamp &) const = default;
};
using Name = std::pair<std::string, double>; ///< path and gravity

/// None: the file cannot be looked at, and reading it says why.
bool stamp_of(const std::string &path, Stamp &stamp) {
  std::error_code no_time, no_length;
  const std::string file = record_name(path).file;
  stamp = {fs::last_write_time(file, no_time), fs::file_size(file, no_length)};
  return !no_time && !no_length;
}

class Library {
public:
  std::shared_ptr<const SampledSignal> find(const Name &name, const Stamp &stamp) {
    const std::scoped_lock lock(guard_);
    const auto entry = entries_.find(name);
    return entry != entries_.end() && entry->second.stamp == stamp ? entry->second.record : nullptr;
  }

  void keep(const Name &name, const Stamp &stamp, std::shared_ptr<const SampledSignal> record) {
    const std::scoped_lock lock(guard_);
    forget(name);
    n_samples_ += record->values.size();
    entries_[name] = {stamp, std::move(record)};
    order_.push_back(name);
    while (n_samples_ > largest_library && order_.size() > 1) forget(Name(order_.front()));
  }

private:
  struct Entry {
    Stamp stamp;
    std::shared_ptr<const SampledSignal> record;
  };

  void forget(const Name &name) {
    const auto entry = entries_.find(name);
    if (entry == entries_.end()) return;
    n_samples_ -= entry->second.record->values.size();
    entries_.erase(entry);
    order_.erase(std::find(order_.begin(), order_.end(), name));
  }

  std::mutex guard_;
  std::map<Name, Entry> entries_;
  std::deque<Name> order_; ///< oldest first
  std::size_t n_samples_ = 0;
};

} // namespace

std::shared_ptr<const SampledSignal> shared_record(const std::string &path, double gravity) {
  static Library library;
  Stamp stamp{};
  if (is_builtin_record(path) || !stamp_of(path, stamp))
    return std::make_shared<const SampledSignal>(read_record(path, gravity));
  if (auto known = library.find({path, gravity}, stamp)) return known;
  auto record = std::make_shared<const SampledSignal>(read_record(path, gravity));
  library.keep({path, gravity}, stamp, record);
  return record;
}

std::string records_shelf() {
  const char *folder = std::getenv("RIMPACT_RECORDS");
  return folder ? folder : "";
}

std::string find_record(const std::string &name, const std::string &folder) {
  if (is_builtin_record(name)) return name;
  std::error_code failed;
  const auto in = [&](const std::string &place) {
    return fs::absolute(fs::path(place) / name, failed).lexically_normal();
  };
  const fs::path beside = in(folder), kept = in(records_shelf());
  if (failed) return name;
  const auto is_there = [&](const fs::path &path) { return fs::exists(record_name(path.string()).file, failed); };
  return !records_shelf().empty() && !is_there(beside) && is_there(kept) ? kept : beside;
}

} // namespace rimpact
