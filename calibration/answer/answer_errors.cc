// The parts of an answer's errors, each with how it is known. None is silently zero.
#include "calibration/answer/answer_parts.h"
#include "calibration/laws/percent.h"
#include "impact_laws/catalogue.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {
namespace {

using nlohmann::json;

/// By an explicit program of another make: the default rim at 0.2 and 1.0 m/s, of steel that does not know its rate and
/// of mild steel (Cowper and Symonds, D 40 1/s, q 5): the peak force rises by 15 and 27 %, the rebound by 15 and 16 %.
constexpr double rate_of_mild_steel_force = 0.27, rate_of_mild_steel_rebound = 0.16;

/// Largest change of the averaged strain of the rim's wall, its root and the dish from a mesh to the next finer one, at
/// 0.2 and 0.5 m/s on the default rim: tests/verification/steel_places.txt.
constexpr double averaged_strain_mesh_0 = 0.76, averaged_strain_mesh_1 = 0.06;

struct OfRung {
  double peak_force, rebound;
  std::string study;
  bool same_rim;
};

const json *row_of(const json &rows, const std::string &rung, int mesh) {
  for (const json &row : rows)
    if (row.value("rung", "") == rung && row.value("mesh", -1) == mesh) return &row;
  return nullptr;
}

/// A rung against `full` on the same mesh, by each study that ran both.
std::vector<OfRung> rung_errors(const std::vector<StoredStudy> &studies, const std::string &rung,
                                const std::string &rim) {
  std::vector<OfRung> found;
  for (const StoredStudy &study : studies) {
    const json &rows = study.json.value("rows", json::array());
    for (const int mesh : {2, 1, 0}) {
      const json *own = row_of(rows, rung, mesh), *full = row_of(rows, word(SolvedBy::full), mesh);
      if (!own || !full) continue;
      const auto ratio = [&](const char *error) {
        const auto at = [&](const json &row) { return 1 + row.value(error, 0.0); };
        return std::abs(at(*own) / at(*full) - 1);
      };
      found.push_back({ratio("peak_force_error"), ratio("rebound_error"), study.name, study.rim_identity == rim});
      break;
    }
  }
  return found;
}

class Parts {
public:
  explicit Parts(const Answer &answer) : answer_(answer) {}

