"""Hard cases of rung rim with a slider between two dishes: name, must be right, (scene, settings), expected
exit code, check of the summary."""
from cases_rim import WEIGHT
from checks import close_to, impacts

BASE = "reference: 0.2 m/s"
BEARING = ["bearing.name=dcfp-155"]


def window(speed, *more):
    return "impact-window", [*BEARING, f"excitation.speed_m_per_s={speed}", *more]


def free(u, v, seconds, *more):
    return "impact-window", [*BEARING, 'excitation.kind="free"', f"excitation.displacement_m={list(u)}",
                             f"excitation.velocity_m_per_s={list(v)}", f"excitation.duration_s={seconds}", *more]


def friction(mu):
    return [f"reduced.mu_fast={mu}", f"reduced.mu_slow={mu}", f"bearing.contact.steel_ertalyte={mu}"]


def of_shape_and_solver(window):
    """Cases of the slider's edge, the rim, and what the solver may choose, by either rung's window."""
    return [
        ("edge rounded by 0.5 mm", True, window(0.2, "bearing.slider.edge_radius_mm=0.5"), 0, impacts(1)),
        ("edge rounded by 6 mm", True, window(0.2, "bearing.slider.edge_radius_mm=6"), 0, impacts(1)),
        ("a ledge of 10 mm", True, window(0.2, "bearing.rim.ledge_mm=10"), 0, impacts(1)),
        ("rim 60 mm thick", True, window(0.2, "bearing.rim.thickness_mm=60"), 0, impacts(1)),
        ("penalty x 0.1", True, window(0.2, "model.penalty_scale=0.1"), 0, close_to(BASE, 0.02)),
        ("penalty x 10", True, window(0.2, "model.penalty_scale=10"), 0, close_to(BASE, 0.02)),
        ("rho_inf 1", True, window(0.2, "model.rho_inf=1"), 0, close_to(BASE, 0.02)),
    ]


def of_shape_and_solver_by_mesh():
    """An edge of 0.5 mm has one on mesh 2 beside it."""
    sharp = "edge rounded by 0.5 mm"
    for name, starred, (scene, settings), expected, check in of_shape_and_solver(window):
        yield name, starred and name != sharp, (scene, settings), expected, check
        if name == sharp:
            yield f"{name}, mesh 2", False, (scene, [*settings, "model.mesh=2"]), expected, check


def cases(program, folder):
    return [
        (BASE, True, window(0.2), 0, impacts(1)),
        ("grazing, 5 mm/s", True, window(0.005), 0, impacts(1)),
        ("0.6 m/s", True, window(0.6), 0, impacts(1)),
        # its rims of 20 mm are folded over
        ("1.0 m/s", False, window(1.0), 4, "moved past the faces opposite"),
        ("1.5 m/s, rims 60 mm thick", True, window(1.5, "bearing.rim.thickness_mm=60"), 0, impacts(1)),
        ("oblique, 31 degrees", True, free((0.29, 0), (0.4, 0.24), 0.3), 0, impacts(1)),
        ("repeated on the yielded rims, mu 0", True, free((0.29, 0), (0.4, 0), 6, *friction(0)), 0, impacts(2)),
        ("mu 0, weight", True, window(0.2, WEIGHT, *friction(0)), 0, impacts(1)),
        ("mu 0.2, weight", True, window(0.2, WEIGHT, *friction(0.2)), 0, impacts(1)),
        ("friction of the walls 0.2", True, window(0.2, "bearing.contact.rim=0.2"), 0, impacts(1)),
        ("uplift, W / 20", True, window(0.4, 'excitation.with=["weight"]', "load.vertical_kN=43", "load.mass_kg=86952"), 0, impacts(1)),
        *of_shape_and_solver_by_mesh(),
        ("terms of a pad", True, window(0.2, "reduced.finite_pad=true"), 2, "reduced.finite_pad"),
    ]


MESH = 1
NOTES = """# Both rims are touched at once by the symmetry that this model takes; one after the other, a tilt at the start and a sliding
# interface are not in it (rigid bodies have the first: tests/reduced_models/rims_in_turn.txt).
# With an edge of 0.5 mm more energy is unaccounted for than 1e-3, on mesh 1 and on mesh 2: not met, for an unknown reason.
# At 1.0 m/s the rims of 20 mm are folded over, and the run stops with a sentence.
"""
