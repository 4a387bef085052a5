#include "studies/risk/motions_reader.h"
#include "io/files/error.h"
#include "io/files/toml_reader.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

void read_sets(TomlReader &reader, const std::string &origin, std::vector<MotionSet> &sets) {
  reader.tables("set", [&] {
    MotionSet set;
    reader.text({"search_results"}, set.search_results);
    reader.number({"level"}, set.level, si, {0, huge, true});
    if (set.search_results.empty()) reader.refuse("", "a set needs search_results = \"FILE\"");
    if (!reader.has("level")) reader.refuse("", "motions.set needs level");
    set.search_results = beside(origin, set.search_results);
    sets.push_back(std::move(set));
  });
}

/// Any column = value.
void read_where(TomlReader &reader, std::map<std::string, std::string> &where) {
  const auto *node = reader.node({"where"});
  if (!node) return;
  if (!node->is_table()) reader.refuse("where", "motions.where must be a table: column = value");
  for (const auto &[name, entry] : *node->as_table()) {
    if (!entry.is_string() && !entry.is_number())
      reader.refuse("where", "motions.where: a value is a number or a text");
    where[std::string(name.str())] =
        entry.is_string() ? entry.as_string()->get() : fmt::format("{}", *entry.value<double>());
  }
}

} // namespace

std::string beside(const std::string &origin, const std::string &name) {
  namespace fs = std::filesystem;
  return fs::absolute(fs::path(origin).parent_path() / name).lexically_normal().string();
}

MotionSource read_motions(const TomlFile &file, const std::string &origin) {
  if (!file.find("motions"))
    throw InputError(
        fmt::format("{}: a study needs [motions]: folders of records, a table of them", file.location("motions")));
  MotionSource motions;
  TomlReader reader(file, "motions");
  reader.text({"table"}, motions.table);
  reader.choice({"level_is"}, motions.level_is);
  reader.choice({"component"}, motions.component);
  reader.choice({"list"}, motions.list);
  reader.choice({"scale"}, motions.scale);
  reader.section("columns", [&] {
    reader.text({"level"}, motions.level_column);
    reader.text({"rsn"}, motions.rsn_column);
    reader.text({"component"}, motions.component_column);
    reader.text({"factor"}, motions.factor_column);
  });
  reader.texts({"folders"}, motions.folders);
  for (auto &folder : motions.folders) folder = beside(origin, folder);
  read_sets(reader, origin, motions.sets);
  read_where(reader, motions.where);
  reader.finish();
  if (!motions.table.empty()) motions.table = beside(origin, motions.table);
  return motions;
}

} // namespace rimpact::risk
