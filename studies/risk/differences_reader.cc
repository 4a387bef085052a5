#include "studies/risk/differences_reader.h"
#include "io/files/error.h"
#include "studies/fleets/sweep_toml.h"
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

class DifferencesReader : fleets::SweepToml {
public:
  DifferencesReader(const TomlFile &file, const std::string &origin, const fleets::SweepParts &parts)
      : SweepToml(file, origin), parts_(parts) {}

  std::vector<Difference> read() const {
    const auto *node = file_.find("difference");
    if (!node) return {};
    std::vector<Difference> differences;
    each_table(*node, "differences are written [[difference]], one table each", [&](const toml::table &entry) {
      only(entry, {"key", "reference"}, "difference");
      const auto *key = entry.get("key"), *reference = entry.get("reference");
      if (!key || !key->is_string() || !reference) fail(entry, "a difference needs key and reference");
      Difference difference{key->as_string()->get(), {}};
      if (const auto *text = reference->as_string())
        difference.reference = text->get();
      else
        difference.reference = number(*reference, "difference.reference");
      require_reference(difference, *key, *reference);
      differences.push_back(std::move(difference));
    });
    return differences;
  }

private:
  void require_reference(const Difference &difference, const toml::node &key, const toml::node &reference) const {
    bool key_known = false, value_known = false;
    const auto look = [&](const std::vector<fleets::Axis> &axes) {
      for (const auto &axis : axes) {
        if (axis.key != difference.key) continue;
        key_known = true;
        for (const auto &value : axis.values) value_known = value_known || value.cell == difference.reference;
      }
    };
    for (const auto &axes : parts_.cases) look(axes);
    for (const auto &axes : parts_.devices) look(axes);
    look(parts_.grid);
    if (!key_known)
      fail(key, fmt::format("difference.key: \"{}\" does not tell systems apart ([[case]], [[device]], [grid])",
                            difference.key));
    if (!value_known) fail(reference, fmt::format("difference.reference: no system has this {}", difference.key));
  }

  const fleets::SweepParts &parts_;
};

} // namespace

std::vector<Difference> read_differences(const TomlFile &file, const std::string &origin,
                                         const fleets::SweepParts &parts) {
  return DifferencesReader(file, origin, parts).read();
}

} // namespace rimpact::risk
