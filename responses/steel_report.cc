#include "responses/steel_report.h"

#include "io/files/error.h"
#include "io/files/json_text.h"
#include <algorithm>

namespace rimpact {

namespace {

constexpr double SteelAtPlace::*damages[] = {&SteelAtPlace::damage, &SteelAtPlace::averaged_damage,
                                             &SteelAtPlace::locus_damage, &SteelAtPlace::averaged_locus_damage};

} // namespace

void keep_worst(SteelReport &worst, const SteelReport &other) {
  for (const auto &[place, found] : other) {
    const auto [entry, is_new] = worst.emplace(place, found);
    if (is_new) continue;
    SteelAtPlace &kept = entry->second;
    SteelAtPlace both = found.averaged > kept.averaged ? found : kept;
    for (const auto damage : damages) both.*damage = std::max(kept.*damage, found.*damage);
    kept = both;
  }
}

bool is_of_the_rim(SteelPlace place) {
  return place != SteelPlace::slider_edge;
}

std::optional<JudgedStrain> judged_strain(const SteelReport &report, std::optional<double> of_any_body) {
  std::optional<JudgedStrain> judged;
  const auto worse = [&](const SteelAtPlace &at) {
    if (!judged || at.limit.has_value() != judged->limit.has_value()) return !judged || at.limit.has_value();
    return at.averaged / at.limit.value_or(1) > judged->largest / judged->limit.value_or(1);
  };
  for (const auto &[place, at] : report)
    if (is_of_the_rim(place) && worse(at)) judged = {at.averaged, place, at.limit};
  if (!judged && of_any_body) judged = {*of_any_body, std::nullopt, {}};
  return judged;
}

nlohmann::ordered_json to_json(const SteelReport &report) {
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for (const auto &[place, at] : report) {
    const bool strained = at.largest > 0;
    nlohmann::ordered_json entry{{"max_plastic_strain", at.largest}, {"averaged_plastic_strain", at.averaged}};
    entry["triaxiality"] = strained ? nlohmann::ordered_json(at.triaxiality) : nullptr;
    entry["lode"] = strained ? nlohmann::ordered_json(at.lode) : nullptr;
    entry["damage"] = at.damage;
    entry["averaged_damage"] = at.averaged_damage;
    entry["damage_bao_wierzbicki"] = at.locus_damage;
    entry["averaged_damage_bao_wierzbicki"] = at.averaged_locus_damage;
    entry["place_mm"] = strained ? nlohmann::ordered_json{1e3 * at.place.x(), 1e3 * at.place.y(), 1e3 * at.place.z()}
                                 : nlohmann::ordered_json(nullptr);
    entry["limit"] = or_null<nlohmann::ordered_json>(at.limit);
    result[word(place)] = entry;
  }
  return result;
}

SteelReport steel_report_in(const nlohmann::json &summary, const std::string &origin) {
  SteelReport report;
  if (!summary.contains("steel") || summary["steel"].is_null()) return report;
  const std::string what = origin + ": \"steel\" is not the strain of a run's steel by its places";
  try {
    for (const auto &[name, entry] : summary["steel"].items()) {
      const auto place = parse<SteelPlace>(name);
      if (!place) throw DataError(what);
      SteelAtPlace &at = report[*place];
      at.largest = entry.at("max_plastic_strain"), at.averaged = entry.at("averaged_plastic_strain");
      at.damage = entry.at("damage");
      at.averaged_damage = entry.value("averaged_damage", at.damage); // runs of earlier versions have a point's alone
      at.locus_damage = entry.value("damage_bao_wierzbicki", 0.0);    // as well
      at.averaged_locus_damage = entry.value("averaged_damage_bao_wierzbicki", 0.0);
      if (!entry.at("triaxiality").is_null()) at.triaxiality = entry["triaxiality"];
      if (entry.contains("lode") && !entry["lode"].is_null()) at.lode = entry["lode"];
      if (entry.contains("limit") && !entry["limit"].is_null()) at.limit = entry["limit"];
      if (!entry.at("place_mm").is_null())
        for (int i = 0; i < 3; ++i) at.place[i] = 1e-3 * entry["place_mm"].at(i).get<double>();
    }
  } catch (const nlohmann::json::exception &) {
    throw DataError(what);
  }
  return report;
}

} // namespace rimpact
