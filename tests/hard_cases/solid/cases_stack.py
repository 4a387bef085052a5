"""Hard cases of rungs rigid-dish and full, on the draft mesh: name, must be right, (scene, settings), expected exit code, check of the summary."""
from checks import close_to, impacts

BASE = "reference: 0.2 m/s"
ON_THE_DISH = ['excitation.with=["weight","friction"]', "excitation.duration_s=0.05"]


def window(*more, speed=0.2, dish=ON_THE_DISH):
    return "impact-window", [f"excitation.speed_m_per_s={speed}", *dish, *more]


def friction(mu):
    return [f"bearing.contact.steel_ertalyte={mu}", f"bearing.contact.steel_steel={mu}"]


def cases(program, folder):
    return [
        (BASE, True, window(), 0, impacts(1)),
        ("grazing, 5 mm/s", True, window(speed=0.005), 0, lambda s, of: s["peak_impact_force_N"] > 0),
        ("1.0 m/s", False, window(speed=1.0), 0, impacts(1)),
        ("1.5 m/s", True, window("excitation.duration_s=0.08", speed=1.5), 0, impacts(1)),
        ("from the other side", True, window("excitation.direction_deg=180"), 0, close_to(BASE, 1e-3)),
        ("mu 0", True, window(*friction(0)), 0, impacts(1)),
        ("mu 0.3", True, window(*friction(0.3)), 0, impacts(1)),
        ("friction at the rim, 0.2", True, window("bearing.contact.rim=0.2"), 0, impacts(1)),
        ("Poisson 0.499 in the pad", True, window("bearing.material.ertalyte.nu=0.499"), 0, close_to(BASE, 0.02)),
        ("yield 100 MPa", True, window("bearing.material.steel.yield_MPa=100"), 0, impacts(1)),
        ("yield 1000 MPa", True, window("bearing.material.steel.yield_MPa=1000"), 0, impacts(1)),
        ("no hardening", True, window("bearing.material.steel.tangent_modulus_MPa=0"), 0, impacts(1)),
        ("penalty x 0.01", True, window("model.penalty_scale=0.01"), 0, close_to(BASE, 0.02)),
        ("penalty x 100", True, window("model.penalty_scale=100"), 0, close_to(BASE, 0.01)),
        ("rho_inf 0", True, window("model.rho_inf=0"), 0, close_to(BASE, 0.01)),
        ("rho_inf 1", True, window("model.rho_inf=1"), 0, close_to(BASE, 0.01)),
        ("steps x 10", False, window("model.step_ms=10"), 0, close_to(BASE, 0.05)),
        ("a tenth of the weight", True, window("load.vertical_kN=85.3", "load.mass_kg=86952"), 0, impacts(1)),
        ("zero vertical load", True, window("load.vertical_kN=0"), 2, "load.vertical_kN 0"),
        ("no weight on the dish", True, window(dish=[]), 2, "weightless"),
        ("negative tangent modulus", True, window("bearing.material.steel.tangent_modulus_MPa=-10"), 2, "must be >= 0"),
        ("frictional foot in the pad", True, window('bearing.contact.pad_foot="frictional"'), 0, close_to(BASE, 0.03)),
    ]


MESH = 0
NOTES = """# Elsewhere: resumed in mid-slip and mid-impact (tests/fe_contact/test_restart.cc, app_dish_resume), ranks
# (tests/fe_contact/test_ranks.cc, app_dish_ranks). Spikes, tiny shaking, upward accelerations, repeated and oblique impacts: rung rim.
"""
