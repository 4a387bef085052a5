#include "calibration/export/dish_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {
namespace {

std::string friction_of(const Dish &dish) {
  return dish.is_coulomb()
             ? fmt::format("Coulomb, {:g}", dish.face_fast)
             : fmt::format("{:g} slow, {:g} fast, rate {:g} s/m", dish.face_slow, dish.face_fast, dish.face_rate);
}

std::string stack_line(const Dish &dish) {
  return dish.stack.empty() ? "Pad and socket: no term of theirs is in the dish, for the scene has none."
                            : fmt::format("Pad and socket: {}.", fmt::join(dish.stack, "; "));
}

std::string pad_line(const Dish &dish) {
  return "Vertical stiffness: the pad's E A / t." + dish.pad_remark;
}

} // namespace

std::vector<std::string> flat_lines(const Dish &dish, double vertical) {
  std::vector<std::string> all;
  if (dish.sphere)
    all.push_back(fmt::format("Dish: sphere of {:.6g} m. Its element restores N r / R, with N the force it carries: "
                              "{:+.2f} % at half the way to the rim, {:+.2f} % at the rim against W h'(r).",
                              dish.radius, 100 * dish.error_half, 100 * dish.error_full));
  else
    all.push_back(fmt::format("Dish: no sphere. Its restoring force is the table W h'(r) for the dead load W = {:.6g} "
                              "kN: it does not follow a changing normal force (overturning, vertical motion). "
                              "A sphere of the vertex radius {:.4g} m would be off by {:+.1f} % at half the way to the "
                              "rim and {:+.1f} % at the rim.",
                              vertical / 1e3, dish.radius, 100 * dish.error_half, 100 * dish.error_full));
  all.push_back("The slider of these links stays in its plane: it does not rise, so its normal force misses the "
                "acceleration of the rise, and the rim's push does not unload it. What that does is measured below.");
  all.push_back(fmt::format("Friction of the sliding face: {}. Its coefficient here is the mean from the centre to the "
                            "rim, {:.5g}, for friction acts along the slope. It is built up over {:.3g} mm, on the "
                            "normal force of the element.",
                            friction_of(dish), dish.mu_fast, 1e3 * dish.elastic_slip));
  all.push_back(pad_line(dish));
  all.push_back(stack_line(dish));
  return all;
}

std::vector<std::string> riding_lines(const Dish &dish, double vertical) {
  double most = 0;
  for (const double share : dish.left) most = std::max(most, std::abs(share));
  std::vector<std::string> all;
  all.push_back(fmt::format("Dish: the slider rides on an ellipsoid of half-widths {:.6g} and {:.6g} m, so that it "
                            "rises. Restoring force and "
                            "friction follow the normal force N it carries: overturning, vertical motion, the rise "
                            "itself and the rim's push.",
                            dish.rider.half_width, dish.rider.ratio * dish.rider.half_width));
  all.push_back(fmt::format("What the ellipsoid leaves of the dish is the table dish_force_left, for the dead load W = "
                            "{:.6g} kN. It is at most {:.3g} kN and does not follow N.",
                            vertical / 1e3, most * vertical / 1e3));
  all.push_back(
      fmt::format("Friction of the sliding face: {}. Of it {:.5g} N acts at the sliding element, and {:.3g} W "
                  "p, p the slope, against the rise: together they are friction along the slope. It is built "
                  "up over {:.3g} mm.",
                  friction_of(dish), dish.ride_fast, dish.rises, 1e3 * dish.elastic_slip));
  all.push_back(pad_line(dish));
  all.push_back(stack_line(dish));
  return all;
}

} // namespace rimpact::calibration
