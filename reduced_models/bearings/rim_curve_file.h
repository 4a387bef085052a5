/// The file of a rim curve, curve.h5, and its table, curve.csv.
///
/// /dish/loading/{penetration,force}, /dish/unloading/{branch,penetration,force} (branch 1, 2, ... by depth), the same
/// under /held; /held/steel/{penetration,strain};
/// /held/rim_foot/{penetration,use}; /meta texts. SI units. `dish`: pushed while the slider's height
/// follows the dish; `held`: at the height of first touch, as an impact window without weight is. A file may hold the
/// held path alone.
#pragma once
#include "laws/impact/rim_curve.h"
#include "scene/scene.h"
#include <optional>

namespace rimpact::reduced {

/// How far the curve is from the answer, relative.
struct CurveErrors {
  std::optional<double> mesh_force; ///< force at the same work, from the next coarser mesh; none: not estimated
  double left_out_rebound = 0;      ///< of interpolation between unloadings (laws::RimCurve::left_out_rebound)
};
/// The rim's plastic strain on the way in, as judged_strain() (responses/steel_report.h) has it.
struct CurveStrain {
  std::vector<double> penetration, strain; ///< rising from 0 [m]; [-]
};
/// Largest use of the joint at the rim's foot so far (responses/foot_strength.h).
struct CurveFoot {
  std::vector<double> penetration, use; ///< rising from 0 [m]; [-]
};
struct RimCurveFile {
  laws::CurvePath dish, held; ///< `dish` is empty where it was not pushed
  CurveStrain strain;         ///< along `held`; empty in files of an older version
  CurveFoot foot;             ///< along `held`; empty: one piece with the plate
  std::string joint;          ///< scene::strength_in_words of what `foot` is of
  std::string bearing;        ///< its name
  std::string rim_identity;   ///< scene::rim_identity of it
  std::string rim_values;     ///< scene::rim_values of it; empty: the file is of an older version
  std::string mesh;           ///< in words: "level 1, 12190 unknowns"
  std::string made_by;        ///< version of the program
  CurveErrors errors;
};

/// Written atomically. Throw IoError.
void write_rim_curve(const RimCurveFile &curve, const std::string &path);
void write_rim_curve_csv(const RimCurveFile &curve, const std::string &path);
/// Throws DataError naming the file and what is wrong with it.
RimCurveFile read_rim_curve(const std::string &path);

/// The curve the scene's impact law flies on: along the dish, or held for a window without weight; read once a process.
/// Throws InputError for a curve of another rim, DataError for a damaged file.
std::shared_ptr<const laws::RimCurve> rim_curve_of(const scene::Scene &scene);

/// The joint at the rim's foot that the curve's push watched.
struct CurveJoint {
  std::string joint;             ///< its words; empty: one piece with the plate
  std::optional<double> gone_at; ///< force of first loading at which its use passes 1 [N]; none: borne to the end
};
CurveJoint joint_of_curve(const scene::Scene &scene);

/// Sentences on a curve too coarse to be flown without a word: its mesh is off by more than 3 % of the force or by
/// nobody knows how much, its unloadings leave out more than 10 % of the rebound. None for a scene of another law.
std::vector<std::string> doubts_of_curve(const scene::Scene &scene);

} // namespace rimpact::reduced
