#include "studies/risk/study_reader.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include "io/files/toml_reader.h"
#include "scene/scene.h"
#include "studies/fleets/sweep_toml.h"
#include "studies/risk/collapse_check.h"
#include "studies/risk/differences_reader.h"
#include "studies/risk/limits_reader.h"
#include "studies/risk/motions_reader.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

const std::vector<std::string> own_parts = {"scene",   "name",   "years", "set",        "intensity", "fragility",
                                            "motions", "hazard", "limit", "difference", "bootstrap", "p695"};
/// What the study itself sets in every run.
const std::vector<std::string> taken_keys = {"excitation.kind", "excitation.x", "excitation.y", "excitation.z",
                                             "excitation.scale"};

class StudyReader : fleets::SweepToml {
public:
  using SweepToml::SweepToml;

  Study read() {
    study_.origin = origin_;
    study_.name = std::filesystem::path(origin_).stem().string();
    study_.parts = fleets::read_parts(file_, origin_, own_parts);
    read_head();
    each_key("set", [&](const std::string &key, const toml::node &leaf) {
      study_.settings.push_back(fleets::assignment_beside(origin_, key, value(key, leaf)));
      refuse_taken(key, leaf);
    });
    read_intensity();
    study_.motions = read_motions(file_, origin_);
    if (!study_.motions.table.empty() + !study_.motions.sets.empty() + !study_.levels_g.empty() != 1)
      fail_at("motions", "a study needs one of motions.table, [[motions.set]] and intensity.levels_g (every record at "
                         "every level)");
    read_hazard();
    study_.limits = read_limits(file_);
    study_.differences = read_differences(file_, study_.parts);
    study_.collapse = read_collapse_study(file_, study_.limits);
    check_measure();
    TomlReader bootstrap(file_, "bootstrap");
    bootstrap.integer({"replicates"}, study_.bootstrap.replicates, 2, 100'000);
    bootstrap.number({"confidence"}, study_.bootstrap.confidence, si, {0, 1, true, true});
    int seed = 1;
    bootstrap.integer({"seed"}, seed, 0, 1'000'000'000);
    study_.bootstrap.seed = static_cast<std::uint64_t>(seed);
    bootstrap.finish();
    check_parts();
    return std::move(study_);
  }

private:
  [[noreturn]] void fail_at(const std::string &path, const std::string &what) const {
    throw InputError(fmt::format("{}: {}", file_.location(path), what));
  }

  void read_head() {
    TomlReader root(file_, "");
    root.text({"name"}, study_.name);
    root.text({"scene"}, study_.scene);
    root.number({"years"}, study_.years, si, {0, 1e6, true});
    root.choice({"fragility"}, study_.fragility);
    if (study_.scene.empty()) fail_at("scene", "a study needs scene = \"NAME\", built in or a file beside the study");
    if (const auto file = beside(origin_, study_.scene); std::filesystem::exists(file)) study_.scene = file;
  }

  void read_intensity() {
    if (!file_.find("intensity")) fail_at("intensity", "a study needs [intensity] with period_s, the period of S_a");
    TomlReader reader(file_, "intensity");
    reader.number({"period_s"}, study_.period_s, si, {0.01, 100});
    reader.choice({"measure"}, study_.measure);
    reader.numbers({"levels_g"}, study_.levels_g, si, {0, largest_acceleration_g, true});
    reader.finish();
    if (study_.period_s == 0) fail_at("intensity", "intensity needs period_s, the period of S_a");
    std::sort(study_.levels_g.begin(), study_.levels_g.end());
    if (std::adjacent_find(study_.levels_g.begin(), study_.levels_g.end()) != study_.levels_g.end())
      fail_at("intensity.levels_g", "intensity.levels_g has a level twice");
  }

  void check_measure() const {
    if (study_.measure != Measure::component && (study_.levels_g.empty() || study_.motions.list != RecordList::none))
      fail_at("intensity.measure",
              "intensity.measure is of intensity.levels_g with the records of the folders; tables, "
              "searches and motions.list have measures of their own");
    if (study_.motions.list != RecordList::none && study_.levels_g.empty())
      fail_at("motions.list", "motions.list needs intensity.levels_g, the levels of its median S_a");
  }

  void read_hazard() {
    TomlReader reader(file_, "hazard");
    Rows points;
    reader.rows({"points"}, points, {Column{si, {-huge, huge}}, Column{si, {-huge, huge}}});
    reader.finish();
    if (points.values.empty())
      fail_at("hazard.points", "a study needs [hazard] points = [[S_a in g, return period in years], ...]");
    for (const auto &[level, years] : points.values) study_.hazard.push_back({level, years});
    try {
      reliability::HazardCurve curve(study_.hazard);
    } catch (const InputError &error) {
      fail_at("hazard.points", error.what());
    }
  }

  void refuse_taken(const std::string &key, const toml::node &node) const {
    if (std::find(taken_keys.begin(), taken_keys.end(), key) != taken_keys.end())
      fail(node, key + " is set by [motions] in a reliability study");
  }

  void check_parts() const {
    for (const char *part : {"records", "fractiles"})
      if (const auto *node = file_.root().get(part))
        fail(*node, fmt::format("[{}] belongs to a sweep; a study has [motions] and [intensity]", part));
    for (const char *part : {"grid", "latin_hypercube", "linked"})
      each_key(part, [&](const std::string &key, const toml::node &leaf) { refuse_taken(key, leaf); });
    for (const auto *cases : {&study_.parts.cases, &study_.parts.devices})
      for (const auto &axis : cases->empty() ? std::vector<fleets::Axis>() : cases->front())
        if (std::find(taken_keys.begin(), taken_keys.end(), axis.key) != taken_keys.end())
          throw InputError(fmt::format("{}: {} is set by [motions] in a reliability study", origin_, axis.key));
  }

  static constexpr double largest_acceleration_g = 100;
  Study study_;
};

} // namespace

const std::vector<std::string> &quantities() {
  static const auto names = [] {
    auto all = fleets::bounded_quantities();
    all.emplace_back(collapsed);
    return all;
  }();
  return names;
}

Study parse_study(const std::string &text, const std::string &origin) {
  return StudyReader(TomlFile(text, origin), origin).read();
}

Study read_study(const std::string &path) {
  return parse_study(read_named_file(path), path);
}

} // namespace rimpact::risk
