"""What OpenSees has of exported files, row by row, beside the export's own check, the reduced model and kept finite elements."""
import json
import math
import pathlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import flights
from command import rimpact
from exported import ELEMENT, calibration, write
from exported_there import Export, PythonFile, TclFile
from flights import Hit

REFERENCES = pathlib.Path(__file__).parents[2] / "data/references"
STACK = {"finite_pad": True, "socket_friction": True, "friction": "park-wen", "elastic_slip_mm": 0.18, "elastic_slip_from": "fit"}
PAIR = {"k_i": {"value": 450000, "unit": "kN/m"}, "e": {"value": 0.5, "unit": "-"}}
LAWS: dict[str, dict[str, Any]] = {
    "elastoplastic": {},
    "bilinear": {"k_i": {"value": 1.0e6, "unit": "kN/m"}, "yield_force": {"value": 600, "unit": "kN"}, "hardening": {"value": 0.15, "unit": "-"}},
    "signed": PAIR, "no-tension": PAIR, "hunt-crossley": {**PAIR, "exponent": {"value": 1.5, "unit": "-"}}}
SAMPLE = 1e-3  # of ground motions [s]
JOINT = flights.ANCHOR + 7


def of_law(law: str, identity: str) -> dict[str, Any]:
    """A calibration whose answer is this law; the elastoplastic one has the numbers of data/references/elastoplastic.json."""
    content = calibration(identity=identity, name=law, element={**ELEMENT, **LAWS[law]}, belongs_to="rim" if "yield_force" in LAWS[law] or not LAWS[law] else "mass",
                          mass_kg=86952.0)
    content["answer"]["stack"] = STACK
    return content


def export(folder: str, content: dict[str, Any], scene: str = "shfps-225", *options: str) -> dict[str, Any]:
    write(folder, content)
    run = rimpact("export", folder, "--opensees", "--json", "--quiet", "--scene", scene, *options)
    assert run.returncode == 0, run.stderr
    return dict(json.loads(run.stdout))


def thrown(file: Export, law: str, speed: float, contact_time: float) -> list[Hit]:
    """Two hits on the springs along x."""
    joint = (JOINT,) if law == "no-tension" else ()
    return flights.windows(file, speed, contact_time, hits=2, more=joint)


@dataclass
class Spring:
    """One hit on the springs of a law: OpenSees against the export's own integrator, and the law."""
    law: str
    speed: float
    hit: int
    there: Hit
    own: dict[str, float]
    of_law: dict[str, float]

    def over(self, side: dict[str, float]) -> tuple[float, float, float]:
        """Peak force and depth over it less one, rebound less it."""
        return self.there.peak / 1e3 / side["peak_force_kN"] - 1, 1e3 * self.there.depth / side["penetration_mm"] - 1, self.there.ratio - side["rebound"]


def springs(law: str, folder: str, table: dict[str, Any]) -> Iterator[Spring]:
    """By the Python file, after the Tcl one has been found to do the same."""
    check = table["self_checks"][0]
    again = check["second_hits"] or [None] * len(check["rows"])
    python, tcl = PythonFile(pathlib.Path(folder, "impact.py")), TclFile(pathlib.Path(folder, "impact.tcl"))
    for row, second in zip(check["rows"], again):
        hits, same = (thrown(file, law, row["speed_m_s"], row["spring"]["contact_time_ms"] / 1e3) for file in (python, tcl))
        for a, b in zip(hits, same):
            assert math.isclose(a.peak, b.peak, rel_tol=1e-6) and math.isclose(a.rebound, b.rebound, rel_tol=1e-6), (law, a, b)
        for number, hit in enumerate(hits):
            of = second if number and second else row
            yield Spring(law, row["speed_m_s"], number + 1, hit, of["spring"], of["law"])
    tcl.close()


def ricker(pulse: str, scale: float, gravity: float = 9.81) -> tuple[list[float], float]:
    """Ground acceleration of a pulse of the catalogue, sampled, and its duration [s]."""
    g, period = (float(part.rstrip("gs")) for part in pulse.split("-")[1:])
    duration = 2 * period + 3
    squares = [(math.pi * (i * SAMPLE - 2 * period) / period) ** 2 for i in range(round(duration / SAMPLE) + 3)]
    return [g * gravity * scale * (1 - 2 * q) * math.exp(-q) for q in squares], duration


