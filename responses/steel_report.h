/// The steel of a finite-element run by its places, as summary.json has it.
#pragma once
#include "io/files/choice.h"
#include <Eigen/Core>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace rimpact {

/// Strains are averaged over a ball of this radius R with the weight (1 - r^2 / R^2)^2, within one body: the strain of
/// a single point grows as cells shrink. From mesh 1 to 2 the averaged one moves by less than 5 %
/// (docs/results/refinement.md) [m].
constexpr double averaging_radius = 0.012;
/// By how much a mean damage above 0.05 moves from mesh 1 to 2 at most, on shfps-225 at 0.2 and 0.5 m/s
/// (tests/verification/steel_places.py, which holds it) [-].
constexpr double damage_mesh_change = 0.20;

enum class SteelPlace { rim_wall, rim_root, dish, slider_edge };
constexpr auto choices(SteelPlace) {
  return choices_of<SteelPlace>({{SteelPlace::rim_wall, "rim_wall", "the rim's wall"},
                                 {SteelPlace::rim_root, "rim_root", "the rim's root"},
                                 {SteelPlace::dish, "dish", "the dish below the rim"},
                                 {SteelPlace::slider_edge, "slider_edge", "the slider's edge"}});
}

struct SteelAtPlace {
  double largest = 0;               ///< equivalent plastic strain of a point [-]
  double averaged = 0;              ///< largest mean over averaging_radius [-]
  double triaxiality = 0;           ///< at the largest strain, a mean over its plastic strain [-]; tension positive
  double lode = 0;                  ///< Lode parameter 27 J3 / (2 q^3), alike [-]: 1 tension, 0 shear, -1 compression
  double damage = 0;                ///< largest D of a point (fe_contact/laws/crack_measure.h) [-]; a crack begins at 1
  double averaged_damage = 0;       ///< largest mean over averaging_radius [-]
  double locus_damage = 0;          ///< as `damage`, by Bao and Wierzbicki's locus [-]
  double averaged_locus_damage = 0; ///< as `averaged_damage` [-]
  Eigen::Vector3d place{0, 0, 0};   ///< of the largest strain, in the mesh before it is strained [m]
  std::optional<double> limit = {}; ///< plastic strain that the steel there is trusted to [-]; none: not judged
};

/// Of the places that are meshed.
using SteelReport = std::map<SteelPlace, SteelAtPlace>;

/// Each place keeps the worse of two reports: by its largest averaged strain, and the larger damages.
void keep_worst(SteelReport &worst, const SteelReport &other);
/// Whether the place belongs to the rim's side, which the question is about: all but the slider's edge.
bool is_of_the_rim(SteelPlace place);

/// The strain that is held against its limit: of the averaged ones of the rim's side that which has most of its place's
/// limit, the largest where none has a limit.
struct JudgedStrain {
  double largest;                   ///< [-]
  std::optional<SteelPlace> place;  ///< none: not known, the largest of a point of any body
  std::optional<double> limit = {}; ///< of the place [-]; none: not judged
};
/// `of_any_body` where the report has nothing of the rim's side.
std::optional<JudgedStrain> judged_strain(const SteelReport &report, std::optional<double> of_any_body);
nlohmann::ordered_json to_json(const SteelReport &report);
/// Of a summary.json; empty where it has none. Throws DataError, naming `origin`, for one that cannot be read.
SteelReport steel_report_in(const nlohmann::json &summary, const std::string &origin);

} // namespace rimpact
