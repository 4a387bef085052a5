/// Parts of calibration.json on parameters, laws and profiles.
#pragma once
#include "calibration/answer/calibration.h"

namespace rimpact::calibration {

/// JSON knows no infinity and no NaN: null.
nlohmann::json number(double value);
nlohmann::json number(const std::optional<double> &value);

/// Every parameter the scene's law reads, fitted or not, and where the rim begins.
nlohmann::json element_json(const scene::Scene &scene);
nlohmann::json parameters_json(const FitResult &result);
nlohmann::json gain_json(const std::optional<ChannelGain> &gain);
nlohmann::json laws_json(const LawRanking &ranking);
nlohmann::json pair_range_json(const PairRange &range);
nlohmann::json speed_laws_json(const std::vector<SpeedLaw> &laws);
nlohmann::json profiles_json(const std::map<std::string, Profile> &profiles);

} // namespace rimpact::calibration
