/// The steel of a finite-element run by its places, as summary.json has it.
#pragma once
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

struct SteelAtPlace {
  double largest = 0;             ///< equivalent plastic strain of a point [-]
  double averaged = 0;            ///< largest mean over averaging_radius [-]
  double triaxiality = 0;         ///< at the largest strain, a mean over its plastic strain [-]; tension positive
  double damage = 0;              ///< largest D of fe_contact/laws/crack_measure.h [-]; a crack begins at 1
  Eigen::Vector3d place{0, 0, 0}; ///< of the largest strain, in the mesh before it is strained [m]
};

/// rim_wall, rim_root, dish, slider_edge: those that are meshed.
using SteelReport = std::map<std::string, SteelAtPlace>;

/// Each place keeps the worse of two reports: by its largest averaged strain, and the larger damage.
void keep_worst(SteelReport &worst, const SteelReport &other);
/// Whether the place belongs to the rim's side, which the question is about: all but `slider_edge`.
bool is_of_the_rim(const std::string &place);

/// The strain that is held against the limit: the largest averaged one of the rim's side.
struct JudgedStrain {
  double largest;    ///< [-]
  std::string place; ///< empty: of no known place, the largest of a point of any body
};
std::optional<JudgedStrain> judged_strain(const SteelReport &report); ///< none: nothing of the rim's side is there
std::string words_for_place(const std::string &place);                ///< "the rim's wall"
/// `limit`: plastic strain that the steel is trusted to; none: null.
nlohmann::ordered_json to_json(const SteelReport &report, std::optional<double> limit);
/// Of a summary.json; empty where it has none. Throws DataError, naming `origin`, for one that cannot be read.
SteelReport steel_report_in(const nlohmann::json &summary, const std::string &origin);

} // namespace rimpact
