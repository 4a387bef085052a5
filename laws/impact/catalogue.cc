#include "laws/impact/catalogue.h"

#include "io/files/error.h"
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::laws {
namespace {

/// The catalogue: one line a pair of files, in the order of lists.
auto families() {
  return std::array{
      &kelvin_voigt_laws(),
      &hunt_crossley_laws(),
      &elastoplastic_laws(),
      &pushed_curve_laws(),
  };
}

std::vector<std::string> names_of_laws() {
  std::vector<std::string> names;
  for (const auto *law : impact_laws()) names.push_back(law->name);
  return names;
}

} // namespace

const std::vector<const ImpactLaw *> &impact_laws() {
  static const auto all = [] {
    std::vector<const ImpactLaw *> list;
    for (const auto *family : families())
      for (const auto &law : family->laws) list.push_back(&law);
    return list;
  }();
  return all;
}

const ImpactLaw &impact_law(const std::string &name) {
  for (const auto *law : impact_laws())
    if (law->name == name) return *law;
  throw InputError(
      fmt::format("reduced.impact_law \"{}\" is unknown; known: {}", name, fmt::join(names_of_laws(), ", ")));
}

const ImpactLaw &default_law() {
  return *impact_laws().front();
}

const std::vector<LawParameter> &law_parameters() {
  static const auto all = [] {
    std::vector<LawParameter> list;
    for (const auto *family : families()) list.insert(list.end(), family->parameters.begin(), family->parameters.end());
    return list;
  }();
  return all;
}

void visit(KeyVisitor &v, LawNumbers &numbers, const ImpactLaw *&law) {
  static const std::vector<std::string> names = names_of_laws();
  static const std::string words = fmt::format("{}", fmt::join(names, " | "));
  const auto reads = [&](const LawFamily &family) {
    return std::any_of(family.laws.begin(), family.laws.end(), [&](const auto &own) { return &own == law; });
  };
  families().front()->visit(v, numbers, *law); // k_i and e, which most laws read
  std::string written = law->name;
  v.word({.name = "impact_law", .comment = words.c_str(), .meaning = "law of the rim, see laws"}, written, names);
  law = &impact_law(written);
  for (const auto *family : families())
    if (family != families().front() && family->visit && v.wants(reads(*family))) family->visit(v, numbers, *law);
}

bool ImpactLaw::reads(const std::string &parameter) const {
  const auto among = [&](const std::vector<std::string> &names) {
    return std::find(names.begin(), names.end(), parameter) != names.end();
  };
  return among(parameters) || among(exponents);
}

ImpactForce RimElement::at(const RimMotion &motion) const {
  const ImpactForce f = law->at(*this, motion);
  return law->unilateral && f.force <= 0 ? ImpactForce{0, 0, 0} : f;
}

double residual_indentation(const RimElement &rim, double deepest) {
  const auto presses = [&](double d) { return rim.trial({.d = d, .rate = 0, .deepest = deepest}) > 0; };
  if (presses(0)) return 0;
  double open = 0, pressed = deepest;
  while (true) {
    const double middle = (open + pressed) / 2;
    if (middle <= open || middle >= pressed) return pressed;
    (presses(middle) ? pressed : open) = middle;
  }
}

RimElement rim_element(const ImpactLaw &law, const LawNumbers &numbers, double mass) {
  if (law.pushed)
    throw InputError("reduced.impact_law \"" + law.name +
                     "\" has no numbers: it flies on the curve of a bearing's rim, by the reduced model physical only");
  RimElement rim{numbers};
  rim.law = &law;
  rim.stiffness = numbers.k_i;
  damping_ratio(numbers.restitution); // refuses one out of range, whether the law reads it or not
  if (law.prepare) law.prepare(rim, mass);
  return rim;
}

} // namespace rimpact::laws
