#include "scene/range_check.h"

#include "io/files/error.h"
#include "io/files/path_visitor.h"
#include "io/files/text.h"
#include "scene/bearing_keys.h"
#include "scene/scene_keys.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// Throws InputError at the first value outside its range.
class RangeCheck final : public PathVisitor {
public:
  void number(const Key &key, double &value, Unit unit, Range range) override {
    // The conversion's rounding must not push a value at a bound over it.
    const double shown = std::isfinite(value) ? *to_number(file_number(value, unit)) : value;
    if (!range.contains(shown)) fail(key, fmt::format("{} must be {}", shown, range.text_for(shown)));
  }
  void limit(const Key &key, std::optional<double> &value, Unit unit, Range range) override {
    if (value) number(key, *value, unit, range);
  }
  void integer(const Key &key, int &value, int low, int high) override {
    if (value < low || value > high) fail(key, fmt::format("{} must be between {} and {}", value, low, high));
  }
  void pair(const Key &key, Eigen::Vector2d &value, Range range) override {
    for (double component : value)
      if (!range.contains(component)) fail(key, fmt::format("{} must be {}", component, range.text_for(component)));
  }
  void numbers(const Key &key, std::vector<double> &values, Unit unit, Range range) override {
    for (double &value : values) number(key, value, unit, range);
  }
  void rows(const Key &key, Rows &rows, const std::array<Column, 2> &columns) override {
    for (auto &row : rows.values)
      for (std::size_t i = 0; i < 2; ++i) number(key, row[i], columns[i].unit, columns[i].range);
  }
  void flag(const Key &, bool &) override {}
  void text(const Key &, std::string &) override {}
  void word(const Key &, std::string &, const std::vector<std::string> &) override {}
  void switches(const Key &, const std::vector<std::pair<std::string, bool *>> &) override {}

private:
  [[noreturn]] void fail(const Key &key, const std::string &what) const {
    throw InputError(fmt::format("{} {}", path(key), what));
  }
};

} // namespace

void check_ranges(const Bearing &bearing) {
  RangeCheck check;
  Bearing copy = bearing;
  visit(check, copy);
}

void check_ranges(const Scene &scene) {
  RangeCheck check;
  Scene copy = scene;
  visit_settings(check, copy);
}

} // namespace rimpact::scene