def velocity_pulse(amplitude: float, frequency: float, cycles: float, centre: float) -> list[float]:
    """Mavroeidis and Papageorgiou (2003), a sine under a bell: the built-in near-fault records, differentiated by hand."""
    found = []
    for i in range(6001):
        tau, w = i * SAMPLE - centre, 2 * math.pi * frequency
        inside = abs(tau) < cycles / (2 * frequency)
        found.append(amplitude / 2 * (w / cycles * math.sin(w * tau / cycles) * math.sin(w * tau)
                                      - (1 + math.cos(w * tau / cycles)) * w * math.cos(w * tau)) if inside else 0.0)
    return found


@dataclass
class Motion:
    """One motion of the whole bearing: touch [m/s], peak [kN], work on the rim [J]; sides by name, what one does not say is None."""
    name: str
    there: Hit
    sides: dict[str, dict[str, float | None]]

    def over(self, side: str) -> tuple[float | None, ...]:
        """Touch and peak over it less one, rebound less it, work over it less one."""
        of = self.sides.get(side, {})
        pairs = ((self.there.approach, of.get("touch")), (self.there.peak / 1e3, of.get("peak")), (self.there.ratio, of.get("rebound")), (self.there.taken, of.get("taken")))
        return tuple(None if not value else mine - value if i == 2 else mine / value - 1 for i, (mine, value) in enumerate(pairs))


def summary_side(summary: dict[str, Any], taken: bool = True) -> dict[str, float | None]:
    first = summary["impacts"][0]
    return {"touch": first["approach_speed_m_s"], "peak": first["peak_force_N"] / 1e3, "rebound": first["restitution"],
            "taken": summary["energy"]["impact_J"] if taken and len(summary["impacts"]) == 1 else None}


def reference(name: str) -> dict[str, float | None]:
    return summary_side(json.loads((REFERENCES / name / "summary.json").read_text()), taken=False)


def reduced(folder: str, scene: str, *settings: str) -> dict[str, float | None]:
    out = pathlib.Path(folder, "model")
    run = rimpact("reduced", scene, "--calibration", folder, "-o", str(out), "--quiet", "--force", *(word for setting in settings for word in ("--set", setting)))
    assert run.returncode == 0, run.stderr
    return summary_side(json.loads((out / "summary.json").read_text()))


def windows(folder: str, file: Export, speeds: Sequence[str]) -> Iterator[Motion]:
    for speed in speeds:
        found = reference(f"window-{speed}")
        model = reduced(folder, str(REFERENCES / f"window-{speed}/scene.toml"))
        yield Motion(f"window {speed} m/s", flights.throw(file, float(found["touch"] or 0)), {"model": model, "fe": found})


KEPT = {("ricker-0.78g-1.0s", 1.05): "pulse-0.78g-1.05", ("ricker-0.78g-1.0s", 1.1): "pulse-0.78g-1.10", ("ricker-0.38g-1.5s", 1.05): "pulse-0.38g-1.05"}


def pulses(folder: str, file: Export, table: dict[str, Any], scene: str = "shfps-225") -> Iterator[Motion]:
    """Those of the self-check that meet the rim, with kept runs of the built-in bearing."""
    for row in table["self_checks"][0]["pulses"]["rows"]:
        if not row["model"]["touch_speed_m_s"] or row["model"]["touch_speed_m_s"] < 0.1:
            continue
        x, duration = ricker(row["pulse"], row["scale"])
        ground = {1: x}
        if row["vertical_g"]:
            ground[3] = [row["vertical_g"] * 9.81 * math.sin(2 * math.pi * 3 * i * SAMPLE) for i in range(len(x))]
        sides = {side: {"touch": row[name]["touch_speed_m_s"], "peak": row[name]["peak_force_kN"]} for side, name in (("own", "exported"), ("model", "model"))}
        if not row["vertical_g"]:
            sides["model"] = reduced(folder, row["pulse"], f"excitation.scale={row['scale']}", *(() if scene == "shfps-225" else (f"bearing.name={scene}",)))
            if kept := KEPT.get((row["pulse"], round(row["scale"], 3))):
                sides["fe"] = reference(kept)
        hits = flights.fly(file, ground, SAMPLE, duration).hits
        yield Motion(row["name"], max(hits, key=lambda hit: hit.peak) if hits else Hit(1e-9), sides)


def near_fault(folder: str, file: Export) -> Motion:
    """The built-in record in two directions; the first touch."""
    ground = {1: velocity_pulse(0.90, 0.5, 1.6, 3.0), 2: velocity_pulse(0.36, 0.6, 1.5, 3.2)}
    first = flights.fly(file, ground, SAMPLE, 4.2).hits[0]
    return Motion("near-fault, two directions", first, {"model": reduced(folder, "pulse-bidirectional"), "fe": reference("pulse-bidirectional")})
