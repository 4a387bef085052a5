#include "studies/risk/differences_reader.h"
#include "io/files/toml_reader.h"
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

/// Refuses a key that no part of the study varies, and a reference that none of its values is.
void require_reference(const TomlReader &reader, const Difference &difference, const fleets::SweepParts &parts) {
  bool key_known = false, value_known = false;
  const auto look = [&](const std::vector<fleets::Axis> &axes) {
    for (const auto &axis : axes) {
      if (axis.key != difference.key) continue;
      key_known = true;
      for (const auto &value : axis.values) value_known = value_known || value.cell == difference.reference;
    }
  };
  for (const auto &axes : parts.cases) look(axes);
  for (const auto &axes : parts.devices) look(axes);
  look(parts.grid);
  if (!key_known)
    reader.refuse("key",
                  fmt::format("difference.key: \"{}\" does not tell systems apart ([[case]], [[device]], [grid])",
                              difference.key));
  if (!value_known)
    reader.refuse("reference", fmt::format("difference.reference: no system has this {}", difference.key));
}

} // namespace

std::vector<Difference> read_differences(const TomlFile &file, const fleets::SweepParts &parts) {
  TomlReader reader(file, "");
  std::vector<Difference> differences;
  reader.tables("difference", [&] {
    Difference difference;
    reader.text({"key"}, difference.key);
    const auto *reference = reader.node({"reference"});
    if (difference.key.empty() || !reference) reader.refuse("", "a difference needs key and reference");
    if (const auto *text = reference->as_string()) {
      difference.reference = text->get();
    } else {
      double number = 0;
      reader.number({"reference"}, number, si, {-huge, huge});
      difference.reference = number;
    }
    require_reference(reader, difference, parts);
    differences.push_back(std::move(difference));
  });
  return differences;
}

} // namespace rimpact::risk
