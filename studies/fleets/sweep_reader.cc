#include "studies/fleets/sweep_reader.h"
#include "io/files/text.h"
#include "scene/scene.h"
#include "studies/fleets/latin_hypercube_reader.h"
#include "studies/fleets/record_cases.h"
#include "studies/fleets/sweep_toml.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::fleets {
namespace {

const std::vector<std::string> part_names = {"case",   "device",    "records",  "grid", "latin_hypercube",
                                             "linked", "fractiles", "plausible"};

class PartsReader : SweepToml {
public:
  using SweepToml::SweepToml;

  SweepParts read(const std::vector<std::string> &also) {
    std::vector<std::string> known = part_names;
    known.insert(known.end(), also.begin(), also.end());
    for (const auto &[name, node] : file_.root())
      if (std::find(known.begin(), known.end(), name.str()) == known.end()) fail(node, unknown_word(name.str(), known));
    read_cases("case", parts_.cases);
    read_cases("device", parts_.devices);
    read_records();
    each_key("grid", [&](const std::string &key, const toml::node &node) {
      parts_.grid.push_back({key, grid_values(key, node)});
    });
    read_latin_hypercube(file_, origin_, parts_);
    each_key("linked", [&](const std::string &key, const toml::node &node) { read_linked(key, node); });
    read_fractiles();
    parts_.plausible = read_plausible(file_);
    return std::move(parts_);
  }

private:
  /// `part`: case or device, which is also the column of the names.
  void read_cases(const std::string &part, std::vector<std::vector<Axis>> &cases) const {
    const auto *node = file_.root().get(part);
    if (!node) return;
    const std::string form = fmt::format("{0}s are written [[{0}]], one table each", part);
    each_table(*node, form, [&](const toml::table &entry) {
      std::vector<Axis> axes;
      leaves(entry, "", [&](const std::string &key, const toml::node &leaf) {
        if (key != "name") return axes.push_back({key, {value(key, leaf)}});
        if (!leaf.is_string()) fail(leaf, "name must be a text");
        axes.push_back({part, {{leaf.as_string()->get(), leaf.as_string()->get()}}});
      });
      const auto &first = cases.empty() ? axes : cases.front();
      const auto same = [](const Axis &a, const Axis &b) { return a.key == b.key; };
      if (!std::equal(axes.begin(), axes.end(), first.begin(), first.end(), same))
        fail(entry, fmt::format("this {} has not the same keys as the first one", part));
      cases.push_back(std::move(axes));
    });
    if (cases.empty()) fail(*node, form);
  }

  void read_records() {
    const auto *node = file_.root().get("records");
    if (!node) return;
    std::string folder;
    Components components{};
    double period = 0;
    TomlReader reader(file_, "");
    reader.section("records", [&] {
      reader.text({"folder"}, folder);
      reader.choice({"components"}, components);
      reader.number({"sa_period_s"}, period, si, {0.01, 100});
    });
    for (const char *needed : {"records.folder", "records.components"})
      if (!file_.find(needed)) fail(*node, fmt::format("[records] needs {}", needed));
    parts_.records = record_cases(folder, components, period, file_.location("records.folder"));
  }

  /// Files are sought beside the sweep file.
  RecordCases record_cases(const std::string &folder, Components components, double period,
                           const std::string &where) const {
    try {
      return cases_of_folder((std::filesystem::path(origin_).parent_path() / folder).string(), components, period);
    } catch (const InputError &error) {
      throw InputError(fmt::format("{}: records.folder: {}", where, error.what()));
    }
  }

