/// What an impact law is: force of the rim on the slider over penetration d and its rate, as a pure function of an
/// element's numbers. Beside it stands what files, fits and exports have to know of it. SI units, force > 0 pushes the
/// slider inwards. A law is one pair of files of this folder (numbers, keys with bounds, force, OpenSees material) and
/// one line in catalogue.cc.
#pragma once
#include "io/files/key_visitor.h"
#include "laws/impact/elastoplastic.h"
#include "laws/impact/hunt_crossley.h"
#include "laws/impact/kelvin_voigt.h"
#include "laws/impact/opensees_material.h"
#include "laws/impact/pushed_curve.h"
#include <memory>
#include <string>
#include <vector>

namespace rimpact::laws {

/// The numbers of every law: a scene carries all, its law reads its own.
struct LawNumbers : PairNumbers, HuntCrossleyNumbers, ElastoplasticNumbers, CurveNumbers {
  bool operator==(const LawNumbers &) const = default;
};

/// Force and its partial derivatives; `d_speed` is zero except for laws that count the planar speed.
struct ImpactForce {
  double force;         ///< [N]
  double d_penetration; ///< [N/m]
  double d_rate;        ///< [N s/m]
  double d_speed = 0;   ///< [N s/m]
};

/// What a law sees of the contact.
struct RimMotion {
  double d;           ///< penetration [m], >= 0
  double rate;        ///< d' [m/s], > 0 while approaching
  double speed = 0;   ///< planar [m/s], >= |rate|
  double deepest = 0; ///< penetration this arc of the rim had reached before [m]; read by laws that yield
};

/// A number that a fit may move.
struct LawParameter {
  const char *name, *unit; ///< as calibrations name it; of the reported value
  const char *key;         ///< of [reduced]
  double si;               ///< reported value times this is SI
  double lower, upper;     ///< default bounds of a fit, in the reported unit
  bool logarithmic;        ///< fitted by its logarithm
  double LawNumbers::*member;
};

/// SAP2000's and ETABS' link that takes a law's part.
enum class CsiLink { none, linear, plastic };

struct ImpactLaw {
  std::string name, description;
  std::vector<std::string> parameters; ///< of the element that the law reads, named as calibrations do
  std::vector<std::string> exponents;  ///< of its curves' shape: fitted last, where impacts are many enough
  ImpactForce (*at)(const RimElement &rim, const RimMotion &motion);
  /// True: never pulls. The element lets go when `at` falls to zero and presses again when it rises through
  /// zero with d > 0. False: it lets go when the penetration ends.
  bool unilateral = false;
  bool yields = false;            ///< reads `deepest`: the rim remembers its dents
  bool of_mass = false;           ///< its dashpot is scaled by the supported mass
  bool pushed = false;            ///< flies on the curve of the bearing's rim: no element is made from numbers
  std::vector<std::string> needs; ///< keys without which a calibrated element would run on defaults
  /// What the element derives from its numbers for a supported mass [kg]; null: nothing.
  void (*prepare)(RimElement &rim, double mass) = nullptr;
  /// As `at` reads them, SI, named with their units.
  std::vector<std::pair<std::string, double>> (*numbers)(const RimElement &rim) = nullptr;
  OpenSeesMaterial (*opensees)(const RimElement &rim) = nullptr; ///< null: OpenSees has none
  CsiLink csi = CsiLink::none;
  bool reads(const std::string &parameter) const; ///< exponents too
};

/// Laws that share their numbers.
struct LawFamily {
  std::vector<ImpactLaw> laws;
  std::vector<LawParameter> parameters; ///< its own
  /// Its own keys of [reduced], as far as `law` reads them where that is asked; null: none.
  void (*visit)(KeyVisitor &visitor, LawNumbers &own, const ImpactLaw &law) = nullptr;
};

/// The element of one rim: its law, the law's numbers, and what follows from them.
struct RimElement : LawNumbers {
  double stiffness = 0;                            ///< at first touch [N/m]; 0: no element
  double damping = 0;                              ///< c_i [N s/m] of spring and dashpot
  double dissipation = 0;                          ///< chi [s/m] of hunt-crossley, >= 0
  std::shared_ptr<const RimCurve> curve = nullptr; ///< of the law that needs one
  const ImpactLaw *law = nullptr;                  ///< into impact_laws()
  ImpactForce at(const RimMotion &motion) const;
  /// The law's force before a unilateral element lets go [N]: its sign decides whether it presses.
  double trial(const RimMotion &motion) const { return law->at(*this, motion).force; }
};
/// Of a law given by numbers. Throws InputError for e outside (0, 1] and for a law that flies on a curve.
RimElement rim_element(const ImpactLaw &law, const LawNumbers &numbers, double mass);

} // namespace rimpact::laws
