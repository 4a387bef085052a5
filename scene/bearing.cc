#include "scene/bearing.h"
#include "scene/keys.h"
#include <cmath>
#include <numbers>

namespace rimpact::scene {
namespace {

/// Collects the keys marked as assumptions.
class AssumptionList final : public KeyVisitor {
public:
  std::vector<Assumption> list;

  void section(const char *name, const std::function<void()> &body) override {
    const std::string outer = path_;
    path_ += std::string(name) + ".";
    body();
    path_ = outer;
  }
  void number(const Key &key, double &value, Unit unit, Range) override {
    std::string text = file_number(value, unit);
    if (text.ends_with(".0")) text.resize(text.size() - 2);
    if (key.assumption) list.push_back({path_ + key.name, text});
  }
  void limit(const Key &key, std::optional<double> &value, Unit unit, Range range) override {
    if (value) number(key, *value, unit, range);
  }
  void integer(const Key &, int &, int, int) override {}
  void flag(const Key &, bool &) override {}
  void text(const Key &, std::string &) override {}
  void choice(const Key &, std::string &, const std::vector<std::string> &) override {}
  void pair(const Key &, Eigen::Vector2d &, Range) override {}
  void numbers(const Key &, std::vector<double> &, Unit, Range) override {}
  void switches(const Key &, const std::vector<std::pair<std::string, bool *>> &) override {}

private:
  std::string path_;
};

} // namespace

double Bearing::pad_area() const {
  return std::numbers::pi * (pad.outer_radius * pad.outer_radius - pad.inner_radius * pad.inner_radius);
}

std::vector<Assumption> assumptions(const Bearing &bearing) {
  AssumptionList visitor;
  Bearing copy = bearing;
  visit(visitor, copy);
  return visitor.list;
}

// The cap is centred on the middle of the sliding face, so the slider follows the contact point itself.
double tilt(const Bearing &bearing, double travel) {
  return std::atan(make_surface(bearing.surface)->at(travel, 0).gradient.x());
}

double lift(const Bearing &bearing, double travel) {
  return make_surface(bearing.surface)->at(travel, 0).z;
}

} // namespace rimpact::scene