  void read_fractiles() {
    if (!file_.root().get("fractiles")) return;
    TomlReader reader(file_, "fractiles");
    std::string &along = parts_.fractiles_along;
    std::vector<std::string> &by = parts_.fractiles_by;
    reader.text({"along"}, along);
    reader.texts({"by"}, by);
    reader.finish();
    if (along.empty()) reader.refuse("", "[fractiles] needs along = \"KEY\"");
    const auto require_known = [&](const char *name, const std::string &key) {
      if (!varies(key) && !is_linked(key))
        reader.refuse(name, fmt::format("fractiles.{}: \"{}\" is no key of this sweep", name, key));
    };
    require_known("along", along);
    for (auto key = by.begin(); key != by.end(); ++key) {
      require_known("by", *key);
      if (*key == along || std::find(by.begin(), key, *key) != key)
        reader.refuse("by", fmt::format("fractiles.by: \"{}\" is given twice", *key));
    }
  }
  bool is_linked(const std::string &name) const {
    return std::any_of(parts_.linked.begin(), parts_.linked.end(), [&](const auto &l) { return l.key == name; });
  }

  std::vector<Value> grid_values(const std::string &key, const toml::node &node) const {
    std::vector<Value> values;
    if (const auto *list = node.as_array()) {
      for (const auto &entry : *list) values.push_back(value(key, entry));
    } else if (const auto *table = node.as_table()) {
      only(*table, {"from", "to", "count"}, key);
      const double from = number_in(*table, "from", key), to = number_in(*table, "to", key),
                   count = number_in(*table, "count", key);
      if (!(count >= 2 && count <= largest_fleet && count == std::floor(count)))
        fail(*table->get("count"), fmt::format("{}.count must be a whole number from 2 to {}", key, largest_fleet));
      values = even_values(key, from, to, static_cast<int>(count), place(node));
    } else {
      fail(node, key + " must be a list of values or { from = .., to = .., count = .. }");
    }
    if (values.empty()) fail(node, key + " has no values");
    return values;
  }

  void read_linked(const std::string &key, const toml::node &node) {
    const auto *table = node.as_table();
    const auto *list = table ? table->get_as<toml::array>("product") : nullptr;
    if (!list || list->empty()) fail(node, key + " must be { product = [..] } of numbers and keys");
    only(*table, {"product", "over"}, key);
    LinkedKey linked{key, place(node), 1, {}, {}};
    for (const auto &entry : *list)
      if (entry.is_string())
        linked.factors.push_back(varying(entry, key));
      else
        linked.factor *= number(entry, key + ".product");
    if (const auto *over = table->get("over")) {
      if (!over->is_string()) fail(*over, key + ".over must be one key");
      linked.divisor = varying(*over, key);
    }
    parts_.linked.push_back(std::move(linked));
  }
  std::string varying(const toml::node &node, const std::string &key) const {
    std::string name = node.as_string()->get();
    if (!varies(name)) fail(node, fmt::format("{} uses \"{}\", which no part above sets", key, name));
    return name;
  }
  bool varies(const std::string &name) const {
    const auto has = [&](const auto &axes) {
      return std::any_of(axes.begin(), axes.end(), [&](const auto &axis) { return axis.key == name; });
    };
    return has(parts_.grid) || has(parts_.sampled) || (!parts_.cases.empty() && has(parts_.cases.front())) ||
           (!parts_.devices.empty() && has(parts_.devices.front())) ||
           (!parts_.records.cases.empty() && has(parts_.records.cases.front()));
  }

  SweepParts parts_;
};

} // namespace

std::vector<Value> even_values(const std::string &key, double from, double to, int count, const std::string &place) {
  std::vector<Value> values;
  for (int i = 0; i < count; ++i) {
    const double share = i / std::max(1.0, count - 1.0), exact = std::lerp(from, to, share);
    const bool end = i == 0 || i + 1 == count; // between the ends 0.8, not 0.7999999999999999
    values.push_back(number_value(end ? exact : to_number(fmt::format("{:.14g}", exact)).value_or(exact)));
    if (!is_variable(key)) scene::check_assignment(key + "=" + values.back().toml, place);
  }
  return values;
}

SweepParts read_parts(const TomlFile &file, const std::string &origin, const std::vector<std::string> &also) {
  return PartsReader(file, origin).read(also);
}

} // namespace rimpact::fleets
