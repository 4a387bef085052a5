"""Hard cases of rung rigid-dish with a slider between two dishes, on the draft mesh where a row does not say otherwise: name, must be
right, (scene, settings), expected exit code, check of the summary or words of the sentence."""
from cases_double_concave import BEARING, friction, of_shape_and_solver
from checks import close_to, impacts

BASE, FINER = "reference: 0.2 m/s", "reference, mesh 1: 0.2 m/s"
ON_MESH_1 = ["model.mesh=1"]
ON_THE_DISH = ['excitation.with=["weight","friction"]', "excitation.duration_s=0.09"]


def window(speed, *more):
    return "impact-window", [*BEARING, f"excitation.speed_m_per_s={speed}", *ON_THE_DISH, *more]


def halves(speed, *more):
    return window(speed, "bearing.slider.mu_interface=0.15", *more)


def pulse(scene, scale, *more):
    return scene, [*BEARING, f"excitation.scale={scale}", *more]


def of_shape_and_solver_by_mesh():
    """A row that the draft mesh stops at has one on mesh 1 beside it, which must be right."""
    stopped_on_draft = {"edge rounded by 0.5 mm", "a ledge of 10 mm", "penalty x 0.1"}
    rows = of_shape_and_solver(window)
    assert stopped_on_draft <= {name for name, *_ in rows}
    for name, starred, (scene, settings), expected, check in rows:
        if name not in stopped_on_draft:
            yield name, starred, (scene, settings), expected, check
            continue
        yield name, False, (scene, settings), 4, "unaccounted for"
        yield f"{name}, mesh 1", True, (scene, [*settings, *ON_MESH_1]), expected, close_to(FINER, 0.02) if name.startswith("penalty") else check


def cases(program, folder):
    return [
        (BASE, True, window(0.2), 0, impacts(1)),
        (FINER, True, window(0.2, *ON_MESH_1), 0, impacts(1)),
        ("grazing, 5 mm/s", True, window(0.005), 0, lambda s, of: s["peak_impact_force_N"] > 0),
        ("0.6 m/s", True, window(0.6), 0, impacts(1)),
        # its rims of 20 mm are folded over
        ("1.0 m/s", False, window(1.0), 0, impacts(1)),
        ("1.5 m/s, rims 60 mm thick", False, window(1.5, "bearing.rim.thickness_mm=60"), 0, impacts(1)),
        ("from the other side", True, window(0.2, "excitation.direction_deg=180"), 0, close_to(BASE, 2e-3)),
        ("at 31 degrees, whole", True, window(0.2, "excitation.direction_deg=31"), 0, close_to(BASE, 0.02)),
        ("oblique: bidirectional pulse x 0.7", True, pulse("pulse-bidirectional", 0.7, "excitation.duration_s=3.9"), 0, impacts(1)),
        ("pulse x 1.0", True, pulse("ricker-0.78g-1.0s", 1.0, "excitation.duration_s=4"), 0, impacts(1)),
        # from side to side: the third is on the dent of the first
        ("hits on the dent: pulse x 0.9, mu 0", True, pulse("ricker-0.78g-1.0s", 0.9, "excitation.duration_s=6.3", *friction(0)), 0, impacts(3)),
        ("mu 0", True, window(0.2, *friction(0)), 0, impacts(1)),
        ("mu 0.2", True, window(0.2, *friction(0.2)), 0, impacts(1)),
        ("friction of the walls 0.2", True, window(0.2, "bearing.contact.rim=0.2"), 0, impacts(1)),
        ("uplift, W / 20", True, window(0.4, "load.vertical_kN=43", "load.mass_kg=86952"), 0, impacts(1)),
        *of_shape_and_solver_by_mesh(),
        # the rims hold the halves of the slider, which slide on one another: the force is mu_s's and not the rim's
        ("interface slides during the hit", True, halves(0.2), 0,
         lambda s, of: 0.1 < s["peak_impact_force_N"] / of(BASE)["peak_impact_force_N"] < 0.2),
        ("interface slides, at 31 degrees, whole", True, halves(0.2, "excitation.direction_deg=31"), 0, close_to("interface slides during the hit", 0.02)),
        ("interface that holds, mu_s 2", True, halves(0.2, "bearing.slider.mu_interface=2"), 0, close_to(BASE, 0.02)),
        ("interface on to its stop, 4 mm", True, halves(0.2, "bearing.slider.interface_gap_mm=4"), 4, "to their stop"),
        ("zero vertical load", True, window(0.2, "load.vertical_kN=0"), 2, "load.vertical_kN 0"),
        ("terms of a socket", True, window(0.2, "reduced.socket_friction=true"), 2, "reduced.socket_friction"),
    ]


MESH = 0
NOTES = """# Where the draft mesh stops, an edge bears on a few points of cells that are larger than it, we think; shorter steps do not
# help, mesh 1 does.
# At 1.5 m/s the slider climbs its rims and leaves the dishes; we think that what the faces then give up is not accounted for.
# Both rims are touched at once by the symmetry that this model takes; one after the other, and a slider that leans at the start,
# are not in it.
"""
