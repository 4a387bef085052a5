/// Parts of calibration.json on parameters, laws and profiles.
#pragma once
#include "calibration/answer/calibration.h"
#include "scene/stored_calibration.h"

namespace rimpact::calibration {

/// JSON knows no infinity and no NaN: null.
nlohmann::json number(double value);
nlohmann::json number(const std::optional<double> &value);

/// Every parameter the scene's law reads, fitted or not, and where the rim begins.
scene::StoredElement stored_element(const scene::Scene &scene);
nlohmann::json element_json(const scene::Scene &scene);
scene::StoredParameters stored_parameters(const FitResult &result);
nlohmann::json parameters_json(const FitResult &result);
std::optional<scene::StoredGain> stored_gain(const std::optional<ChannelGain> &gain);
nlohmann::json laws_json(const LawRanking &ranking);
nlohmann::json pair_range_json(const PairRange &range);
nlohmann::json speed_laws_json(const std::vector<SpeedLaw> &laws);
nlohmann::json profiles_json(const std::map<std::string, Profile> &profiles);

} // namespace rimpact::calibration
