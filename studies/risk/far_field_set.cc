#include "studies/risk/far_field_set.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

constexpr std::array<FarFieldRecord, 22> far_field{{{"953", "Northridge 1994", "Beverly Hills - Mulholland", 0.65},
                                                    {"960", "Northridge 1994", "Canyon Country - W Lost Canyon", 0.83},
                                                    {"1602", "Duzce 1999", "Bolu", 0.63},
                                                    {"1787", "Hector Mine 1999", "Hector", 1.09},
                                                    {"169", "Imperial Valley 1979", "Delta", 1.31},
                                                    {"174", "Imperial Valley 1979", "El Centro Array 11", 1.01},
                                                    {"1111", "Kobe 1995", "Nishi-Akashi", 1.03},
                                                    {"1116", "Kobe 1995", "Shin-Osaka", 1.10},
                                                    {"1158", "Kocaeli 1999", "Duzce", 0.69},
                                                    {"1148", "Kocaeli 1999", "Arcelik", 1.36},
                                                    {"900", "Landers 1992", "Yermo Fire Station", 0.99},
                                                    {"848", "Landers 1992", "Coolwater", 1.15},
                                                    {"752", "Loma Prieta 1989", "Capitola", 1.09},
                                                    {"767", "Loma Prieta 1989", "Gilroy Array 3", 0.88},
                                                    {"1633", "Manjil 1990", "Abbar", 0.79},
                                                    {"721", "Superstition Hills 1987", "El Centro Imp. Co.", 0.87},
                                                    {"725", "Superstition Hills 1987", "Poe Road", 1.17},
                                                    {"829", "Cape Mendocino 1992", "Rio Dell Overpass", 0.82},
                                                    {"1244", "Chi-Chi 1999", "CHY101", 0.41},
                                                    {"1485", "Chi-Chi 1999", "TCU045", 0.96},
                                                    {"68", "San Fernando 1971", "LA - Hollywood Stor", 2.10},
                                                    {"125", "Friuli 1976", "Tolmezzo", 1.44}}};

/// Of logarithms: between the two in the middle of an even number the geometric mean.
double median(std::vector<double> values) {
  for (auto &value : values) value = std::log(value);
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return std::exp(values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2);
}

} // namespace

std::span<const FarFieldRecord> far_field_set() {
  return far_field;
}

MotionLevel far_field_level(double intensity_g, RecordShelf &shelf, std::vector<std::string> &missing) {
  MotionLevel level{.intensity_g = intensity_g};
  std::vector<double> normalised;
  for (const auto &record : far_field) {
    const auto files = shelf.components(record.rsn);
    level.n_listed += 2;
    if (files.size() < 2)
      missing.push_back(fmt::format("RSN {} ({}, {}) of the far-field set at {:.4g} g: {}", record.rsn, record.event,
                                    record.station, intensity_g,
                                    files.empty() ? "no file at hand" : "one component is not at hand"));
    for (const auto &file : files) {
      level.motions.push_back(
          {.file = file, .record = fmt::format("RSN{}", record.rsn), .scale = record.normalisation});
      normalised.push_back(record.normalisation * shelf.sa_g(file));
    }
  }
  if (normalised.empty()) return level;
  const double anchor = intensity_g / median(normalised);
  for (std::size_t i = 0; i < normalised.size(); ++i) {
    level.motions[i].scale *= anchor;
    level.motions[i].over_level = normalised[i] * anchor / intensity_g;
  }
  return level;
}

} // namespace rimpact::risk
