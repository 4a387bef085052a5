#include "files/error.h"
#include "files/file.h"
#include "files/text.h"
#include "files/toml_reader.h"
#include "fleets/sweep_toml.h"
#include "risk/study.h"
#include "scene/scene.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

const std::vector<std::string> own_parts = {"scene",   "name",   "years", "set",        "intensity",
                                            "motions", "hazard", "limit", "difference", "bootstrap"};
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
      study_.settings.push_back(key + "=" + value(key, leaf).toml);
      refuse_taken(key, leaf);
    });
    read_intensity();
    read_motions();
    read_hazard();
    read_limits();
    read_differences();
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
  std::string beside(const std::string &name) const {
    namespace fs = std::filesystem;
    return fs::absolute(fs::path(origin_).parent_path() / name).lexically_normal().string();
  }
  [[noreturn]] void fail_at(const std::string &path, const std::string &what) const {
    throw InputError(fmt::format("{}: {}", file_.location(path), what));
  }

  void read_head() {
    TomlReader root(file_, "");
    root.text({"name"}, study_.name);
    root.text({"scene"}, study_.scene);
    root.number({"years"}, study_.years, si, {0, 1e6, true});
    if (study_.scene.empty()) fail_at("scene", "a study needs scene = \"NAME\", built in or a file beside the study");
    if (std::filesystem::exists(beside(study_.scene))) study_.scene = beside(study_.scene);
  }

  void read_intensity() {
    if (!file_.find("intensity")) fail_at("intensity", "a study needs [intensity] with period_s, the period of S_a");
    TomlReader reader(file_, "intensity");
    reader.number({"period_s"}, study_.period_s, si, {0.01, 100});
    reader.numbers({"levels_g"}, study_.levels_g, si, {0, largest_acceleration_g, true});
    reader.finish();
    if (study_.period_s == 0) fail_at("intensity", "intensity needs period_s, the period of S_a");
    std::sort(study_.levels_g.begin(), study_.levels_g.end());
    if (std::adjacent_find(study_.levels_g.begin(), study_.levels_g.end()) != study_.levels_g.end())
      fail_at("intensity.levels_g", "intensity.levels_g has a level twice");
  }

  void read_motions() {
    MotionSource &motions = study_.motions;
    if (!file_.find("motions")) fail_at("motions", "a study needs [motions]: folders of records, a table of them");
    TomlReader reader(file_, "motions");
    reader.text({"table"}, motions.table);
    reader.choice({"level_is"}, motions.level_is);
    reader.choice({"component"}, motions.component);
    reader.choice({"scale"}, motions.scale);
    reader.section("columns", [&] {
      reader.text({"level"}, motions.level_column);
      reader.text({"rsn"}, motions.rsn_column);
      reader.text({"component"}, motions.component_column);
      reader.text({"factor"}, motions.factor_column);
    });
    reader.finish({"folders", "where", "set"});
    read_folders();
    read_sets();
    read_where();
    if (!motions.table.empty()) motions.table = beside(motions.table);
    if (!motions.table.empty() + !motions.sets.empty() + !study_.levels_g.empty() != 1)
      fail_at("motions", "a study needs one of motions.table, [[motions.set]] and intensity.levels_g (every record at "
                         "every level)");
  }

  void read_folders() {
    const auto *node = file_.find("motions.folders");
    if (!node) return;
    const auto *list = node->as_array();
    if (!list) fail(*node, "motions.folders must be a list of folders");
    for (const auto &entry : *list) {
      if (!entry.is_string()) fail(entry, "motions.folders must be a list of folders");
      study_.motions.folders.push_back(beside(entry.as_string()->get()));
    }
  }

  void read_sets() {
    const auto *node = file_.find("motions.set");
    if (!node) return;
    const auto *list = node->as_array();
    if (!list) fail(*node, "sets are written [[motions.set]], one table each");
    for (const auto &entry : *list) {
      const auto *table = entry.as_table();
      if (!table) fail(entry, "sets are written [[motions.set]], one table each");
      only(*table, {"search_results", "level"}, "motions.set");
      const auto *file = table->get("search_results");
      if (!file || !file->is_string()) fail(entry, "a set needs search_results = \"FILE\"");
      const double level = number_in(*table, "level", "motions.set");
      if (!(level > 0)) fail(entry, fmt::format("motions.set.level {} must be > 0", level));
      study_.motions.sets.push_back({beside(file->as_string()->get()), level});
    }
  }

  void read_where() {
    const auto *node = file_.find("motions.where");
    if (!node) return;
    if (!node->is_table()) fail(*node, "motions.where must be a table: column = value");
    for (const auto &[name, entry] : *node->as_table()) {
      if (!entry.is_string() && !entry.is_number()) fail(entry, "motions.where: a value is a number or a text");
      study_.motions.where[std::string(name.str())] =
          entry.is_string() ? entry.as_string()->get() : fmt::format("{}", *entry.value<double>());
    }
  }

  void read_hazard() {
    const auto *points = file_.find("hazard.points");
    if (!points || !points->is_array())
      fail_at("hazard.points", "a study needs [hazard] points = [[S_a in g, return period in years], ...]");
    only(*file_.find("hazard")->as_table(), {"points"}, "hazard");
    for (const auto &entry : *points->as_array()) {
      const auto *pair = entry.as_array();
      if (!pair || pair->size() != 2) fail(entry, "a point of the hazard is [S_a in g, return period in years]");
      study_.hazard.push_back({number((*pair)[0], "hazard.points"), number((*pair)[1], "hazard.points")});
    }
    try {
      reliability::HazardCurve curve(study_.hazard);
    } catch (const InputError &error) {
      fail(*points, error.what());
    }
  }

  void read_limits() {
    const auto *list = file_.find("limit") ? file_.find("limit")->as_array() : nullptr;
    if (!list || list->empty()) fail_at("limit", "a study needs [[limit]] with quantity and values");
    for (const auto &entry : *list) {
      const auto *table = entry.as_table();
      if (!table) fail(entry, "limits are written [[limit]], one table each");
      only(*table, {"quantity", "values"}, "limit");
      const auto *quantity = table->get("quantity");
      if (!quantity || !quantity->is_string()) fail(entry, "a limit needs quantity = \"NAME\"");
      Limit limit{quantity->as_string()->get(), {}};
      const auto &known = quantities();
      if (std::find(known.begin(), known.end(), limit.quantity) == known.end())
        fail(*quantity, "limit.quantity: " + not_among(limit.quantity, known));
      for (const auto &other : study_.limits)
        if (other.quantity == limit.quantity)
          fail(*quantity, fmt::format("limit: \"{}\" is given twice; put its values into one", limit.quantity));
      limit.values = limit.quantity == collapsed ? std::vector<double>{1} : limit_values(entry, *table);
      study_.limits.push_back(std::move(limit));
    }
  }

  std::vector<double> limit_values(const toml::node &entry, const toml::table &limit) const {
    const auto *node = limit.get("values");
    if (!node) fail(entry, "a limit needs values, a list or { from = .., to = .., count = .. }");
    std::vector<double> values;
    if (const auto *list = node->as_array()) {
      for (const auto &value : *list) values.push_back(number(value, "limit.values"));
    } else if (const auto *table = node->as_table()) {
      only(*table, {"from", "to", "count"}, "limit.values");
      const double count = number_in(*table, "count", "limit.values");
      if (!(count >= 2 && count <= 1000 && count == std::floor(count)))
        fail(*node, "limit.values.count must be a whole number from 2 to 1000");
      for (const auto &value :
           fleets::even_values("variable.limit", number_in(*table, "from", "limit.values"),
                               number_in(*table, "to", "limit.values"), static_cast<int>(count), place(*node)))
        values.push_back(std::get<double>(value.cell));
    }
    std::sort(values.begin(), values.end());
    if (values.empty() || !(values.front() > 0) || std::adjacent_find(values.begin(), values.end()) != values.end())
      fail(*node, "limit.values must be different numbers > 0");
    return values;
  }

  void read_differences() {
    const auto *node = file_.find("difference");
    if (!node) return;
    const auto *list = node->as_array();
    if (!list) fail(*node, "differences are written [[difference]], one table each");
    for (const auto &entry : *list) {
      const auto *table = entry.as_table();
      if (!table) fail(entry, "differences are written [[difference]], one table each");
      only(*table, {"key", "reference"}, "difference");
      const auto *key = table->get("key"), *reference = table->get("reference");
      if (!key || !key->is_string() || !reference) fail(entry, "a difference needs key and reference");
      Difference difference{key->as_string()->get(), {}};
      if (const auto *text = reference->as_string())
        difference.reference = text->get();
      else
        difference.reference = number(*reference, "difference.reference");
      require_reference(difference, *key, *reference);
      study_.differences.push_back(std::move(difference));
    }
  }

  void require_reference(const Difference &difference, const toml::node &key, const toml::node &reference) const {
    bool key_known = false, value_known = false;
    const auto look = [&](const std::vector<fleets::Axis> &axes) {
      for (const auto &axis : axes) {
        if (axis.key != difference.key) continue;
        key_known = true;
        for (const auto &value : axis.values) value_known = value_known || value.cell == difference.reference;
      }
    };
    for (const auto &axes : study_.parts.cases) look(axes);
    for (const auto &axes : study_.parts.devices) look(axes);
    look(study_.parts.grid);
    if (!key_known)
      fail(key, fmt::format("difference.key: \"{}\" does not tell systems apart ([[case]], [[device]], [grid])",
                            difference.key));
    if (!value_known) fail(reference, fmt::format("difference.reference: no system has this {}", difference.key));
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
  static const std::vector<std::string> names{"peak_displacement_m",
                                              "peak_lateral_force_N",
                                              "peak_impact_force_N",
                                              "residual_displacement_m",
                                              "ductility",
                                              "peak_drift_m",
                                              "peak_storey_shear_N",
                                              "peak_floor_acceleration_m_s2",
                                              collapsed};
  return names;
}

Study parse_study(const std::string &text, const std::string &origin) {
  return StudyReader(TomlFile(text, origin), origin).read();
}

Study read_study(const std::string &path) {
  std::string text;
  try {
    text = read_file(path);
  } catch (const DataError &error) {
    throw InputError(error.what());
  }
  return parse_study(text, path);
}

} // namespace rimpact::risk