  void add(Erring quantity, ErrorSource source, std::optional<double> value, Known how, const std::string &from) {
    errors.push_back(
        {quantity, source, value ? std::optional(std::abs(*value)) : std::nullopt, value ? how : Known::unknown, from});
  }
  void of_solids(const std::vector<StoredStudy> &studies) {
    add(Erring::peak_force, ErrorSource::mesh, answer_.mesh_error.peak_force, Known::measured,
        answer_.mesh_error.sentence);
    add(Erring::rebound, ErrorSource::mesh, answer_.mesh_error.rebound, Known::measured, answer_.mesh_error.sentence);
    for (const Erring quantity : {Erring::peak_force, Erring::rebound})
      add(quantity, ErrorSource::step, {}, Known::unknown, "rimpact study RUN/scene.toml --axes step");
    of_rung(studies);
    of_steel();
    const auto assumed = scene::assumptions(answer_.scene.bearing).size();
    for (const Erring quantity : {Erring::peak_force, Erring::rebound})
      if (assumed > 0)
        add(quantity, ErrorSource::geometry, {}, Known::unknown,
            fmt::format("{} dimensions and numbers of the bearing are assumptions: rimpact geometry", assumed));
    const int coarsest = answer_.meshes.empty() ? 0 : answer_.meshes.front(); // by growing number
    add(Erring::strain, ErrorSource::mesh, coarsest == 0 ? averaged_strain_mesh_0 : averaged_strain_mesh_1,
        Known::transferred, "the rim's steel of shfps-225 on meshes 0 to 2 (docs/results/refinement.md)");
    add(Erring::strain, ErrorSource::steel, {}, Known::unknown, "no run of a steel that knows its rate");
  }
  void of_law() {
    const auto &worst = answer_.law.worst_left_out;
    const std::string from = worst ? "runs left out of the fit" : "no run was left out";
    add(Erring::peak_force, ErrorSource::law, worst ? std::optional(worst->peak_force) : std::nullopt, Known::measured,
        from);
    add(Erring::depth, ErrorSource::law, worst ? std::optional(worst->depth) : std::nullopt, Known::measured, from);
    add(Erring::rebound, ErrorSource::law, worst ? std::optional(worst->rebound) : std::nullopt, Known::measured, from);
    add_interval(Erring::k_i, "k_i"), add_interval(Erring::e, "e");
  }
  /// What moves every peak force by one share moves depth, k_i and e too. A rim that presses F (1 + s) at the depth
  /// d / (1 + s) stores the same energy: it is met as deep as that, its stiffness is k (1 + s)^2, and e is the rebound
  /// over the approach. To be called when the parts of peak force and rebound are there.
  void of_similar() {
    const std::string by_energy = "of the peak force, by the energy stored: ";
    for (const AnswerError &part : std::vector<AnswerError>(errors)) {
      if (part.source == ErrorSource::law) continue;
      const Known how = part.value ? Known::transferred : Known::unknown;
      const auto twice = part.value ? std::optional(2 * *part.value) : std::nullopt;
      if (part.quantity == Erring::peak_force) {
        if (!has(Erring::depth, part.source)) add(Erring::depth, part.source, part.value, how, by_energy + part.from);
        if (law_reads("k_i")) add(Erring::k_i, part.source, twice, how, "twice that " + by_energy + part.from);
      }
      if (part.quantity == Erring::rebound && law_reads("e"))
        add(Erring::e, part.source, part.value, how, "of the rebound: " + part.from);
    }
  }
  /// Energy that no entry accounts for goes, at worst, into the rebound: d e / e = share / (2 e^2).
  void of_energy(const Calibration &c, const std::vector<const StoredRun *> &runs) {
    std::optional<double> worst;
    for (const StoredRun *run : runs) {
      const double e = run->impacts.empty() ? 0 : run->impacts.front().impact.restitution();
      if (e > 0) worst = std::max(worst.value_or(0), std::abs(c.facts.at(run->folder).imbalance) / (2 * e * e));
    }
    add(Erring::rebound, ErrorSource::energy, worst, Known::measured, "energy of the runs that nothing accounts for");
  }

  std::vector<AnswerError> errors;

private:
  /// The law's steel has no rate, or one of two; how far it is from the other is the band of the twins.
  void of_steel() {
    const auto both = [&](std::optional<double> force, std::optional<double> rebound, Known how,
                          const std::string &from) {
      add(Erring::peak_force, ErrorSource::steel, force, how, from);
      add(Erring::rebound, ErrorSource::steel, rebound, how, from);
    };
    if (const auto &band = answer_.steel_band) {
      const Known how = band->assumed ? Known::transferred : Known::measured;
      const std::string from = fmt::format("windows of this rim without and with {}{}", in_words(band->rate),
                                           band->assumed ? ", constants of mild steel" : "");
      both(band->largest(&SteelTwin::force_ratio), band->largest(&SteelTwin::rebound_ratio), how, from);
      add(Erring::depth, ErrorSource::steel, band->largest(&SteelTwin::depth_ratio), how, from);
    } else if (const auto &steel = answer_.scene.bearing.steel; steel.knows_rate()) {
      both({}, {}, Known::unknown, fmt::format("the constants of its rate, {}", in_words(steel.rate)));
    } else {
      both(rate_of_mild_steel_force, rate_of_mild_steel_rebound, Known::transferred,
           "steel as fast as mild steel's (D 40 1/s, q 5) on shfps-225, by an explicit program");
    }
  }
  bool has(Erring quantity, ErrorSource source) const {
    return std::any_of(errors.begin(), errors.end(),
                       [&](const AnswerError &error) { return error.quantity == quantity && error.source == source; });
  }
  bool law_reads(const std::string &name) const { return answer_.scene.reduced.impact_law->reads(name); }
  /// Half the 95 % interval of a law's own number.
  void add_interval(Erring quantity, const std::string &name) {
    if (!law_reads(name)) return;
    const auto found = answer_.law.result.parameters.find(name);
    if (found == answer_.law.result.parameters.end())
      return add(quantity, ErrorSource::law, {}, Known::unknown, "held, not fitted");
    const Estimate &e = found->second;
    const double half = std::max(e.interval_high - e.value, e.value - e.interval_low) / e.value;
    add(quantity, ErrorSource::law, std::isfinite(half) ? std::optional(half) : std::nullopt, Known::measured,
        "its 95 % interval");
  }
  void of_rung(const std::vector<StoredStudy> &studies) {
    if (answer_.rungs == std::vector<std::string>{word(SolvedBy::full)}) return;
    const OfRung *force = nullptr, *rebound = nullptr;
    std::vector<OfRung> all;
    for (const std::string &rung : answer_.rungs)
      for (const OfRung &each : rung_errors(studies, rung, answer_.rim_identity)) all.push_back(each);
    for (const OfRung &each : all) {
      if (!force || each.peak_force > force->peak_force) force = &each;
      if (!rebound || each.rebound > rebound->rebound) rebound = &each;
    }
    const std::string none = "rimpact study RUN/scene.toml --axes rung --rungs rim,rigid-dish,full";
    const auto how = [](const OfRung *of) { return of && of->same_rim ? Known::measured : Known::transferred; };
    add(Erring::peak_force, ErrorSource::rung, force ? std::optional(force->peak_force) : std::nullopt, how(force),
        force ? "study " + force->study : none);
    add(Erring::rebound, ErrorSource::rung, rebound ? std::optional(rebound->rebound) : std::nullopt, how(rebound),
        rebound ? "study " + rebound->study : none);
  }
  const Answer &answer_;
};

} // namespace

