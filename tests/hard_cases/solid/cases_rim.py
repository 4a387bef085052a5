"""Hard cases of rung rim, mesh 1: name, must be right, (scene, settings), expected exit code, check of the summary."""
from checks import close_to, impacts
from skewed_mesh import skewed

PULSE, WINDOW = "ricker-0.78g-1.0s", "impact-window"
WEIGHT = 'excitation.with=["weight","friction"]'


def window(speed, *more):
    return WINDOW, [f"excitation.speed_m_per_s={speed}", *more]


def free(u, v, seconds, *more):
    return WINDOW, ['excitation.kind="free"', f"excitation.displacement_m={list(u)}", f"excitation.velocity_m_per_s={list(v)}",
                    f"excitation.duration_s={seconds}", *more]


def record(stem, axis, seconds):
    """A record of rest with what `axis` = {"x": function of time [g]} says, every 5 ms."""
    settings = ['excitation.kind="record"', f"excitation.duration_s={seconds}"]
    for name, value in axis.items():
        file = stem.with_name(f"{stem.name}_{name}.csv")
        file.write_text("time_s,acceleration_g\n" + "".join(f"{k * 0.005:.3f},{value(k * 0.005):.6g}\n"
                                                             for k in range(int(seconds / 0.005) + 1)))
        settings.append(f'excitation.{name}="{file}"')
    return PULSE, settings


def cases(program, folder, close=0.001):
    """close: by what the peak force may move with the penalty, relative."""
    base = window(0.2)
    spike = record(folder / "spike", {"x": lambda t: 1.0 if 1.0 <= t < 1.05 else 0.0}, 4)
    tiny = record(folder / "tiny", {"x": lambda t: 0.002 * ((int(t / 0.3) % 2) * 2 - 1)}, 100)

    def lifted(g, until):
        return record(folder / f"lifted_{g}g", {"x": lambda t: g if 1 <= t < until else 0.0, "z": lambda t: -1.3 if 1.2 <= t < 1.3 else 0.0}, 5)

    return [
        ("reference: 0.2 m/s", True, base, 0, None),
        ("grazing, 5 mm/s", True, window(0.005), 0, lambda s, of: s["impacts"][0]["restitution"] > 0.95),
        ("pulse x 1.4: two impacts, uplift", True, (PULSE, ["excitation.scale=1.4"]), 0, impacts(2)),
        ("1.5 m/s", True, window(1.5), 0, impacts(1)),
        ("repeated on the yielded rim, mu 0", True,
         free((0.39, 0), (0.5, 0), 6, "reduced.mu_fast=0", "reduced.mu_slow=0"), 0, impacts(3)),
        ("oblique, 31 degrees", True, free((0.39, 0), (0.4, 0.24), 0.3), 0, impacts(1)),
        ("uplift and re-contact, W / 20", True, window(0.6, 'excitation.with=["weight"]', "load.vertical_kN=43", "load.mass_kg=86952"), 0, impacts(1)),
        ("mu 0, weight", True, window(0.2, WEIGHT, "reduced.mu_fast=0", "reduced.mu_slow=0"), 0, impacts(1)),
        ("mu 0.3, weight", True, window(0.2, WEIGHT, "reduced.mu_fast=0.3", "reduced.mu_slow=0.3"), 0, impacts(1)),
        ("yield 100 MPa", True, window(0.2, "bearing.material.steel.yield_MPa=100"), 0, impacts(1)),
        ("yield 1000 MPa", True, window(0.2, "bearing.material.steel.yield_MPa=1000"), 0, impacts(1)),
        ("no hardening", True, window(0.2, "bearing.material.steel.tangent_modulus_MPa=0"), 0, impacts(1)),
        ("negative tangent modulus", True, window(0.2, "bearing.material.steel.tangent_modulus_MPa=-10"), 2, "must be >= 0"),
        ("rim 10 mm thick", True, window(0.2, "bearing.rim.thickness_mm=10"), 0, impacts(1)),
        ("rim 100 mm thick", True, window(0.2, "bearing.rim.thickness_mm=100"), 0, impacts(1)),
        ("penalty x 0.01", True, window(0.2, "model.penalty_scale=0.01"), 0, close_to("reference: 0.2 m/s", close)),
        ("penalty x 0.1", True, window(0.2, "model.penalty_scale=0.1"), 0, close_to("reference: 0.2 m/s", close)),
        ("penalty x 100", True, window(0.2, "model.penalty_scale=100"), 0, close_to("reference: 0.2 m/s", close)),
        ("friction of the walls 0.1, oblique", True, free((0.39, 0), (0.4, 0.24), 0.3, "bearing.contact.rim=0.1"), 0, impacts(1)),
        ("friction of the walls 0.3, oblique", True, free((0.39, 0), (0.4, 0.24), 0.3, "bearing.contact.rim=0.3"), 0, impacts(1)),
        ("rho_inf 0", True, window(0.2, "model.rho_inf=0"), 0, close_to("reference: 0.2 m/s", 0.01)),
        ("rho_inf 1", True, window(0.2, "model.rho_inf=1"), 0, close_to("reference: 0.2 m/s", 0.01)),
        ("inner nodes 30 % off, aspect 73", True, window(0.2, *skewed(program, folder / "skewed.msh", 0.3)), 0,
         close_to("reference: 0.2 m/s", 0.01)),
        ("steps x 10", False, window(0.2, "model.step_ms=10"), 0, close_to("reference: 0.2 m/s", 0.05)),
        ("zero vertical load, weight on", True, window(0.2, WEIGHT, "load.vertical_kN=0"), 0, close_to("reference: 0.2 m/s", 0.02)),
        ("a spike of 1 g for 50 ms", True, spike, 0, None),
        ("1.3 g upwards, 0.7 m/s", True, lifted(0.3, 1.5), 0, impacts(1)),
        # ploughs 110 mm into the rim while it rises, and is thrown over it: the dish ends there, and so does the run
        ("1.3 g upwards, 2.5 m/s in flight", False, lifted(0.9, 1.6), 4, None),
        ("100 s of tiny shaking", True, tiny, 0, lambda s, of: s["peak_displacement_m"] < 1e-3),
        ("initial overlap 0.5 mm", True, free((0.4005, 0), (0, 0), 0.3), 2, "beyond the rim"),
    ]


MESH = 1
NOTES = """# Elsewhere: resumed in mid-impact to the last bit (tests/fe_contact/test_restart.cc, app_fe_run), ranks
# (tests/fe_contact/test_ranks.cc, app_dish_ranks). Not in this rung: the pad (Poisson 0.499).
"""
