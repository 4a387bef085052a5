#include "scene/bearing_keys.h"
#include "scene/steel_grades.h"

namespace rimpact::scene {
namespace {

constexpr Range length_mm{0, 1e5, true};
constexpr Range size_mm{0, 1e5};
constexpr Range length_m{0, 1e3, true};
constexpr Range coefficient{0, 2};
constexpr bool assumption = true;

void visit(KeyVisitor &v, Material &m) {
  v.number({"E_MPa", "Young's modulus"}, m.E, mega, {0, 1e9, true});
  v.number({"nu", "Poisson's ratio"}, m.nu, si, {0, 0.5, false, true});
  v.limit({"yield_MPa", "initial yield stress; inf: elastic"}, m.yield, mega, {0, 1e9, true});
  if (v.wants(m.yield.has_value() && m.hardening.law == HardeningLaw::bilinear))
    v.limit({"tangent_modulus_MPa", "slope past yield", assumption}, m.tangent_modulus, mega, {0, 1e9});
  v.number({"density_kg_per_m3", "mass density", assumption}, m.density, si, {0, 1e6, true});
}

/// The law is written where it is another than two straight lines, or than the grade's.
void visit_hardening(KeyVisitor &v, Material &m) {
  using enum HardeningLaw;
  Hardening &h = m.hardening;
  constexpr Range stress{0, 1e6, true}, share{0, 1, true};
  if (v.wants(h.law != bilinear || m.has_grade())) v.choice({"hardening"}, h.law);
  if (v.wants(h.law == table)) {
    v.rows({"curve", "[[plastic strain, true stress in MPa], ...] from a strain of 0, or a CSV file of them"}, h.curve,
           {Column{si, {0, 10}}, Column{mega, {0, 1e6}}});
    v.choice({"curve_kind"}, h.curve_kind);
  }
  if (v.wants(h.law == swift || h.law == ludwik)) v.number({"hardening_K_MPa", "K of the law"}, h.K, mega, stress);
  if (v.wants(h.law == swift)) v.number({"hardening_e0", "e0 of the law"}, h.e0, si, share);
  if (v.wants(h.law == swift || h.law == ludwik)) v.number({"hardening_n", "n of the law"}, h.n, si, share);
  if (v.wants(h.law == voce)) {
    v.number({"hardening_Q_MPa", "Q of the law"}, h.Q, mega, stress);
    v.number({"hardening_b", "b of the law"}, h.b, si, {0, 1e4, true});
  }
  if (v.wants(!h.chaboche.values.empty()))
    v.rows({"chaboche", "[[C in MPa, gamma], ...] of one or two backstresses, beside the curve's growth"}, h.chaboche,
           {Column{mega, stress}, Column{si, {0, 1e5}}});
}

void visit_fracture(KeyVisitor &v, const Material &m, Fracture &f) {
  if (!v.wants(f != Fracture{} || m.has_grade())) return;
  constexpr Range strain{0, 100};
  v.number({"fracture_D1", "plastic strain at fracture = D1 + D2 exp(D3 triaxiality), for the damage", assumption},
           f.D1, si, {0, 100, true});
  v.number({"fracture_D2", "D2 of that", assumption}, f.D2, si, strain);
  v.number({"fracture_D3", "D3 of that", assumption}, f.D3, si, {-100, 0});
  if (v.wants(f.C1 > 0))
    v.number({"fracture_C1", "plastic strain at fracture in shear, for the damage by Bao and Wierzbicki"}, f.C1, si,
             {0, 100, true});
  if (v.wants(f.C2 > 0)) v.number({"fracture_C2", "the same in plain tension"}, f.C2, si, {0, 100, true});
}

/// Before the numbers that follow from them.
void visit_origin(KeyVisitor &v, Material &m) {
  if (v.wants(m.has_grade())) v.word({"grade", "that gives what is not given here"}, m.grade, grade_names());
  if (v.wants(m.hardness_HB > 0))
    v.number({"hardness_HB", "Brinell; yield_MPa is estimated from it where it is not given"}, m.hardness_HB, si,
             {80, 450});
}

/// The model is written where it is one, so that a steel without it is described as ever.
void visit(KeyVisitor &v, StrainRate &r) {
  using enum RateModel;
  constexpr Range rate{0, 1e9, true};
  if (v.wants(r.model != none)) v.choice({"rate", "law of the flow stress over the plastic strain rate"}, r.model);
  if (v.wants(r.model == cowper_symonds)) {
    v.number({"rate_D_per_s", "flow stress = static one (1 + (rate / D)^(1 / q))", assumption}, r.D, si, rate);
    v.number({"rate_q", "q of that law", assumption}, r.q, si, {1, 100});
  }
  if (v.wants(r.model == johnson_cook)) {
    v.number({"rate_C", "flow stress = static one (1 + C ln(rate / reference))", assumption}, r.C, si, {0, 1, true});
    v.number({"rate_reference_per_s", "no growth up to this rate", assumption}, r.reference, si, rate);
  }
}

/// Written where heat softens the steel.
void visit(KeyVisitor &v, PlasticHeat &h) {
  if (!v.wants(h.model != Softening::none)) return;
  constexpr Range positive{0, 1e5, true};
  v.choice({"softening"}, h.model);
  if (!v.wants(h.model == Softening::adiabatic)) return;
  v.number({"taylor_quinney", "share of the plastic work that becomes heat", assumption}, h.share, si, {0, 1, true});
  v.number({"heat_capacity_J_per_kg_K", "specific heat of the steel", assumption}, h.capacity, si, positive);
  v.number({"melting_K", "rise of the temperature at which no flow stress is left", assumption}, h.melting, si,
           positive);
  v.number({"softening_exponent", "m of 1 - (rise / melting)^m", assumption}, h.exponent, si, {0, 10, true});
}

/// Written where the rim is not one piece with its plate.
void visit(KeyVisitor &v, RimConnection &c) {
  using enum ConnectionKind;
  constexpr Range factor{0, 10, true};
  if (!v.wants(c.kind != monolithic)) return;
  v.section("connection", [&] {
    v.choice({"kind"}, c.kind);
    if (v.wants(c.kind == fillet)) {
      v.number({"throat_mm", "of each of the two fillet welds"}, c.throat, milli, length_mm);
      v.number({"strength_MPa", "ultimate strength f_u of the weaker part they join", assumption}, c.strength, mega,
               {0, 1e4, true});
      v.number({"correlation", "beta_w of EN 1993-1-8, table 4.1", assumption}, c.correlation, si, factor);
    }
    if (v.wants(c.kind == bolts)) {
      v.integer({"number", "of bolts around the whole rim"}, c.number, 3, 1000);
      v.choice({"size", "of the bolts' thread"}, c.size);
      v.choice({"grade", "property class of the bolts"}, c.grade);
      v.number({"circle_mm", "diameter of the circle that the bolts stand on"}, c.circle, milli, length_mm);
    }
    v.number({"partial_factor", "gamma_M2 of welds and bolts", assumption}, c.partial_factor, si, {1, 3});
  });
}

/// Written of the parts that have a steel of their own.
void visit_part_steels(KeyVisitor &v, Bearing &b) {
  for (const SteelPart part : {SteelPart::rim, SteelPart::dish, SteelPart::slider}) {
    const auto own = b.part_steels.find(part);
    if (!v.wants(own != b.part_steels.end())) continue;
    Material steel = b.steel_of(part);
    const std::string table = word(part);
    v.section(table.c_str(), [&] { visit_steel(v, steel); });
    if (own != b.part_steels.end()) own->second = steel;
  }
}

void visit_foot_and_pad(KeyVisitor &v, Bearing &b) {
  v.section("pad", [&] {
    v.number({"inner_radius_mm", "of the ring-shaped pad; 0: a full disc", assumption}, b.pad.inner_radius, milli,
             size_mm);
    v.number({"outer_radius_mm", "of the pad", assumption}, b.pad.outer_radius, milli, length_mm);
    v.number({"thickness_mm", "of the pad", assumption}, b.pad.thickness, milli, length_mm);
    v.number({"recess_mm", "depth of its seat in the foot", assumption}, b.pad.recess, milli, size_mm);
    v.number({"shape_radius_mm", "radius of the pad's sliding face", assumption}, b.pad.shape_radius, milli, length_mm);
    if (v.wants(b.pad.loss_factor > 0))
      v.number({"loss_factor", "eta of the pad's material, at the frequency at which the load swings on it"},
               b.pad.loss_factor, si, {0, 0.5});
  });
  v.section("foot", [&] {
    v.number({"radius_mm", "of the foot below its cap", assumption}, b.foot.radius, milli, length_mm);
    v.number({"bottom_mm", "flat bottom above the vertex at rest", assumption}, b.foot.bottom, milli, size_mm);
    v.number({"shoulder_mm", "where its cap begins", assumption}, b.foot.shoulder, milli, length_mm);
    v.number({"cap_radius_mm", "spherical cap, centred on the middle of the sliding face", assumption},
             b.foot.cap_radius, milli, length_mm);
  });
}

/// Of a slider on a foot, or of one between two dishes.
void visit_height(KeyVisitor &v, Bearing &b) {
  if (v.wants(b.double_concave()))
    v.number({"height_mm", "H_s of a slider between two dishes, on its axis from face to face"}, b.slider.height, milli,
             length_mm);
  if (!v.wants(!b.double_concave())) return;
  v.number({"bottom_mm", "bottom plane above the vertex at rest", assumption}, b.slider.bottom, milli, length_mm);
  v.number({"top_mm", "top plane above the vertex at rest", assumption}, b.slider.top, milli, length_mm);
}

void visit(KeyVisitor &v, SurfaceSpec &s) {
  using enum SurfaceKind;
  const auto is = [&](auto... kind) { return v.wants(((s.kind == kind) || ...)); };
  v.choice({.name = "kind", .meaning = "form of the sliding surface"}, s.kind);
  if (is(ellipse, sphere, cone)) v.number({"R0_m", "radius of curvature at the vertex"}, s.R0, si, length_m);
  if (is(ellipse)) v.number({"a_m", "half-width of the ellipse"}, s.a, si, length_m);
  if (v.wants(s.concave == Concave::twice))
    v.choice({"concave", "whether two such dishes face each other, one slider between them"}, s.concave);
  if (is(cone)) v.number({"slope", "of the cone, rise over run; R0_m rounds its vertex"}, s.slope, si, {0, 1, true});
  if (is(polynomial)) {
    constexpr Range coefficient{-1e6, 1e6};
    v.number({"c2_per_m", "height = c2 r^2 + c3 r^3 + ... + c6 r^6"}, s.coefficients[0], si, coefficient);
    v.number({"c3_per_m2", "coefficient of r^3"}, s.coefficients[1], si, coefficient);
    v.number({"c4_per_m3", "coefficient of r^4"}, s.coefficients[2], si, coefficient);
    v.number({"c5_per_m4", "coefficient of r^5"}, s.coefficients[3], si, coefficient);
    v.number({"c6_per_m5", "coefficient of r^6"}, s.coefficients[4], si, coefficient);
  }
  if (is(table)) {
    v.numbers({"radius_mm", "rows of the table, from 0, growing"}, s.table_radius, milli, size_mm);
    v.numbers({"height_mm", "the surface above its vertex there"}, s.table_height, milli, size_mm);
  }
  if (v.wants(!s.table_file.empty()))
    v.text({"file", "CSV file of the table instead: radius_mm,height_mm"}, s.table_file);
  v.number({"planar_radius_mm", "the dish's edge"}, s.planar_radius, milli, length_mm);
}

void visit(KeyVisitor &v, ContactFriction &c) {
  v.number({"steel_steel", "friction of the socket on the foot's cap; two dishes have neither"}, c.steel_steel, si,
           coefficient);
  v.number({"steel_ertalyte", "friction of the pad on the dish; between two dishes, of the slider's faces"},
           c.steel_ertalyte, si, coefficient);
  v.number({"rim", "friction of the slider on the rim"}, c.rim, si, coefficient);
  const auto slow = [&](const Key &key, std::optional<double> &mu) {
    if (v.wants(mu.has_value())) v.limit(key, mu, si, coefficient);
  };
  slow({"steel_steel_slow", "at rest; inf: as steel_steel"}, c.steel_steel_slow);
  slow({"steel_ertalyte_slow", "at rest; inf: as steel_ertalyte"}, c.steel_ertalyte_slow);
  slow({"rim_slow", "at rest; inf: as rim"}, c.rim_slow);
  if (v.wants(c.steel_steel_slow || c.steel_ertalyte_slow || c.rim_slow))
    v.number({"rate_s_per_m", "of friction's growth with speed"}, c.rate, si, {0, 1e6});
  if (v.wants(c.reference_pressure.has_value()))
    v.limit(
        {"reference_pressure_MPa", "p0 of the pad's friction by pressure, 0.7^(0.02 (p - p0)); inf: not by pressure"},
        c.reference_pressure, mega, {0, 1e4});
  v.choice({.name = "pad_foot", .meaning = "how the pad sits in the foot"}, c.pad_foot);
  if (v.wants(c.pad_foot == PadFoot::frictional))
    v.number({"pad_clearance_mm", "radial, between the pad and the recess's wall around it", assumption},
             c.pad_clearance, milli, {0, 10});
}

} // namespace

void visit_steel(KeyVisitor &v, Material &steel) {
  visit_origin(v, steel);
  visit(v, steel);
  if (v.wants(steel.yield.has_value())) {
    visit_hardening(v, steel), visit(v, steel.rate), visit(v, steel.heat);
    visit_fracture(v, steel, steel.fracture);
  }
  v.limit({"strain_limit", "plastic strain beyond which results are doubted; inf: not judged", assumption},
          steel.strain_limit, si, {0, 10, true});
}

void visit(KeyVisitor &v, Bearing &b) {
  v.section("surface", [&] { visit(v, b.surface); });
  v.section("slider", [&] {
    v.number({"diameter_mm", "of the upper slider; what meets the rim"}, b.slider.diameter, milli, length_mm);
    visit_height(v, b);
    v.number({"edge_radius_mm", "rounding of the edge that meets the rim", assumption}, b.slider.edge_radius, milli,
             size_mm);
    if (v.wants(b.has_interface())) {
      v.limit({"mu_interface", "between the halves of a slider between two dishes (LIR-DCFP); inf: one piece"},
              b.slider.mu_interface, si, coefficient);
      v.number({"interface_gap_mm", "slip of the halves at which they meet their stop", assumption},
               b.slider.interface_gap, milli, length_mm);
    }
  });
  v.section("rim", [&] {
    v.number({"height_mm", "above the dish's edge", assumption}, b.rim.height, milli, length_mm);
    v.number({"thickness_mm", "radial thickness of the rim", assumption}, b.rim.thickness, milli, length_mm);
    v.number({"ledge_mm", "flat step between the dish's edge and the wall", assumption}, b.rim.ledge, milli, size_mm);
    visit(v, b.rim.connection);
  });
  v.section("plate", [&] {
    v.number({"base_mm", "bottom plane below the vertex", assumption}, b.plate.base, milli, length_mm);
  });
  if (v.wants(b.has_pad())) visit_foot_and_pad(v, b);
  v.section("material", [&] {
    v.section("steel", [&] { visit_steel(v, b.steel); });
    visit_part_steels(v, b);
    if (v.wants(b.has_pad())) v.section("ertalyte", [&] { visit(v, b.ertalyte); });
  });
  v.section("contact", [&] { visit(v, b.contact); });
}

} // namespace rimpact::scene
