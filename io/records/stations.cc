#include "io/records/stations.h"
#include "io/files/text.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace rimpact {
namespace {

using Group = std::vector<std::size_t>; ///< of the records

/// Whether two of a group point one way, so that it holds more than one recording.
bool repeats(const std::vector<FolderRecord> &records, const Group &group) {
  std::set<std::string> seen;
  for (const std::size_t i : group) {
    const auto &direction = records[i].direction;
    const std::string way = direction.kind == DirectionKind::vertical ? word(direction.kind)
                            : direction.azimuth_deg ? fmt::format("{:.0f}", std::fmod(*direction.azimuth_deg, 360))
                                                    : direction.spelling;
    if (!seen.insert(way).second) return true;
  }
  return false;
}

std::map<std::string, Group> grouped(const Group &all, const std::vector<std::string> &names) {
  std::map<std::string, Group> groups;
  for (const std::size_t i : all) groups[upper(names[i])].push_back(i);
  return groups;
}

/// "RSN1_A" of RSN1_A and RSN1_A; of stations whose names differ, the header's.
std::string name_of(const std::vector<FolderRecord> &records, const std::vector<std::string> &headers,
                    const Group &group) {
  const std::string &first = records[group.front()].station;
  const bool alike =
      std::all_of(group.begin(), group.end(), [&](std::size_t i) { return records[i].station == first; });
  return alike || headers[group.front()].empty() ? first : headers[group.front()];
}

Station station_of(const std::vector<FolderRecord> &records, const Group &group, std::string name) {
  Station station{.name = std::move(name), .horizontal = {}, .vertical = {}};
  for (const std::size_t i : group)
    (records[i].direction.kind == DirectionKind::vertical ? station.vertical : station.horizontal).push_back(i);
  const auto azimuth = [&](std::size_t i) { return records[i].direction.azimuth_deg.value_or(999); };
  std::stable_sort(station.horizontal.begin(), station.horizontal.end(),
                   [&](std::size_t a, std::size_t b) { return azimuth(a) < azimuth(b); });
  return station;
}

void doubt_angle(std::vector<FolderRecord> &records, const Station &station) {
  if (!station.is_pair()) return;
  auto &first = records[station.horizontal[0]], &second = records[station.horizontal[1]];
  if (!first.direction.azimuth_deg || !second.direction.azimuth_deg) return;
  constexpr double slack = 5; // [deg]
  const double between = std::fmod(std::abs(*first.direction.azimuth_deg - *second.direction.azimuth_deg), 180);
  if (std::abs(between - 90) <= slack) return;
  const std::string sentence =
      fmt::format("the components of {} are {:g} degrees apart, not 90", station.name, between);
  first.doubts.push_back(sentence), second.doubts.push_back(sentence);
}

} // namespace

std::vector<Station> stations_of(std::vector<FolderRecord> &records, const std::vector<std::string> &headers) {
  Group known;
  std::vector<std::string> names, own;
  for (std::size_t i = 0; i < records.size(); ++i) {
    own.push_back(records[i].station);
    names.push_back(headers[i].empty() ? own.back() : headers[i]);
    if (records[i].direction.kind != DirectionKind::unknown && !records[i].left_out) known.push_back(i);
  }
  std::vector<Station> stations;
  const auto add = [&](const Group &group) {
    stations.push_back(station_of(records, group, name_of(records, headers, group)));
    doubt_angle(records, stations.back());
  };
  for (const auto &[header, group] : grouped(known, names))
    if (!repeats(records, group))
      add(group);
    else
      for (const auto &[name, part] : grouped(group, own)) add(part);
  std::sort(stations.begin(), stations.end(), [](const auto &a, const auto &b) { return a.name < b.name; });
  return stations;
}

} // namespace rimpact