std::vector<AnswerError> answer_errors(const Calibration &c, const Answer &answer,
                                       const std::vector<const StoredRun *> &runs,
                                       const std::vector<StoredStudy> &studies) {
  Parts parts(answer);
  const bool solids = answer.sources.count(RunSource::finite_elements) > 0;
  if (solids) parts.of_solids(studies);
  parts.of_law();
  if (solids) parts.of_energy(c, runs);
  parts.of_similar();
  return parts.errors;
}

ErrorSum sum_of(const std::vector<AnswerError> &errors, Erring quantity) {
  ErrorSum sum;
  double squares = 0;
  for (const AnswerError &error : errors) {
    if (error.quantity != quantity) continue;
    if (error.value)
      squares += *error.value * *error.value, sum.known = std::sqrt(squares);
    else
      sum.open.push_back(error.source);
  }
  return sum;
}

std::string sentence(const std::vector<AnswerError> &errors, Erring quantity) {
  std::vector<AnswerError> known;
  std::copy_if(errors.begin(), errors.end(), std::back_inserter(known),
               [&](const AnswerError &error) { return error.quantity == quantity && error.value; });
  std::sort(known.begin(), known.end(), [](const auto &a, const auto &b) { return *a.value > *b.value; });
  std::vector<std::string> parts, open;
  for (const AnswerError &error : known)
    parts.push_back(fmt::format("{} {}", word(error.source), percent_up(*error.value)));
  const ErrorSum sum = sum_of(errors, quantity);
  for (const ErrorSource source : sum.open) open.push_back(word(source));
  const std::string what = description(quantity);
  std::string text = sum.known ? fmt::format("{}: within about {} of the bearing's, by {}.", what,
                                             percent_up(*sum.known), fmt::join(parts, ", "))
                               : fmt::format("{}: how far it is from the bearing's is not known.", what);
  if (!open.empty()) text += fmt::format(" Not known: {}.", fmt::join(open, ", "));
  return text;
}

std::vector<std::string> sentences(const std::vector<AnswerError> &errors) {
  std::vector<std::string> said;
  for (const auto &choice : choices(Erring())) {
    const auto of_it = [&](const AnswerError &error) { return error.quantity == choice.value; };
    if (std::any_of(errors.begin(), errors.end(), of_it)) said.push_back(sentence(errors, choice.value));
  }
  return said;
}

} // namespace rimpact::calibration
