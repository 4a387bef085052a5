#include "studies/risk/motions_reader.h"
#include "io/files/error.h"
#include "studies/fleets/sweep_toml.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

class MotionsReader : fleets::SweepToml {
public:
  using SweepToml::SweepToml;

  MotionSource read() {
    if (!file_.find("motions"))
      throw InputError(
          fmt::format("{}: a study needs [motions]: folders of records, a table of them", file_.location("motions")));
    TomlReader reader(file_, "motions");
    reader.text({"table"}, motions_.table);
    reader.choice({"level_is"}, motions_.level_is);
    reader.choice({"component"}, motions_.component);
    reader.choice({"list"}, motions_.list);
    reader.choice({"scale"}, motions_.scale);
    reader.section("columns", [&] {
      reader.text({"level"}, motions_.level_column);
      reader.text({"rsn"}, motions_.rsn_column);
      reader.text({"component"}, motions_.component_column);
      reader.text({"factor"}, motions_.factor_column);
    });
    reader.finish({"folders", "where", "set"});
    read_folders();
    read_sets();
    read_where();
    if (!motions_.table.empty()) motions_.table = beside(origin_, motions_.table);
    return std::move(motions_);
  }

private:
  void read_folders() {
    const auto *node = file_.find("motions.folders");
    if (!node) return;
    const auto *list = node->as_array();
    if (!list) fail(*node, "motions.folders must be a list of folders");
    for (const auto &entry : *list) {
      if (!entry.is_string()) fail(entry, "motions.folders must be a list of folders");
      motions_.folders.push_back(beside(origin_, entry.as_string()->get()));
    }
  }

  void read_sets() {
    const auto *node = file_.find("motions.set");
    if (!node) return;
    each_table(*node, "sets are written [[motions.set]], one table each", [&](const toml::table &entry) {
      only(entry, {"search_results", "level"}, "motions.set");
      const auto *file = entry.get("search_results");
      if (!file || !file->is_string()) fail(entry, "a set needs search_results = \"FILE\"");
      const double level = number_in(entry, "level", "motions.set");
      if (!(level > 0)) fail(entry, fmt::format("motions.set.level {} must be > 0", level));
      motions_.sets.push_back({beside(origin_, file->as_string()->get()), level});
    });
  }

  void read_where() {
    const auto *node = file_.find("motions.where");
    if (!node) return;
    if (!node->is_table()) fail(*node, "motions.where must be a table: column = value");
    for (const auto &[name, entry] : *node->as_table()) {
      if (!entry.is_string() && !entry.is_number()) fail(entry, "motions.where: a value is a number or a text");
      motions_.where[std::string(name.str())] =
          entry.is_string() ? entry.as_string()->get() : fmt::format("{}", *entry.value<double>());
    }
  }

  MotionSource motions_;
};

} // namespace

std::string beside(const std::string &origin, const std::string &name) {
  namespace fs = std::filesystem;
  return fs::absolute(fs::path(origin).parent_path() / name).lexically_normal().string();
}

MotionSource read_motions(const TomlFile &file, const std::string &origin) {
  return MotionsReader(file, origin).read();
}

} // namespace rimpact::risk
