// rimpact design: T_eff, damping, shears, displacement and yield displacement of a friction-pendulum isolation system.
#include "app/verbs/catalogue.h"
#include "io/files/json_text.h"
#include "reduced_models/isolation_design.h"
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace rimpact::app {
namespace {

struct DesignOptions {
  reduced::IsolationDesignInput input;
  std::optional<double> period, weight_kN;
  std::vector<std::string> assumed; ///< sentences: what nobody gave and the thesis's bearing has
};

nlohmann::ordered_json to_json(const DesignOptions &options, const reduced::IsolationDesign &d) {
  nlohmann::ordered_json json{{"radius_m", options.input.radius},
                              {"mu", options.input.friction},
                              {"gamma", options.input.mass_ratio},
                              {"D_M_m", d.displacement},
                              {"D_TM_m", d.total_displacement},
                              {"T_eff_s", d.effective_period},
                              {"damping", d.damping},
                              {"V_b_over_W", d.base_shear},
                              {"V_st_over_W", d.structure_shear},
                              {"V_s_over_W", d.design_shear}};
  json["u_y_m"] = d.yield_displacement ? nlohmann::ordered_json(*d.yield_displacement) : nlohmann::ordered_json();
  if (options.weight_kN) {
    json["V_b_kN"] = d.base_shear * *options.weight_kN, json["V_st_kN"] = d.structure_shear * *options.weight_kN;
    json["V_s_kN"] = d.design_shear * *options.weight_kN;
  }
  json["remarks"] = d.remarks, json["assumed"] = options.assumed;
  return json;
}

std::string to_text(const DesignOptions &options, const reduced::IsolationDesign &d) {
  const auto force = [&](double share) {
    return options.weight_kN ? fmt::format("  = {:.1f} kN", share * *options.weight_kN) : "";
  };
  std::string text = fmt::format("D_M    {:9.4f} m      displacement{}\n", d.displacement,
                                 options.input.displacement ? ", as given" : ", from the spectrum");
  text +=
      fmt::format("D_TM   {:9.4f} m      1.15 D_M: the least allowance for accidental torsion\n", d.total_displacement);
  text += fmt::format("T_eff  {:9.4f} s      effective period\n", d.effective_period);
  text += fmt::format("beta   {:9.4f}        equivalent viscous damping\n", d.damping);
  text += fmt::format("V_b    {:9.4f} W      shear of the isolation system{}\n", d.base_shear, force(d.base_shear));
  text += fmt::format("V_st   {:9.4f} W      unreduced shear above the base level{}\n", d.structure_shear,
                      force(d.structure_shear));
  if (options.input.reduction > 1)
    text += fmt::format("V_s    {:9.4f} W      V_st / R_I{}\n", d.design_shear, force(d.design_shear));
  if (d.yield_displacement)
    text += fmt::format("u_y    {:9.4f} mm     yield displacement, by the total mass m_s + m_b\n",
                        1e3 * *d.yield_displacement);
  for (const auto &sentence : options.assumed) text += sentence + "\n";
  return text;
}

void add_design(CLI::App &verb, Console &console) {
  auto options = std::make_shared<DesignOptions>();
  auto &in = options->input;
  auto *radius = verb.add_option("--radius-m", in.radius, "R of the pendulum [m]")->capture_default_str();
  verb.add_option("--period-s", options->period, "pendulum period 2 pi sqrt(R/g) [s], in the place of R")
      ->excludes(radius);
  auto *friction = verb.add_option("--mu", in.friction, "friction coefficient")->capture_default_str();
  auto *displacement = verb.add_option("--displacement-m", in.displacement, "D_M [m], where it is known");
  verb.add_option("--sm1-g", in.spectral_acceleration, "S_M1 = F_v S_1 [g], from which D_M is found")
      ->excludes(displacement);
  verb.add_option("--gamma", in.mass_ratio, "mass ratio m_s / (m_s + m_b)")->capture_default_str();
  verb.add_option("--Ts-s", in.superstructure_period, "period of the fixed-base structure [s]: gives u_y");
  verb.add_option("--reduction", in.reduction, "R_I")->capture_default_str();
  verb.add_option("--weight-kN", options->weight_kN, "W [kN]: gives the shears in kN");
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([options, radius, friction, &console] {
    auto &input = options->input;
    if (options->period) {
      if (!(*options->period > 0 && *options->period < 60))
        throw InputError(fmt::format("period_s = {:g} must be above 0 and below 60", *options->period));
      input.radius = input.gravity * std::pow(*options->period / (2 * std::numbers::pi), 2);
    }
    if (radius->count() == 0 && !options->period)
      options->assumed.push_back(fmt::format("assumed: R = {:g} m, the thesis's; yours by --radius-m", input.radius));
    if (friction->count() == 0)
      options->assumed.push_back(fmt::format("assumed: mu = {:g}, the thesis's; yours by --mu", input.friction));
    constexpr double heaviest = 1e9; // [kN]
    if (const auto weight = options->weight_kN; weight && !(*weight > 0 && *weight <= heaviest))
      throw InputError(fmt::format("--weight-kN {:g} must be > 0 and <= {:g}", *weight, heaviest));
    const auto design = reduced::design_isolation(input);
    console.data(console.json ? json_text(to_json(*options, design)) : to_text(*options, design));
    for (const auto &sentence : design.remarks) console.warn(sentence);
  });
}

} // namespace

const Verb design_verb{{.name = "design",
                        .help = "preliminary design of a friction-pendulum system (ASCE/SEI 7-16, 17.5)",
                        .examples = "rimpact design --sm1-g 0.87 --mu 0.07 --gamma 0.75 --Ts-s 0.5 --weight-kN 853",
                        .next = "rimpact new DIR, then a history: rimpact reduced DIR/scene.toml"},
                       add_design};

} // namespace rimpact::app
